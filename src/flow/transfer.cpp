// SPDX-License-Identifier: MPL-2.0
#include "flow/transfer.hpp"

#include <algorithm>

#include "flow/coarse_mobility.hpp"

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
    s.add(t.ratio * I, t.cell_first[I]);
    s.add(t.ratio * I + 1, t.cell_second[I]);
    return s;
  }
  const int middle = std::min(t.ratio * I, fine_cells);  // an odd last block ends at an odd face
  s.add(middle - 1, t.face_before[I]);
  s.add(middle, t.face_middle[I]);
  s.add(middle + 1, t.face_after[I]);
  return s;
}

/// Coarse indices along an axis that make fine index i.
Sources prolongation_sources(const AxisTransfer& t, int i, bool normal) {
  Sources s;
  const int I = i / t.ratio;
  if (!normal || i % t.ratio == 0) {
    s.add(I, 1.0F);
  } else {
    s.add(I, t.odd_low[I]);
    s.add(I + 1, t.odd_high[I]);
  }
  return s;
}

int coarse_count(const grid::Block& fine, const std::array<AxisTransfer, 3>& transfer, int axis,
                 bool faces) {
  const int ratio = transfer[axis].ratio;
  return (fine.n[axis] + ratio - 1) / ratio + (faces && fine.owns_end[axis] ? 1 : 0);
}

int fine_count(const grid::Block& fine, int axis, bool faces) {
  return fine.n[axis] + (faces && fine.owns_end[axis] ? 1 : 0);
}

/// Row of sums over source rows: row[i] = sum w field(i, j, k), for local x index i in [first, last).
void combine(const grid::Block& b, const float* field, const Sources& rows, const Sources& planes,
             const Int3& offset, int first, int last, float* row) {
  std::fill(row + first, row + last, 0.0F);
  for (int kk = 0; kk < planes.count; ++kk) {
    for (int jj = 0; jj < rows.count; ++jj) {
      const float w = rows.weight[jj] * planes.weight[kk];
      const float* from =
          field + b.at(offset[0], rows.index[jj] + offset[1], planes.index[kk] + offset[2]);
#pragma omp simd
      for (int i = first; i < last; ++i) {
        row[i] += w * from[i];
      }
    }
  }
}

}  // namespace

Transfer::Transfer(const par::Communicator& comm, const Level& fine, const Level& coarse,
                   const Boundaries& boundaries)
    : comm_(comm.handle()), rank_(comm.rank()) {
  for (int a = 0; a < 3; ++a) {
    axis_[a] = make_transfer(fine.block, a, fine.widths[a], coarse.widths[a], boundaries);
    offset_[a] = fine.block.start[a] / axis_[a].ratio - coarse.block.start[a];
  }
  if (!coarse.replicated || fine.replicated || comm.size() == 1) {
    return;
  }
  const par::Decomposition cut =
      fine.decomposition.coarsened({axis_[0].coarsened, axis_[1].coarsened, axis_[2].coarsened});
  for (int r = 0; r < comm.size(); ++r) {
    Part part{cut.start(r), cut.start(r)};
    for (int a = 0; a < 3; ++a) {
      part.last[a] += cut.extent(r)[a];
      part.last[a] += coarse.block.owns_end[a] && part.last[a] == cut.cells[a] ? 1 : 0;
    }
    parts_.push_back(part);
  }
}

void Transfer::restrict_faces(int component, const float* fine_field, const Level& fine,
                              Floats& out, const Level& coarse) const {
  const grid::Block& f = fine.block;
  std::vector<float> buffer(static_cast<std::size_t>(f.n[0]) + 4, 0.0F);
  float* row = buffer.data() + 1;
  const int count = coarse_count(f, axis_, 0, component == 0);
  for (int K = 0; K < coarse_count(f, axis_, 2, component == 2); ++K) {
    const Sources planes = restriction_sources(axis_[2], K, component == 2, f.n[2]);
    for (int J = 0; J < coarse_count(f, axis_, 1, component == 1); ++J) {
      const Sources rows = restriction_sources(axis_[1], J, component == 1, f.n[1]);
      combine(f, fine_field, rows, planes, {0, 0, 0}, -1, f.n[0] + 2, row);
      float* to = out.data() + coarse.block.at(offset_[0], J + offset_[1], K + offset_[2]);
      const AxisTransfer& t = axis_[0];
      if (component != 0) {
        for (int I = 0; I < count; ++I) {
          to[I] = t.cell_first[I] * row[t.ratio * I] + t.cell_second[I] * row[t.ratio * I + 1];
        }
        continue;
      }
      for (int I = 0; I < count; ++I) {
        const int middle = std::min(t.ratio * I, f.n[0]);
        to[I] = t.face_before[I] * row[middle - 1] + t.face_middle[I] * row[middle] +
                t.face_after[I] * row[middle + 1];
      }
    }
  }
}

void Transfer::restrict_cells(Level& fine, Level& coarse) const {
  const grid::Block& f = fine.block;
  const AxisTransfer& t = axis_[0];
  std::vector<float> row(static_cast<std::size_t>(f.n[0]) + 2, 0.0F);
  for (int K = 0; K < coarse_count(f, axis_, 2, false); ++K) {
    const Sources planes = restriction_sources(axis_[2], K, false, f.n[2]);
    for (int J = 0; J < coarse_count(f, axis_, 1, false); ++J) {
      const Sources rows = restriction_sources(axis_[1], J, false, f.n[1]);
      combine(f, fine.residual_of(3), rows, planes, {0, 0, 0}, 0, f.n[0], row.data());
      float* to = coarse.g.data() + coarse.block.at(offset_[0], J + offset_[1], K + offset_[2]);
      for (int I = 0; I < coarse_count(f, axis_, 0, false); ++I) {
        to[I] = t.cell_first[I] * row[t.ratio * I] + t.cell_second[I] * row[t.ratio * I + 1];
      }
    }
  }
}

