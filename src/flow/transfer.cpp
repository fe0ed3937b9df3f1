// SPDX-License-Identifier: MPL-2.0
#include "flow/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace porefines::flow {

namespace {

/// Fine rows (or planes) that feed a coarse one, or coarse ones that feed a fine one.
struct Sources {
  int count = 0;
  std::array<int, 3> index{};
  std::array<float, 3> weight{};
  void add(int i, float w) {
    if (w != 0) {
      index[count] = i;
      weight[count++] = w;
    }
  }
};

/// Fine indices along an axis whose values make coarse index I.
Sources restriction_sources(const AxisTransfer& t, int I, bool normal, int fine_cells) {
  Sources s;
  if (!normal) {
    s.add(2 * I, t.cell_first[I]);
    s.add(2 * I + 1, t.cell_second[I]);
    return s;
  }
  const int middle = std::min(2 * I, fine_cells);  // an odd last block ends at an odd face
  s.add(middle - 1, t.face_before[I]);
  s.add(middle, t.face_middle[I]);
  s.add(middle + 1, t.face_after[I]);
  return s;
}

/// Coarse indices along an axis that make fine index i.
Sources prolongation_sources(const AxisTransfer& t, int i, bool normal) {
  Sources s;
  const int I = i / 2;
  if (!normal || i % 2 == 0) {
    s.add(I, 1.0F);
  } else {
    s.add(I, t.odd_low[I]);
    s.add(I + 1, t.odd_high[I]);
  }
  return s;
}

int coarse_count(const grid::Block& fine, int axis, bool faces) {
  return (fine.n[axis] + 1) / 2 + (faces && fine.owns_end[axis] ? 1 : 0);
}

int fine_count(const grid::Block& fine, int axis, bool faces) {
  return fine.n[axis] + (faces && fine.owns_end[axis] ? 1 : 0);
}

/// Row of sums over source rows: row[i] = sum w field(i, j, k), for local x index i in [first, last).
void combine(const grid::Block& b, const Floats& field, const Sources& rows, const Sources& planes,
             const Int3& offset, int first, int last, float* row) {
  std::fill(row + first, row + last, 0.0F);
  for (int kk = 0; kk < planes.count; ++kk) {
    for (int jj = 0; jj < rows.count; ++jj) {
      const float w = rows.weight[jj] * planes.weight[kk];
      const float* from =
          field.data() + b.at(offset[0], rows.index[jj] + offset[1], planes.index[kk] + offset[2]);
#pragma omp simd
      for (int i = first; i < last; ++i) {
        row[i] += w * from[i];
      }
    }
  }
}

/// Geometric mean of the arithmetic and the harmonic mean of the middle and the outer planes of a
/// control volume, given their shares of the arithmetic mean and the weight of the middle.
/// Closed in the middle: 0, for such a face would lead into cells that are all grain. Closed, or
/// absent, on both outer sides: the middle alone resists.
float mean_along(float middle, float outer, float weight) {
  if (middle <= 0) {
    return 0;
  }
  const float rest = 1 - weight;
  const float resistance = weight * weight / middle + (outer > 0 ? rest * rest / outer : 0);
  const float harmonic = outer > 0 ? 1 / resistance : middle / weight;
  return std::sqrt((middle + outer) * harmonic);
}

}  // namespace

Transfer::Transfer(const par::Communicator& comm, const Level& fine, const Level& coarse,
                   const Boundaries& boundaries)
    : comm_(comm.handle()), rank_(comm.rank()) {
  for (int a = 0; a < 3; ++a) {
    axis_[a] = make_transfer(fine.block, a, fine.widths[a], coarse.widths[a], boundaries);
    offset_[a] = fine.block.start[a] / 2 - coarse.block.start[a];
  }
  if (!coarse.replicated || fine.replicated || comm.size() == 1) {
    return;
  }
  const par::Decomposition cut = fine.decomposition.coarsened();
  for (int r = 0; r < comm.size(); ++r) {
    Part part{cut.start(r), cut.start(r)};
    for (int a = 0; a < 3; ++a) {
      part.last[a] += cut.extent(r)[a];
      part.last[a] += coarse.block.owns_end[a] && part.last[a] == cut.cells[a] ? 1 : 0;
    }
    parts_.push_back(part);
  }
}

