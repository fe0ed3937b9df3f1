// SPDX-License-Identifier: MPL-2.0
#include "dem/injection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <mpi.h>

#include "dem/packing.hpp"

namespace porefines::dem {
namespace {

constexpr int tries_each = 64;
constexpr Index most_at_once = 4096;
constexpr Real clearance = 1e-3;  ///< gap to others, in radii

/// A sphere that is in the way, or wants to come in.
struct Sphere {
  Vec3 centre;
  Real radius = 0;
};

/// What is due, with its size; places come later.
struct Candidate {
  Real radius = 0;
  Real late = 0;  ///< [s] since it was due
  std::array<Vec3, tries_each> place{};
  std::array<bool, tries_each> wanted{};  ///< by the flow: places with more flux more often
  std::array<char, tries_each> free{};    ///< of walls and grains
};

Vec3 inwards(BoxFace face) {
  Vec3 n;
  n[axis_of(face)] = is_high(face) ? -1 : 1;
  return n;
}

Real radius_of(const Inlet& inlet, std::uint64_t particle) {
  Draws draws(inlet.seed, Stream::size, inlet.stream << 40 | particle);
  return draw_diameter(inlet.sizes, draws) / 2;
}

/// What became due and has not entered, oldest first.
std::vector<Candidate> due_candidates(const Inlet& inlet, const InletState& state, Real before,
                                      Real opened, Real elapsed) {
  std::vector<Candidate> due;
  Real entered = state.entered;
  for (std::uint64_t k = state.particles; static_cast<Index>(due.size()) < most_at_once; ++k) {
    const Real radius = radius_of(inlet, k);
    entered += inlet.by_number ? 1 : sphere_volume(radius);
    if (entered > state.due * (1 + 1e-12)) {
      break;
    }
    const Real reached =
        opened > 0 ? std::clamp((entered - before) / (inlet.rate * opened), 0.0, 1.0) : 1;
    due.push_back({.radius = radius, .late = (1 - reached) * elapsed});
  }
  return due;
}

Vec3 velocity_at(const Inlet& inlet, const Vec3& place) {
  return inlet.flow ? inlet.flow(place) : inlet.velocity * inwards(inlet.face);
}

/// Random places for one candidate, further in the longer it is late.
void draw_places(const Inlet& inlet, const Box& box, std::uint64_t particle, std::uint32_t tries,
                 Candidate& candidate) {
  const int axis = axis_of(inlet.face);
  const Vec3 in = inwards(inlet.face);
  Draws draws(inlet.seed, Stream::place, inlet.stream << 40 | particle, 3 * tries);
  for (int t = 0; t < tries_each; ++t) {
    Vec3 x;
    for (int a = 0; a < 3; ++a) {
      if (a != axis) {
        const Real wall = box.periodic[a] ? 0 : candidate.radius * (1 + clearance);
        const Real low = std::max(inlet.low[a], box.low[a] + wall);
        const Real high = std::min(inlet.high[a], box.high[a] - wall);
        x[a] = draws.uniform(low, std::max(low, high));
      }
    }
    x[axis] = is_high(inlet.face) ? box.high[axis] : box.low[axis];
    const Real speed = dot(velocity_at(inlet, x), in);
    candidate.wanted[t] = !inlet.flow || draws.uniform() * inlet.fastest_flow < speed;
    (void)(inlet.flow ? 0.0 : draws.uniform());  // three draws a try, with or without a flow
    x[axis] +=
        in[axis] * (candidate.radius * (1 + clearance) + std::max(speed, 0.0) * candidate.late);
    candidate.place[t] = x;
  }
}

/// Marks the places that touch no wall: each is looked at by the rank that owns it.
void find_free(const System& system, const par::Communicator& comm,
               std::vector<Candidate>& candidates) {
  const Settings& settings = system.settings();
  std::vector<char> free;
  TouchList touches;
  for (const Candidate& candidate : candidates) {
    for (const Vec3& place : candidate.place) {
      char open = 0;
      if (settings.blocks.owner(settings.box.wrapped(place)) == comm.rank()) {
        find_touches(settings.walls, place, candidate.radius, 0.5 * clearance * candidate.radius,
                     touches);
        open = touches.count == 0 && !touches.inside ? 1 : 0;
      }
      free.push_back(open);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, free.data(), static_cast<int>(free.size()), MPI_CHAR, MPI_MAX,
                comm.handle());
  auto next = free.begin();
  for (Candidate& candidate : candidates) {
    std::copy_n(next, tries_each, candidate.free.begin());
    next += tries_each;
  }
}

/// All spheres of all ranks that reach into the slab behind the face.
std::vector<Sphere> spheres_near(const System& system, const par::Communicator& comm, BoxFace face,
                                 Real depth) {
  const Particles& p = system.particles();
  const Box& box = system.settings().box;
  const int axis = axis_of(face);
  std::vector<Real> mine;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Vec3& x = p.position[i];
    const Real behind = is_high(face) ? box.high[axis] - x[axis] : x[axis] - box.low[axis];
    if (behind - p.radius[i] < depth) {
      mine.insert(mine.end(), {x.x, x.y, x.z, p.radius[i]});
    }
  }
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.handle());
  std::vector<int> starts(counts.size(), 0);
  for (std::size_t r = 1; r < counts.size(); ++r) {
    starts[r] = starts[r - 1] + counts[r - 1];
  }
  std::vector<Real> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(),
                 MPI_DOUBLE, comm.handle());
  std::vector<Sphere> spheres;
  for (std::size_t s = 0; s < all.size(); s += 4) {
    spheres.push_back({{all[s], all[s + 1], all[s + 2]}, all[s + 3]});
  }
  return spheres;
}

