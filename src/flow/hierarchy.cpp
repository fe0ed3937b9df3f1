// SPDX-License-Identifier: MPL-2.0
#include "flow/hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "flow/rigid_spheres.hpp"
#include "flow/smoother.hpp"

namespace porefines::flow {

namespace {

constexpr int sweeps_per_side = 2;
constexpr int coarsest_sweeps = 20;

std::array<std::vector<Real>, 3> fine_widths(const Int3& cells, const Vec3& spacing) {
  std::array<std::vector<Real>, 3> w;
  for (int a = 0; a < 3; ++a) {
    w[a].assign(static_cast<std::size_t>(cells[a]), spacing[a]);
  }
  return w;
}

/// Which axes to halve: those of short cells, until cells are nearly cubic; then all. Point smoothers
/// see nothing of errors that vary along long cells only.
std::array<bool, 3> axes_to_halve(const std::array<std::vector<Real>, 3>& widths) {
  constexpr Real nearly = 1.5;
  Real shortest = INFINITY;
  for (const std::vector<Real>& w : widths) {
    shortest = w.size() > 1 ? std::min(shortest, w.front()) : shortest;
  }
  std::array<bool, 3> halves{};
  for (int a = 0; a < 3; ++a) {
    halves[a] = widths[a].size() > 1 && widths[a].front() < nearly * shortest;
  }
  return halves;
}

std::array<std::vector<Real>, 3> halved(const std::array<std::vector<Real>, 3>& fine,
                                        const std::array<bool, 3>& halves) {
  std::array<std::vector<Real>, 3> coarse = fine;
  for (int a = 0; a < 3; ++a) {
    const std::size_t n = fine[a].size();
    if (!halves[a]) {
      continue;
    }
    coarse[a].assign((n + 1) / 2, 0);
    for (std::size_t i = 0; i < n; ++i) {
      coarse[a][i / 2] += fine[a][i];
    }
  }
  return coarse;
}

par::Decomposition whole(const Int3& cells) {
  par::Decomposition d;
  d.cells = cells;
  for (int a = 0; a < 3; ++a) {
    d.cuts[a] = {0, cells[a]};
  }
  return d;
}

/// May the level below stay spread over the ranks? Its cuts must fall on even cells, and its blocks
/// must hold their ghosts.
bool can_stay_distributed(const par::Decomposition& fine, const par::Decomposition& coarse) {
  if (fine.alignment < 4 || product(coarse.cells) <= Hierarchy::replicate_below) {
    return false;
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; coarse.ranks[a] > 1 && b < coarse.ranks[a]; ++b) {
      if (coarse.cuts[a][b + 1] - coarse.cuts[a][b] < sweep_depth + 1) {
        return false;
      }
    }
  }
  return true;
}

/// d = (1 + sum e M_nb) / M: then A M = 1 holds on the coarse level too.
void homogenise(Level& level) {
  const std::array<float*, 3> fields{level.mobility[0].data(), level.mobility[1].data(),
                                     level.mobility[2].data()};
  level.halo.exchange(fields, 1);
  const grid::Block& b = level.block;
  for (int c = 0; c < 3; ++c) {
    const float* m = level.mobility[c].data();
    float* inverse = level.inverse_diagonal[c].data();
    for (int k = 0; k <= b.n[2]; ++k) {
      for (int j = 0; j <= b.n[1]; ++j) {
        for (int i = 0; i <= b.n[0]; ++i) {
          const std::ptrdiff_t at = b.at(i, j, k);
          if (m[at] <= 0) {
            continue;
          }
          const Int3 index{i, j, k};
          float neighbours = 0;
          for (int t = 0; t < 3; ++t) {
            const auto& axis = level.axis[t];
            const std::size_t here = index[t] + axis.offset;
            const std::ptrdiff_t s = b.stride(t);
            neighbours += t == c
                              ? axis.face_low[here] * m[at - s] + axis.face_high[here] * m[at + s]
                              : axis.cell_low[here] * m[at - s] + axis.cell_high[here] * m[at + s];
          }
          inverse[at] = m[at] / (1 + neighbours);
        }
      }
    }
  }
  const std::array<float*, 3> inverses{level.inverse_diagonal[0].data(),
                                       level.inverse_diagonal[1].data(),
                                       level.inverse_diagonal[2].data()};
  level.halo.exchange(inverses, sweep_depth);
  level.halo.exchange(fields, sweep_depth);
  finish_level(level);
}

/// Sum of a component over the faces that this rank owns.
Real owned_sum(const Level& level, int component) {
  const grid::Block& b = level.block;
  Real sum = 0;
  for (int k = 0; k < b.n[2]; ++k) {
    for (int j = 0; j < b.n[1]; ++j) {
      const float* row = level.u[component].data() + b.at(0, j, k);
      float row_sum = 0;
      for (int i = 0; i < b.n[0]; ++i) {
        row_sum += row[i];
      }
      sum += row_sum;
    }
  }
  return sum;
}

}  // namespace

Hierarchy::Hierarchy(const par::Communicator& comm, const par::Decomposition& cut,
                     const Vec3& spacing, const Boundaries& boundaries)
    : comm_(comm), boundaries_(boundaries) {
  levels_.emplace_back(comm, cut, fine_widths(cut.cells, spacing), boundaries, sweep_depth, true);
  levels_.front().replicated = comm.size() == 1;
}

