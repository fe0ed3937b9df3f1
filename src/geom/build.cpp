// SPDX-License-Identifier: MPL-2.0
#include "geom/build.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geom/clean.hpp"
#include "geom/edit.hpp"
#include "geom/image_read.hpp"
#include "geom/throat_opening.hpp"

namespace porefines::geom {

namespace {

int rank_in(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

Index count_pores(const Voxels& voxels) {
  return std::accumulate(voxels.pore.begin(), voxels.pore.end(), Index{0});
}

GreyVolume read_cropped(const Spec& spec, const std::string& path) {
  return crop(read_image(path, spec.raw_size), spec.crop[0], spec.crop[1], path);
}

/// The order matters: noise must not count as a throat, the user's edits have the last word on it,
/// and throats must be open before pores are judged by whether they carry flow.
void clean(const Spec& spec, Voxels& voxels) {
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) {
    periodic[a] = spec.beyond[a] == Beyond::periodic;
  }
  remove_small(voxels, Phase::grain, spec.remove_grains_below, periodic);
  remove_small(voxels, Phase::pore, spec.fill_pores_below, periodic);
  erode_grains(voxels, spec.erode_grains / spec.pixel_size, spec.beyond);
  if (!spec.edit_mask.empty()) {
    apply_edit_mask(voxels, read_cropped(spec, spec.edit_mask), spec.edit_mask);
  }
  reconnect(voxels, spec.reconnect_gap, periodic);
  if (spec.minimum_throat > 0) {
    open_throats(voxels, spec.minimum_throat / spec.pixel_size, spec.beyond);
  }
  if (spec.only_percolating && !(voxels.n[2] == 1 && spec.flow_axis == 2)) {
    keep_percolating(voxels, periodic, spec.flow_axis, spec.source);
  }
}

Voxels read_voxels(const Spec& spec, Sample& sample) {
  if (!(spec.pixel_size > 0)) {
    throw InputError(
        fmt::format("pixel_size = {} m must be positive: what is the edge of one pixel of {}?",
                    spec.pixel_size, spec.source));
  }
  Voxels voxels = segment(read_cropped(spec, spec.source), spec.segmentation, spec.source);
  sample.found_pores = count_pores(voxels);
  clean(spec, voxels);
  keep_shares_of_unchanged(voxels);
  sample.kept_pores = count_pores(voxels);
  return voxels;
}

void read_list(const Spec& spec, Sample& sample) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(spec.size[axis] > 0)) {
      throw InputError(
          fmt::format("geometry.size: the box must be positive along {}.", "xyz"[axis]));
    }
  }
  if (spec.kind != Kind::empty) {
    sample.bodies = read_bodies(spec.source, spec.kind == Kind::spheres ? 3 : 2, spec.list_unit);
  }
}

void broadcast_bodies(std::vector<Body>& bodies, MPI_Comm communicator) {
  auto count = static_cast<std::int64_t>(bodies.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, communicator);
  bodies.resize(static_cast<std::size_t>(count));
  broadcast_bytes(bodies.data(), bodies.size() * sizeof(Body), communicator);
}

}  // namespace

Sample build_sample(const Spec& spec, MPI_Comm communicator) {
  Sample sample;
  sample.spec = spec;
  sample.box = {spec.size, spec.beyond};
  Voxels voxels;
  std::string error;
  if (rank_in(communicator) == 0) {
    try {
      if (spec.kind == Kind::image) {
        voxels = read_voxels(spec, sample);
      } else {
        read_list(spec, sample);
      }
    } catch (const InputError& wrong) {
      error = wrong.what();
    }
  }
  throw_everywhere(error, communicator);
  if (spec.kind != Kind::image) {
    broadcast_bodies(sample.bodies, communicator);
    return sample;
  }
  std::array<Index, 2> counts{sample.found_pores, sample.kept_pores};
  MPI_Bcast(counts.data(), 2, MPI_INT64_T, 0, communicator);
  sample.found_pores = counts[0];
  sample.kept_pores = counts[1];
  sample.voxels = share(std::move(voxels), communicator);
  sample.pixel = spec.pixel_size;
  const Int3 n = sample.voxels.n;
  const bool flat = n[2] == 1;
  sample.box.size = {n[0] * sample.pixel, n[1] * sample.pixel,
                     flat && spec.depth > 0 ? spec.depth : n[2] * sample.pixel};
  return sample;
}

Solid make_solid(const Sample& sample, const Vec3& low, const Vec3& high, Real band) {
  const Spec& spec = sample.spec;
  switch (spec.kind) {
    case Kind::empty:
      return Empty{band};
    case Kind::spheres:
      return SphereList(sample.bodies, sample.box, spec.periodic_images, band);
    case Kind::cylinders:
      return CylinderList(sample.bodies, sample.box, spec.periodic_images, band);
    case Kind::image:
      break;
  }
  Window window;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    // voxel centres on both sides of every point: trilinear interpolation never leaves
    window.first[a] = static_cast<int>(std::floor(low[axis] / sample.pixel - 0.5));
    window.past[a] = static_cast<int>(std::floor(high[axis] / sample.pixel - 0.5)) + 2;
  }
  const Real sigma = spec.smooth < 0 ? 1 : spec.smooth / sample.pixel;
  return smooth_solid(sample.voxels.view(), sample.pixel, sample.box.beyond, window,
                      {sigma, std::max<Real>(band / sample.pixel, 4)});
}

}  // namespace porefines::geom