void Transfer::restrict_faces(int component, const Floats& fine_field, const Level& fine,
                              Floats& out, const Level& coarse, Planes wanted) const {
  const grid::Block& f = fine.block;
  AxisTransfer chosen = axis_[component];
  const auto leave_out = [&](Planes plane, std::vector<float>& weights) {
    if (wanted != Planes::all && wanted != plane) {
      std::fill(weights.begin(), weights.end(), 0.0F);
    }
  };
  leave_out(Planes::before, chosen.face_before);
  leave_out(Planes::middle, chosen.face_middle);
  leave_out(Planes::after, chosen.face_after);
  const auto axis = [&](int a) -> const AxisTransfer& {
    return a == component ? chosen : axis_[a];
  };
  std::vector<float> buffer(static_cast<std::size_t>(f.n[0]) + 4, 0.0F);
  float* row = buffer.data() + 1;
  const int count = coarse_count(f, 0, component == 0);
  for (int K = 0; K < coarse_count(f, 2, component == 2); ++K) {
    const Sources planes = restriction_sources(axis(2), K, component == 2, f.n[2]);
    for (int J = 0; J < coarse_count(f, 1, component == 1); ++J) {
      const Sources rows = restriction_sources(axis(1), J, component == 1, f.n[1]);
      combine(f, fine_field, rows, planes, {0, 0, 0}, -1, f.n[0] + 2, row);
      float* to = out.data() + coarse.block.at(offset_[0], J + offset_[1], K + offset_[2]);
      const AxisTransfer& t = axis(0);
      if (component != 0) {
        for (int I = 0; I < count; ++I) {
          to[I] = t.cell_first[I] * row[2 * I] + t.cell_second[I] * row[2 * I + 1];
        }
        continue;
      }
      for (int I = 0; I < count; ++I) {
        const int middle = std::min(2 * I, f.n[0]);
        to[I] = t.face_before[I] * row[middle - 1] + t.face_middle[I] * row[middle] +
                t.face_after[I] * row[middle + 1];
      }
    }
  }
}

void Transfer::restrict_cells(const Level& fine, Level& coarse) const {
  const grid::Block& f = fine.block;
  std::vector<float> row(static_cast<std::size_t>(f.n[0]) + 2, 0.0F);
  for (int K = 0; K < coarse_count(f, 2, false); ++K) {
    const Sources planes = restriction_sources(axis_[2], K, false, f.n[2]);
    for (int J = 0; J < coarse_count(f, 1, false); ++J) {
      const Sources rows = restriction_sources(axis_[1], J, false, f.n[1]);
      combine(f, fine.rg, rows, planes, {0, 0, 0}, 0, f.n[0], row.data());
      float* to = coarse.g.data() + coarse.block.at(offset_[0], J + offset_[1], K + offset_[2]);
      for (int I = 0; I < coarse_count(f, 0, false); ++I) {
        to[I] = axis_[0].cell_first[I] * row[2 * I] + axis_[0].cell_second[I] * row[2 * I + 1];
      }
    }
  }
}