void Transfer::restrict_mobility(const Level& fine, Level& coarse) const {
  const grid::Block& f = fine.block;
  for (int a = 0; a < 3; ++a) {
    for (int K = 0; K < coarse_count(f, axis_, 2, a == 2); ++K) {
      for (int J = 0; J < coarse_count(f, axis_, 1, a == 1); ++J) {
        for (int I = 0; I < coarse_count(f, axis_, 0, a == 0); ++I) {
          coarse.mobility[a][coarse.block.at(I + offset_[0], J + offset_[1], K + offset_[2])] =
              coarse_mobility(fine, axis_, a, {I, J, K});
        }
      }
    }
  }
  gather({coarse.mobility[0].data(), coarse.mobility[1].data(), coarse.mobility[2].data()}, coarse);
}

Real Transfer::mean_across(int component, const Level& fine, const Int3& face) const {
  const int a = (component + 1) % 3;
  const int b = (component + 2) % 3;
  const std::ptrdiff_t next_a = fine.block.stride(a);
  const std::ptrdiff_t next_b = fine.block.stride(b);
  const std::ptrdiff_t at = fine.block.at(face[0], face[1], face[2]) -
                            next_a * (face[a] % axis_[a].ratio) -
                            next_b * (face[b] % axis_[b].ratio);
  const auto share = [&](int t, int child) {
    const AxisTransfer& axis = axis_[t];
    return (child == 0 ? axis.cell_first : axis.cell_second)[face[t] / axis.ratio];
  };
  Real sum = 0;
  for (int q = 0; q < 2; ++q) {
    for (int p = 0; p < 2; ++p) {
      const Real area = share(a, p) * share(b, q);
      sum += area > 0 ? area * fine.weighted_mobility(component, at + p * next_a + q * next_b) : 0;
    }
  }
  return sum;
}

void Transfer::share_flux(Level& fine) const {
  const grid::Block& f = fine.block;
  for (int a = 0; a < 3; ++a) {
    fine.carry[a].assign(f.size, 0.0F);
    for (int k = 0; k < fine_count(f, 2, a == 2); ++k) {
      for (int j = 0; j < fine_count(f, 1, a == 1); ++j) {
        for (int i = 0; i < fine_count(f, 0, a == 0); ++i) {
          const std::ptrdiff_t at = f.at(i, j, k);
          const float m = fine.mobility[a][at];
          if (m > 0) {
            fine.carry[a][at] = static_cast<float>(m / mean_across(a, fine, {i, j, k}));
          }
        }
      }
    }
  }
  const std::array<float*, 3> fields{fine.carry[0].data(), fine.carry[1].data(),
                                     fine.carry[2].data()};
  fine.halo.exchange(fields, 1);
}

void Transfer::restrict_residual(Level& fine, Level& coarse) const {
  for (int a = 0; a < 3; ++a) {
    if (fine.flows[a]) {
      restrict_faces(a, fine.residual_of(a), fine, coarse.f[a], coarse);
    }
  }
  restrict_cells(fine, coarse);
  gather({coarse.f[0].data(), coarse.f[1].data(), coarse.f[2].data(), coarse.g.data()}, coarse);
}

void Transfer::prolong(Level& coarse, Level& fine) const {
  coarse.exchange_unknowns(1);
  for (int a = 0; a < 3; ++a) {
    if (fine.flows[a]) {
      prolong_faces(a, coarse, fine);
    }
  }
  prolong_cells(coarse, fine);
}

void Transfer::prolong_faces(int component, const Level& coarse, Level& fine) const {
  const grid::Block& f = fine.block;
  const int columns = fine_count(f, 0, component == 0);
  const AxisTransfer& t = axis_[0];
  const int coarse_columns = coarse_count(f, axis_, 0, false) + 1;
  std::vector<float> coarse_row(static_cast<std::size_t>(coarse_columns) + 1, 0.0F);
  std::vector<float> buffer(static_cast<std::size_t>(f.sy) + 2 * grid::line_width, 0.0F);
  float* row = buffer.data() + f.ghost[0];
  for (int k = 0; k < fine_count(f, 2, component == 2); ++k) {
    const Sources planes = prolongation_sources(axis_[2], k, component == 2);
    for (int j = 0; j < fine_count(f, 1, component == 1); ++j) {
      const Sources rows = prolongation_sources(axis_[1], j, component == 1);
      combine(coarse.block, coarse.u[component].data(), rows, planes, offset_, 0, coarse_columns,
              coarse_row.data());
      if (t.ratio == 1) {
        std::copy_n(coarse_row.data(), columns, row);
      } else if (component == 0) {
        for (int i = 0; i < columns; i += 2) {
          row[i] = coarse_row[i / 2];
        }
        for (int i = 1; i < columns; i += 2) {
          row[i] = t.odd_low[i / 2] * coarse_row[i / 2] + t.odd_high[i / 2] * coarse_row[i / 2 + 1];
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
          coarse.p.data() + coarse.block.at(offset_[0], j / axis_[1].ratio + offset_[1],
                                            k / axis_[2].ratio + offset_[2]);
      if (axis_[0].ratio == 1) {
        std::copy_n(from, f.n[0], row);
      } else {
        for (int i = 0; i < f.n[0]; ++i) {
          row[i] = from[i / 2];
        }
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