void Hierarchy::build() {
  transfers_.clear();
  levels_.erase(levels_.begin() + 1, levels_.end());
  for (Floats& field : finest().mobility) {
    field.assign(finest().block.size, 0.0F);
  }
  solve_mobility();
  while (add_coarse_level()) {
  }
  for (Level& level : levels_) {  // carry is what the cycle needs
    for (Floats& field : level.mobility) {
      field = Floats();  // "= {}" would keep the memory
    }
  }
}

/// A M = W per component, by batches of over-relaxed sweeps until a batch changes the mean by little.
/// Wide pores need more sweeps and more over-relaxation, so both grow as long as M does.
void Hierarchy::solve_mobility() {
  constexpr int batch = 8;
  constexpr int most_batches = 24;
  constexpr Real little = 0.05;
  Level& fine = finest();
  mobility_sweeps_ = 0;
  for (int c = 0; c < 3; ++c) {
    fine.f[c] = fine.weight[c];
    std::fill(fine.u[c].begin(), fine.u[c].end(), 0.0F);
    Real before = 0;
    for (int b = 0; b < most_batches; ++b) {
      relax_mobility(fine, c, batch, std::min(1.5F + 0.1F * static_cast<float>(b), 1.9F));
      mobility_sweeps_ += batch;
      const Real total = comm_.sum(owned_sum(fine, c));
      if (total - before < little * total) {
        break;
      }
      before = total;
    }
    std::fill(fine.f[c].begin(), fine.f[c].end(), 0.0F);
    // Over-relaxation may leave a face below what it would have all alone.
    for (std::size_t at = 0; at < fine.block.size; ++at) {
      const float alone = fine.weight[c][at] * fine.inverse_diagonal[c][at];
      fine.mobility[c][at] = std::max(fine.u[c][at], alone / 2);
    }
  }
  const std::array<float*, 3> fields{fine.mobility[0].data(), fine.mobility[1].data(),
                                     fine.mobility[2].data()};
  fine.halo.exchange(fields, sweep_depth);
}

bool Hierarchy::add_coarse_level() {
  Level& fine = levels_.back();
  if (product(fine.block.global) == 1) {
    return false;
  }
  const std::array<bool, 3> halves = axes_to_halve(fine.widths);
  const par::Decomposition coarse_cut = fine.decomposition.coarsened(halves);
  const bool replicated = fine.replicated || !can_stay_distributed(fine.decomposition, coarse_cut);
  const par::Communicator group = replicated ? par::Communicator::self() : comm_;
  levels_.emplace_back(group, replicated ? whole(coarse_cut.cells) : coarse_cut,
                       halved(fine.widths, halves), boundaries_, sweep_depth, false);
  Level& coarse = levels_.back();
  coarse.replicated = replicated;
  transfers_.emplace_back(comm_, fine, coarse, boundaries_);
  transfers_.back().restrict_mobility(fine, coarse);
  homogenise(coarse);
  transfers_.back().share_flux(fine);
  return true;
}

std::size_t Hierarchy::bytes() const {
  std::size_t total = 0;
  for (const Level& level : levels_) {
    total += level.bytes();
  }
  return total;
}

namespace {

void smooth(Level& level, int count, bool reversed, bool from_zero, RigidSpheres* spheres) {
  for (int s = 0; s < count; ++s) {
    sweep(level, reversed, from_zero && s == 0);
    if (spheres != nullptr) {
      spheres->update();
    }
  }
}

void clear_unknowns(Level& level) {
  for (Floats& field : level.u) {
    std::fill(field.begin(), field.end(), 0.0F);
  }
  std::fill(level.p.begin(), level.p.end(), 0.0F);
}

/// @param load_sides  of the finest level, as for cycle()
/// @param spheres     of the finest level; nullptr below it
void visit(Hierarchy& hierarchy, int l, bool from_zero, int visits,
           const std::function<void()>& load_sides, RigidSpheres* spheres) {
  Level& level = hierarchy.level(l);
  if (from_zero) {
    clear_unknowns(level);
    level.exchange_sides(sweep_depth);
  }
  if (l + 1 == hierarchy.size()) {
    smooth(level, coarsest_sweeps, false, from_zero, spheres);
    return;
  }
  smooth(level, sweeps_per_side, false, from_zero, spheres);
  find_residual(level);
  if (spheres != nullptr) {
    spheres->spread_residual();
  }
  hierarchy.transfer(l).restrict_residual(level, hierarchy.level(l + 1));
  if (level.lends_sides) {
    load_sides();
    level.exchange_sides(sweep_depth);
  }
  for (int v = 0; v < visits; ++v) {
    visit(hierarchy, l + 1, v == 0, visits, {}, nullptr);
  }
  hierarchy.transfer(l).prolong(hierarchy.level(l + 1), level);
  if (spheres != nullptr) {
    spheres->take_correction();
  }
  smooth(level, sweeps_per_side, true, false, spheres);
}

}  // namespace

void cycle(Hierarchy& hierarchy, const std::function<void()>& load_sides, RigidSpheres* spheres,
           int visits) {
  hierarchy.finest().lend_sides(hierarchy.finest().replicated && spheres == nullptr);
  load_sides();
  if (spheres != nullptr) {
    spheres->rest();
  }
  visit(hierarchy, 0, true, visits, load_sides, spheres);
}

void smooth_finest(Hierarchy& hierarchy, RigidSpheres* spheres, int count) {
  smooth(hierarchy.finest(), count, false, false, spheres);
}

}  // namespace porefines::flow