void Transfer::restrict_mobility(Level& fine, Level& coarse) const {
  for (int a = 0; a < 3; ++a) {
    for (std::size_t at = 0; at < fine.block.size; ++at) {
      fine.r[a][at] = fine.mobility[a][at] * (fine.weighted() ? fine.weight[a][at] : 1.0F);
    }
    restrict_faces(a, fine.r[a], fine, coarse.u[a], coarse, Planes::before);
    restrict_faces(a, fine.r[a], fine, coarse.f[a], coarse, Planes::middle);
    restrict_faces(a, fine.r[a], fine, coarse.r[a], coarse, Planes::after);
    std::transform(coarse.u[a].begin(), coarse.u[a].end(), coarse.r[a].begin(), coarse.u[a].begin(),
                   std::plus<>());  // both outer planes: half of the control volume
    const grid::Block& f = fine.block;
    for (int K = 0; K < coarse_count(f, 2, a == 2); ++K) {
      for (int J = 0; J < coarse_count(f, 1, a == 1); ++J) {
        for (int I = 0; I < coarse_count(f, 0, a == 0); ++I) {
          const std::ptrdiff_t at = coarse.block.at(I + offset_[0], J + offset_[1], K + offset_[2]);
          const float weight = axis_[a].face_middle[Int3{I, J, K}[a]];
          coarse.mobility[a][at] = mean_along(coarse.f[a][at], coarse.u[a][at], weight);
        }
      }
    }
  }
  gather({coarse.mobility[0].data(), coarse.mobility[1].data(), coarse.mobility[2].data()}, coarse);
}

void Transfer::link_levels(Level& fine, Level& coarse) const {
  const grid::Block& f = fine.block;
  for (int a = 0; a < 3; ++a) {
    fine.carry[a] = fine.mobility[a];
    const float* open = coarse.mobility[a].data();
    const std::ptrdiff_t next = coarse.block.stride(a);
    for (int k = 0; k < fine_count(f, 2, a == 2); ++k) {
      for (int j = 0; j < fine_count(f, 1, a == 1); ++j) {
        for (int i = 0; i < fine_count(f, 0, a == 0); ++i) {
          const Int3 index{i, j, k};
          const bool between = axis_[a].coarsened && index[a] % 2 == 1 && index[a] < f.n[a];
          const std::ptrdiff_t at =
              coarse.block.at(i / 2 + offset_[0], j / 2 + offset_[1], k / 2 + offset_[2]);
          if (between && (open[at] == 0) != (open[at + next] == 0)) {
            fine.carry[a][f.at(i, j, k)] *= 2;
          }
        }
      }
    }
    std::transform(coarse.mobility[a].begin(), coarse.mobility[a].end(),
                   coarse.inverse_mobility[a].begin(),
                   [](float m) { return m > 0 ? 1 / m : 0.0F; });
  }
  const std::array<float*, 3> fields{fine.carry[0].data(), fine.carry[1].data(),
                                     fine.carry[2].data()};
  fine.halo.exchange(fields, 1);
}

void Transfer::restrict_residual(const Level& fine, Level& coarse) const {
  for (int a = 0; a < 3; ++a) {
    restrict_faces(a, fine.r[a], fine, coarse.f[a], coarse, Planes::all);
  }
  restrict_cells(fine, coarse);
  gather({coarse.f[0].data(), coarse.f[1].data(), coarse.f[2].data(), coarse.g.data()}, coarse);
  for (int a = 0; a < 3; ++a) {
    const float* inverse = coarse.inverse_mobility[a].data();
    float* f = coarse.f[a].data();
    for (std::size_t at = 0; at < coarse.block.size; ++at) {
      f[at] *= inverse[at];
    }
  }
}

void Transfer::prolong(Level& coarse, Level& fine) const {
  coarse.exchange_unknowns(1);
  for (int a = 0; a < 3; ++a) {
    const float* inverse = coarse.inverse_mobility[a].data();
    const float* u = coarse.u[a].data();
    float* z = coarse.r[a].data();
    for (std::size_t at = 0; at < coarse.block.size; ++at) {
      z[at] = u[at] * inverse[at];
    }
    prolong_faces(a, coarse, fine);
  }
  prolong_cells(coarse, fine);
}

