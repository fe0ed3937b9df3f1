// SPDX-License-Identifier: MPL-2.0
#include "analysis/gather_sample.hpp"

#include <algorithm>

#include "par/gather.hpp"

namespace porefines::analysis {
namespace {

/// One particle on its way to rank 0.
struct Row {
  std::uint64_t id;
  Vec3 position;
  Vec3 velocity;
  Real radius;
  WallTouch wall;
};

std::vector<Row> rows_of(const OwnedSample& mine) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < mine.id.size(); ++i) {
    rows.push_back({mine.id[i],
                    mine.position[i],
                    mine.velocity[i],
                    mine.radius[i],
                    {mine.wall_gap[i], mine.wall_normal[i]}});
  }
  return rows;
}

}  // namespace

void OwnedSample::put(std::uint64_t which, const Vec3& x, const Vec3& v, Real r,
                      const WallTouch& wall) {
  id.push_back(which);
  position.push_back(x);
  velocity.push_back(v);
  radius.push_back(r);
  wall_gap.push_back(wall.gap);
  wall_normal.push_back(wall.normal);
}

RunSample OwnedSample::view() const {
  RunSample sample = scalars;
  sample.id = id;
  sample.position = position;
  sample.velocity = velocity;
  sample.radius = radius;
  sample.wall_gap = wall_gap;
  sample.wall_normal = wall_normal;
  return sample;
}

OwnedSample gather_sample(const OwnedSample& mine, const par::Communicator& comm) {
  std::vector<Row> all = par::gather(comm, rows_of(mine));
  std::sort(all.begin(), all.end(), [](const Row& a, const Row& b) { return a.id < b.id; });
  OwnedSample out;
  out.scalars = mine.scalars;
  for (const Row& row : all) {
    out.put(row.id, row.position, row.velocity, row.radius, row.wall);
  }
  return out;
}

}  // namespace porefines::analysis