bool fits(const Box& box, const Vec3& place, Real radius, const std::vector<Sphere>& others) {
  return std::none_of(others.begin(), others.end(), [&](const Sphere& other) {
    Vec3 d = place - other.centre;
    for (int a = 0; a < 3; ++a) {
      d[a] -= box.periodic[a] ? box.length(a) * std::round(d[a] / box.length(a)) : 0;
    }
    const Real reach = radius * (1 + clearance) + other.radius;
    return dot(d, d) < reach * reach;
  });
}

}  // namespace

Real open_time(const Inlet& inlet, Real time) {
  const Real since = std::min(time, inlet.stop) - inlet.start;
  if (since <= 0) {
    return 0;
  }
  if (inlet.period == 0) {
    return since;
  }
  const Real periods = std::floor(since / inlet.period);
  return periods * inlet.duration + std::min(since - periods * inlet.period, inlet.duration);
}

std::vector<Body> let_in(System& system, const par::Communicator& comm, const Inlet& inlet,
                         InletState& state, Real from, Real to, std::uint64_t& next_id) {
  const Real opened = open_time(inlet, to) - open_time(inlet, from);
  const Real before = state.due;
  state.due += inlet.rate * opened;
  std::vector<Candidate> due = due_candidates(inlet, state, before, opened, to - from);
  if (due.empty()) {
    return {};
  }
  const Box& box = system.settings().box;
  Real depth = 0;
  for (std::size_t c = 0; c < due.size(); ++c) {
    draw_places(inlet, box, state.particles + c, c == 0 ? state.tries : 0, due[c]);
    const Real speed = inlet.flow ? inlet.fastest_flow : inlet.velocity;
    depth = std::max(depth, (2 + 2 * clearance) * due[c].radius + speed * due[c].late);
  }
  find_free(system, comm, due);
  std::vector<Sphere> others = spheres_near(system, comm, inlet.face, depth);
  std::vector<Body> bodies;
  for (const Candidate& candidate : due) {
    int t = 0;
    while (t < tries_each && !(candidate.wanted[t] && candidate.free[t] != 0 &&
                               fits(box, candidate.place[t], candidate.radius, others))) {
      ++t;
    }
    if (t == tries_each) {
      state.tries += tries_each;
      break;
    }
    others.push_back({candidate.place[t], candidate.radius});
    Body body;
    body.id = next_id++;
    body.position = candidate.place[t];
    body.velocity = velocity_at(inlet, body.position);
    body.radius = candidate.radius;
    body.density = inlet.density;
    body.species = inlet.species;
    bodies.push_back(body);
    state.entered += inlet.by_number ? 1 : sphere_volume(candidate.radius);
    state.tries = 0;
  }
  state.particles += bodies.size();
  state.waiting = static_cast<Index>(due.size() - bodies.size());
  if (!bodies.empty()) {
    system.insert(bodies);
  }
  return bodies;
}

Real open_share(const System& system, const par::Communicator& comm, const Inlet& inlet) {
  constexpr int batches = 16;
  std::vector<Candidate> probes;
  for (int b = 0; b < batches; ++b) {
    probes.push_back({.radius = largest_diameter(inlet.sizes) / 2});
    draw_places(inlet, system.settings().box, 0, b * tries_each, probes.back());
  }
  find_free(system, comm, probes);
  Index open = 0;
  for (const Candidate& probe : probes) {
    open += std::count(probe.free.begin(), probe.free.end(), 1);
  }
  return static_cast<Real>(open) / (batches * tries_each);
}

}  // namespace porefines::dem
