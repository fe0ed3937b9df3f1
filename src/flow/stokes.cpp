// SPDX-License-Identifier: MPL-2.0
#include "flow/stokes.hpp"

#include <algorithm>
#include <cmath>

#include "flow/bridges.hpp"

namespace porefines::flow {

StokesSolver::StokesSolver(const par::Communicator& comm, const par::Decomposition& cut,
                           const Vec3& spacing, const Boundaries& boundaries, Real viscosity)
    : comm_(comm),
      boundaries_(boundaries),
      spacing_(spacing),
      viscosity_(viscosity),
      hierarchy_(comm, cut, spacing / spacing.x, boundaries) {}

void StokesSolver::set_surface(const std::function<Real(const Vec3&)>& distance) {
  const Real h = spacing_.x;
  finish_setup(link_to_surface(hierarchy_.finest(), boundaries_,
                               [&](const Vec3& x) { return distance(x * h) / h; }));
}

void StokesSolver::set_voxels(const IsPore& is_pore) {
  finish_setup(link_to_voxels(hierarchy_.finest(), boundaries_, is_pore));
}

void StokesSolver::finish_setup(Friction friction) {
  friction_ = std::make_unique<Friction>(std::move(friction));
  prune_dead_ends(comm_, hierarchy_.finest(), boundaries_, *friction_);
  close_bridges(hierarchy_.finest(), boundaries_, *friction_);
  prune_dead_ends(comm_, hierarchy_.finest(), boundaries_,
                  *friction_);  // ghosts; what was left of pockets
  finish_level(hierarchy_.finest());
  hierarchy_.build();
  operator_ = std::make_unique<Operator>(hierarchy_.finest(), *friction_);
}

bool StokesSolver::pressure_pair(int axis) const {
  return gives_pressure(boundaries_.at(axis, false)) && gives_pressure(boundaries_.at(axis, true));
}

Real StokesSolver::force_scale(const Drive& drive) const {
  Real scale = norm(drive.force);
  Real lowest = INFINITY;
  Real highest = -INFINITY;
  for (int face = 0; face < 6; ++face) {
    const Real value = drive.face_value[face];
    if (boundaries_.kind[face] == FaceKind::velocity) {
      scale = std::max(scale, std::abs(value) * viscosity_ / (spacing_.x * spacing_.x));
    } else if (boundaries_.kind[face] == FaceKind::lid) {
      scale = std::max(scale, norm(drive.lid[face]) * viscosity_ / (spacing_.x * spacing_.x));
    } else if (gives_pressure(boundaries_.kind[face])) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  const Real longest = std::max({length(0), length(1), length(2)});
  if (highest > lowest) {
    scale = std::max(scale, (highest - lowest) / longest);
  }
  return scale > 0 ? scale : 1;
}

namespace {

/// Global index along an axis of a local one.
int global(const grid::Block& b, int axis, int local) {
  return local + b.start[axis];
}

/// The drive in units of the solve.
struct ScaledDrive {
  const Drive& drive;
  Real force = 1;     ///< [Pa/m]
  Real pressure = 1;  ///< [Pa]
  Real velocity = 1;  ///< [m/s]
};

/// Pull of moving walls on the layer of faces beside them, half a cell away: 2 e u_wall.
float lid_drive(const Level& level, const Boundaries& boundaries, const ScaledDrive& d, int c,
                const Int3& index) {
  Real sum = 0;
  for (int a = 0; a < 3; ++a) {
    const auto& axis = level.axis[a];
    const int here = global(level.block, a, index[a]);
    for (const bool high : {false, true}) {
      const bool beside = a != c && here == (high ? level.block.global[a] - 1 : 0);
      if (beside && boundaries.at(a, high) == FaceKind::lid) {
        const auto& e = high ? axis.cell_high : axis.cell_low;
        sum += 2 * e[index[a] + axis.offset] * d.drive.lid[2 * a + (high ? 1 : 0)][c] / d.velocity;
      }
    }
  }
  return static_cast<float>(sum);
}

/// What drives the momentum of a face: the force, and the value behind a pressure or velocity face.
float face_drive(const Level& level, const Boundaries& boundaries, const ScaledDrive& d, int c,
                 const Int3& index, std::ptrdiff_t cell) {
  const int local = index[c];
  const auto& axis = level.axis[c];
  const int here = global(level.block, c, local);
  const int total = level.block.global[c];
  const Real weight = level.weight[c][cell];
  const Real gradient = axis.gradient[local + axis.offset];
  auto sum = static_cast<float>(weight * d.drive.force[c] / d.force);
  for (const bool high : {false, true}) {
    const FaceKind kind = boundaries.at(c, high);
    const Real value = d.drive.face_value[2 * c + (high ? 1 : 0)];
    if (gives_pressure(kind) && here == (high ? total : 0)) {
      sum += static_cast<float>((high ? -1 : 1) * weight * gradient * value / d.pressure);
    } else if (kind == FaceKind::velocity && here == (high ? total - 1 : 1)) {
      const auto& e = high ? axis.face_high : axis.face_low;
      sum += static_cast<float>(e[local + axis.offset] * value / d.velocity);
    }
  }
  return sum + lid_drive(level, boundaries, d, c, index);
}

/// Inflow through velocity faces along an axis, where the face behind is open.
float cell_drive(const Level& level, const Boundaries& boundaries, const ScaledDrive& d, int a,
                 int local, std::ptrdiff_t cell) {
  const int here = global(level.block, a, local);
  float sum = 0;
  for (const bool high : {false, true}) {
    const bool outermost = here == (high ? level.block.global[a] - 1 : 0);
    const std::ptrdiff_t inner = cell + (high ? 0 : level.block.stride(a));
    if (boundaries.at(a, high) == FaceKind::velocity && outermost &&
        level.inverse_diagonal[a][inner] != 0) {
      const Real value = d.drive.face_value[2 * a + (high ? 1 : 0)] / d.velocity;
      sum += (high ? -1 : 1) * value * level.axis[a].divergence[local + level.axis[a].offset];
    }
  }
  return sum;
}

}  // namespace

Packed<float> StokesSolver::right_hand_side(const Drive& drive) const {
  Packed<float> b(operator_->size(), 0.0F);
  const Level& level = hierarchy_.finest();
  const ScaledDrive d{drive, scale_, scale_ * spacing_.x,
                      scale_ * spacing_.x * spacing_.x / viscosity_};
  operator_->for_each([&](int c, int i, int j, int k, std::size_t at) {
    const Int3 index{i, j, k};
    const std::ptrdiff_t cell = level.block.at(i, j, k);
    if (c < 3) {
      b[at] = face_drive(level, boundaries_, d, c, index, cell);
      return;
    }
    for (int a = 0; a < 3; ++a) {
      b[at] += cell_drive(level, boundaries_, d, a, index[a], cell);
    }
  });
  return b;
}

Packed<double> StokesSolver::first_guess(const Drive& drive) const {
  Packed<double> x(operator_->size(), 0.0);
  const Real unit = scale_ * spacing_.x;
  operator_->for_each_of(3, [&](int i, int j, int k, std::size_t at) {
    const Int3 index{i, j, k};
    for (int a = 0; a < 3; ++a) {
      if (pressure_pair(a)) {
        const Real t = (global(block(), a, index[a]) + 0.5) / block().global[a];
        x[at] = ((1 - t) * drive.face_value[2 * a] + t * drive.face_value[2 * a + 1]) / unit;
      }
    }
  });
  return x;
}

/// Norm of the force that drives the flow, spread over the fluid: also for a pressure drop, whose
/// right-hand side sits on one plane only. Residuals then mean the same for every kind of drive.
Real StokesSolver::reference_norm(const Drive& drive, const Packed<float>& b) const {
  Vec3 force = drive.force;
  bool spread = norm(force) > 0;
  for (int a = 0; a < 3; ++a) {
    if (pressure_pair(a)) {
      force[a] += (drive.face_value[2 * a] - drive.face_value[2 * a + 1]) / length(a);
      spread = true;
    }
  }
  Real sum = 0;
  operator_->for_each([&](int c, int i, int j, int k, std::size_t at) {
    const Real w = c < 3 ? hierarchy_.finest().weight[c][block().at(i, j, k)] : 0;
    const Real value = spread ? (c < 3 ? w * force[c] / scale_ : 0) : b[at];
    sum += value * value;
  });
  return std::sqrt(comm_.sum(sum));
}

SolveReport StokesSolver::solve(const Drive& drive, SolveOptions options) {
  if (spheres_) {
    return solve_suspension(drive, std::move(options));
  }
  constexpr Real tightest = 1e-10;
  scale_ = force_scale(drive);
  const Packed<float> b = right_hand_side(drive);
  x_ = first_guess(drive);
  options.reference = reference_norm(drive, b);
  const Real even = std::max(flux_tolerance, options.tolerance);
  SolveReport report = solve_gcr(comm_, hierarchy_, *operator_, b, x_, options);
  while (report.converged && report.residual > tightest && flux_variation() > even) {
    options.tolerance = report.residual / 4;
    const SolveReport more = solve_gcr(comm_, hierarchy_, *operator_, b, x_, options);
    report.flux_cycles += more.cycles;
    report.residual = more.residual;
    if (!more.converged) {
      break;  // the residual asked for is met; the flux is as good as it gets
    }
  }
  return report;
}

/// Of the strongest flux among the axes; 0 where fluid may leave sideways and fluxes need not agree.
Real StokesSolver::flux_variation() const {
  const auto opens = [&](int a) {
    const auto given = [](FaceKind k) { return gives_pressure(k) || k == FaceKind::velocity; };
    return given(boundaries_.at(a, false)) || given(boundaries_.at(a, true));
  };
  Real strongest = 0;
  Real variation = 0;
  for (int a = 0; a < 3; ++a) {
    const std::vector<Real> flux = plane_fluxes(a);
    const auto [low, high] = std::minmax_element(flux.begin(), flux.end());
    const Real size = std::max(std::abs(*low), std::abs(*high));
    if (size > strongest) {
      strongest = size;
      variation = opens((a + 1) % 3) || opens((a + 2) % 3) ? 0 : (*high - *low) / size;
    }
  }
  return variation;
}

/// Calls visit(index, W u [m/s]) for the faces normal to an axis that this rank owns, those that
/// spheres cover too.
template <typename Visit>
void StokesSolver::for_fluxes(int axis, const Visit& visit) const {
  const Level& level = hierarchy_.finest();
  const Real unit = scale_ * spacing_.x * spacing_.x / viscosity_;
  operator_->for_each_of(axis, [&](int i, int j, int k, std::size_t at) {
    visit(Int3{i, j, k}, level.weight[axis][block().at(i, j, k)] * x_[at] * unit);
  });
  if (spheres_) {
    spheres_->for_covered([&](const RigidFace& q, Real velocity) {
      if (q.face.component == axis) {
        visit(spheres_->cover().index_of(q.face.at),
              level.weight[axis][q.face.at] * velocity * unit);
      }
    });
  }
}

std::vector<Real> StokesSolver::plane_fluxes(int axis) const {
  std::vector<Real> flux(static_cast<std::size_t>(block().global[axis]) + 1, 0);
  const Real area = spacing_.x * spacing_.y * spacing_.z / spacing_[axis];
  for_fluxes(axis, [&](const Int3& index, Real velocity) {
    flux[global(block(), axis, index[axis])] += velocity * area;
  });
  comm_.sum(flux);
  if (boundaries_.periodic(axis)) {
    flux.back() = flux.front();
  }
  for (const bool high : {false, true}) {  // velocity faces hold no unknowns: the next plane's flux
    if (boundaries_.at(axis, high) == FaceKind::velocity && flux.size() > 2) {
      (high ? flux.back() : flux.front()) = high ? flux[flux.size() - 2] : flux[1];
    }
  }
  return flux;
}

std::vector<Real> StokesSolver::plane_velocities(int axis, int plane) const {
  const int a = axis == 0 ? 1 : 0;
  const int b = axis == 2 ? 1 : 2;
  const int columns = block().global[a];
  std::vector<Real> out(static_cast<std::size_t>(columns) * block().global[b], 0);
  for_fluxes(axis, [&](const Int3& index, Real velocity) {
    if (global(block(), axis, index[axis]) == plane) {
      out[static_cast<std::size_t>(global(block(), b, index[b])) * columns +
          global(block(), a, index[a])] += velocity;
    }
  });
  comm_.sum(out);
  return out;
}

std::vector<Real> StokesSolver::layer_pressures(int axis) const {
  const auto layers = static_cast<std::size_t>(block().global[axis]);
  std::vector<Real> sums(2 * layers, 0);
  operator_->for_each_of(3, [&](int i, int j, int k, std::size_t at) {
    const int layer = global(block(), axis, Int3{i, j, k}[axis]);
    sums[layer] += x_[at] * scale_ * spacing_.x;
    sums[layers + layer] += 1;
  });
  comm_.sum(sums);
  std::vector<Real> mean(layers, 0);
  for (std::size_t layer = 0; layer < layers; ++layer) {
    mean[layer] = sums[layers + layer] > 0 ? sums[layer] / sums[layers + layer] : 0;
  }
  return mean;
}

Vec3 StokesSolver::superficial_velocity() const {
  Vec3 velocity;
  for (int a = 0; a < 3; ++a) {
    const std::vector<Real> flux = plane_fluxes(a);
    Real sum = 0;
    const auto n = static_cast<std::size_t>(block().global[a]);
    for (std::size_t i = 0; i < n; ++i) {
      sum += (flux[i] + flux[i + 1]) / 2;
    }
    velocity[a] = sum / static_cast<Real>(n) / (length(0) * length(1) * length(2) / length(a));
  }
  return velocity;
}

StokesSolver::CellFields StokesSolver::cell_fields() {
  Level& level = hierarchy_.finest();
  Operator& op = *operator_;
  op.load_unknowns(x_);
  if (spheres_) {
    spheres_->write_faces(true);
  }
  level.exchange_unknowns(1);
  const grid::Block& b = block();
  const auto count = static_cast<std::size_t>(b.cells());
  const Real velocity_unit = scale_ * spacing_.x * spacing_.x / viscosity_;
  const Real pressure_unit = scale_ * spacing_.x;
  CellFields out;
  for (auto& field : out.velocity) {
    field.resize(count);
  }
  out.pressure.resize(count);
  out.fluid.resize(count);
  std::size_t cell = 0;
  for (int k = 0; k < b.n[2]; ++k) {
    for (int j = 0; j < b.n[1]; ++j) {
      for (int i = 0; i < b.n[0]; ++i, ++cell) {
        const std::ptrdiff_t at = b.at(i, j, k);
        for (int a = 0; a < 3; ++a) {
          out.velocity[a][cell] = static_cast<float>(
              (level.u[a][at] + level.u[a][at + b.stride(a)]) / 2 * velocity_unit);
        }
        out.pressure[cell] = static_cast<float>(level.p[at] * pressure_unit);
        out.fluid[cell] = level.push[at] != 0 ? 1.0F : 0.0F;
      }
    }
  }
  return out;
}

Index StokesSolver::fluid_cells() const {
  Index count = 0;
  operator_->for_each_of(3, [&](int, int, int, std::size_t) { ++count; });
  return comm_.sum(count);
}

}  // namespace porefines::flow