void Transfer::prolong_faces(int component, const Level& coarse, Level& fine) const {
  const grid::Block& f = fine.block;
  const int columns = fine_count(f, 0, component == 0);
  const int coarse_columns = (f.n[0] + 1) / 2 + 1;
  std::vector<float> coarse_row(static_cast<std::size_t>(coarse_columns) + 1, 0.0F);
  std::vector<float> buffer(static_cast<std::size_t>(f.sy) + 2 * grid::line_width, 0.0F);
  float* row = buffer.data() + f.ghost[0];
  for (int k = 0; k < fine_count(f, 2, component == 2); ++k) {
    const Sources planes = prolongation_sources(axis_[2], k, component == 2);
    for (int j = 0; j < fine_count(f, 1, component == 1); ++j) {
      const Sources rows = prolongation_sources(axis_[1], j, component == 1);
      combine(coarse.block, coarse.r[component], rows, planes, offset_, 0, coarse_columns,
              coarse_row.data());
      if (component == 0) {
        for (int i = 0; i < columns; i += 2) {
          row[i] = coarse_row[i / 2];
        }
        for (int i = 1; i < columns; i += 2) {
          row[i] = axis_[0].odd_low[i / 2] * coarse_row[i / 2] +
                   axis_[0].odd_high[i / 2] * coarse_row[i / 2 + 1];
        }
      } else {
        for (int i = 0; i < columns; ++i) {
          row[i] = coarse_row[i / 2];
        }
      }
      for_lines(fine, j, k, [&](int i) {
        float* u = fine.u[component].data() + f.at(i, j, k);
        const float* m = fine.carry[component].data() + f.at(i, j, k);
#pragma omp simd
        for (int l = 0; l < grid::line_width; ++l) {
          u[l] += m[l] * row[i + l];
        }
      });
    }
  }
}

void Transfer::prolong_cells(const Level& coarse, Level& fine) const {
  const grid::Block& f = fine.block;
  std::vector<float> buffer(static_cast<std::size_t>(f.sy) + 2 * grid::line_width, 0.0F);
  float* row = buffer.data() + f.ghost[0];
  for (int k = 0; k < f.n[2]; ++k) {
    for (int j = 0; j < f.n[1]; ++j) {
      const float* from =
          coarse.p.data() + coarse.block.at(offset_[0], j / 2 + offset_[1], k / 2 + offset_[2]);
      for (int i = 0; i < f.n[0]; ++i) {
        row[i] = from[i / 2];
      }
      for_lines(fine, j, k, [&](int i) {
        float* p = fine.p.data() + f.at(i, j, k);
        const float* push = fine.push.data() + f.at(i, j, k);
#pragma omp simd
        for (int l = 0; l < grid::line_width; ++l) {
          p[l] += push[l] != 0 ? row[i + l] : 0.0F;
        }
      });
    }
  }
}

void Transfer::gather(std::vector<float*> fields, const Level& coarse) const {
  if (parts_.empty()) {
    return;
  }
  const auto count = [&](const Part& p) {
    return static_cast<int>(fields.size()) * (p.last[0] - p.first[0]) * (p.last[1] - p.first[1]) *
           (p.last[2] - p.first[2]);
  };
  std::vector<int> counts;
  std::vector<int> starts{0};
  for (const Part& part : parts_) {
    counts.push_back(count(part));
    starts.push_back(starts.back() + counts.back());
  }
  std::vector<float> all(static_cast<std::size_t>(starts.back()));
  const auto visit = [&](const Part& part, const auto& row) {
    for (float* field : fields) {
      for (int k = part.first[2]; k < part.last[2]; ++k) {
        for (int j = part.first[1]; j < part.last[1]; ++j) {
          row(field + coarse.block.at(part.first[0], j, k), part.last[0] - part.first[0]);
        }
      }
    }
  };
  float* buffer = all.data() + starts[rank_];
  visit(parts_[rank_],
        [&](const float* row, int width) { buffer = std::copy(row, row + width, buffer); });
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_FLOAT, all.data(), counts.data(), starts.data(), MPI_FLOAT,
                 comm_);
  const float* from = all.data();
  for (const Part& part : parts_) {
    visit(part, [&](float* row, int width) {
      std::copy(from, from + width, row);
      from += width;
    });
  }
}

}  // namespace porefines::flow
