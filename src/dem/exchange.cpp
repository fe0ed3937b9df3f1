// SPDX-License-Identifier: MPL-2.0
#include "dem/exchange.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/parcels.hpp"

namespace porefines::dem {

namespace {

/// What a ghost needs once; the rest is refreshed every step.
struct GhostParcel {
  Real radius, mass, inverse_mass, inverse_inertia, spin_resistance, resistance;
  std::uint64_t id;
  std::uint32_t species;
  std::uint32_t flags;
};

}  // namespace

Exchange::Exchange(const par::Communicator& comm, const Box& box, const Blocks& blocks)
    : comm_(comm), box_(box), blocks_(blocks), here_(blocks.coordinates(comm.rank())) {
  for (int a = 0; a < 3; ++a) {
    const int parts = blocks_.ranks[a];
    for (int side = 0; side < 2; ++side) {
      const auto neighbour = [&](int step) {
        Int3 there = here_;
        there[a] += step;
        if ((there[a] < 0 || there[a] >= parts) && !box_.periodic[a]) {
          return -1;
        }
        there[a] = (there[a] + parts) % parts;
        return blocks_.rank_at(there);
      };
      Leg& leg = legs_[a][side];
      leg.to = neighbour(side == 0 ? -1 : +1);
      leg.from = neighbour(side == 0 ? +1 : -1);
      const bool crosses = here_[a] == (side == 0 ? 0 : parts - 1);
      leg.shift = crosses ? (side == 0 ? 1 : -1) * box_.length(a) : 0;
    }
  }
}

void Exchange::check_widths(Real range) const {
  for (int a = 0; a < 3; ++a) {
    const auto& cuts = blocks_.cuts[a];
    Real width = box_.length(a) / (blocks_.ranks[a] == 1 ? 2 : 1);  // an image and its particle
    for (std::size_t b = 0; blocks_.ranks[a] > 1 && b + 1 < cuts.size(); ++b) {
      width = std::min(width, cuts[b + 1] - cuts[b]);
    }
    const bool cut = blocks_.ranks[a] > 1;
    if ((cut || box_.periodic[a]) && width < range) {
      throw InputError(fmt::format(
          "the box is {:g} m long along {} in {} block(s): particles reach {:g} m; try {}",
          box_.length(a), "xyz"[a], blocks_.ranks[a], range,
          cut ? "fewer ranks" : "a longer box or one that is not periodic there"));
    }
  }
}

void Exchange::make_ghosts(Particles& p, Real reach) {
  const Real largest = comm_.max(
      p.owned == 0 ? 0.0 : *std::max_element(p.radius.begin(), p.radius.begin() + p.owned));
  check_widths(2 * largest + reach);
  for (int a = 0; a < 3; ++a) {
    const std::size_t present = p.size();
    for (int side = 0; side < 2; ++side) {
      Leg& leg = legs_[a][side];
      leg.sent.clear();
      if (leg.to >= 0) {
        const Real border = blocks_.cuts[a][here_[a] + side];
        for (std::uint32_t i = 0; i < present; ++i) {
          const Real depth = side == 0 ? p.position[i][a] - border : border - p.position[i][a];
          if (depth < p.radius[i] + largest + reach) {
            leg.sent.push_back(i);
          }
        }
      }
    }
    for (int side = 0; side < 2; ++side) {
      Leg& leg = legs_[a][side];
      std::vector<std::byte> out;
      for (const std::uint32_t i : leg.sent) {
        const GhostParcel g{p.radius[i],
                            p.mass[i],
                            p.inverse_mass[i],
                            p.inverse_inertia[i],
                            p.creeps ? p.creeping.spin_resistance[i] : 0,
                            p.creeps ? p.creeping.resistance[i] : 0,
                            p.id[i],
                            p.species[i],
                            p.flags[i]};
        put(out, &g);
      }
      const bool own = leg.to == comm_.rank() && leg.from == comm_.rank();
      const auto in = own ? out : pass_on(comm_.handle(), out, leg.to, leg.from);
      const auto first = static_cast<std::uint32_t>(p.size());
      leg.ghosts.resize(in.size() / sizeof(GhostParcel));
      std::iota(leg.ghosts.begin(), leg.ghosts.end(), first);
      leg.sent_few = leg.sent, leg.ghosts_few = leg.ghosts;
      p.resize(first + leg.ghosts.size());
      const std::byte* at = in.data();
      for (std::size_t i = first; i < p.size(); ++i) {
        GhostParcel g;
        at = take(at, &g);
        p.radius[i] = g.radius, p.mass[i] = g.mass, p.id[i] = g.id;
        p.inverse_mass[i] = g.inverse_mass, p.inverse_inertia[i] = g.inverse_inertia;
        p.species[i] = static_cast<std::uint16_t>(g.species);
        p.flags[i] = static_cast<std::uint8_t>(g.flags);
        if (p.creeps) {
          p.creeping.spin_resistance[i] = g.spin_resistance;
          p.creeping.resistance[i] = g.resistance;
        }
      }
    }
    refresh_axis(p, a, true);
  }
}

void Exchange::refresh(Particles& p, bool all) {
  for (int a = 0; a < 3; ++a) {
    refresh_axis(p, a, all);
  }
}

void Exchange::restrict_to(std::vector<std::uint8_t> needed, std::size_t owned) {
  for (int a = 2; a >= 0; --a) {  // backwards: a ghost of a ghost needs the first one
    for (Leg& leg : legs_[a]) {
      std::vector<std::uint32_t> wanted;
      leg.ghosts_few.clear(), leg.sent_few.clear();
      for (std::uint32_t k = 0; k < leg.ghosts.size(); ++k) {
        if (needed[leg.ghosts[k]] != 0) {
          wanted.push_back(k);
          leg.ghosts_few.push_back(leg.ghosts[k]);
        }
      }
      if (leg.to != comm_.rank()) {
        std::vector<std::byte> out;
        put(out, wanted.data(), wanted.size());
        const auto in = pass_on(comm_.handle(), out, leg.from, leg.to);
        messages_ += leg.from >= 0 ? 1 : 0;
        wanted.resize(in.size() / sizeof(std::uint32_t));
        take(in.data(), wanted.data(), wanted.size());
      }
      for (const std::uint32_t k : wanted) {
        leg.sent_few.push_back(leg.sent[k]);
      }
    }
    for (const Leg& leg : legs_[a]) {
      for (const std::uint32_t i : leg.sent_few) {
        needed[i] = i >= owned ? 1 : 0;
      }
    }
  }
}

void Exchange::refresh_axis(Particles& p, int axis, bool all) {
  constexpr int width = 9;
  std::array<MPI_Request, 4> requests{MPI_REQUEST_NULL, MPI_REQUEST_NULL, MPI_REQUEST_NULL,
                                      MPI_REQUEST_NULL};
  const auto rank_or_null = [](int rank) { return rank < 0 ? MPI_PROC_NULL : rank; };
  const auto tag = [](int side) { return 2 + side; };
  for (int side = 0; side < 2; ++side) {
    Leg& leg = legs_[axis][side];
    const auto& sent = all ? leg.sent : leg.sent_few;
    const auto& ghosts = all ? leg.ghosts : leg.ghosts_few;
    Vec3 shift;
    shift[axis] = leg.shift;
    if (leg.to == comm_.rank()) {  // its own image
      for (std::size_t k = 0; k < sent.size(); ++k) {
        const std::uint32_t i = sent[k];
        p.position[ghosts[k]] = p.position[i] + shift;
        p.velocity[ghosts[k]] = p.velocity[i];
        p.angular_velocity[ghosts[k]] = p.angular_velocity[i];
      }
      continue;
    }
    leg.in.resize(width * ghosts.size());
    MPI_Irecv(leg.in.data(), static_cast<int>(leg.in.size()), MPI_DOUBLE, rank_or_null(leg.from),
              tag(side), comm_.handle(), &requests[2 * side]);
    leg.out.resize(width * sent.size());
    Real* to = leg.out.data();
    for (const std::uint32_t i : sent) {
      for (const Vec3& v : {p.position[i] + shift, p.velocity[i], p.angular_velocity[i]}) {
        to[0] = v.x, to[1] = v.y, to[2] = v.z;
        to += 3;
      }
    }
    MPI_Isend(leg.out.data(), static_cast<int>(leg.out.size()), MPI_DOUBLE, rank_or_null(leg.to),
              tag(side), comm_.handle(), &requests[2 * side + 1]);
    messages_ += leg.to >= 0 ? 1 : 0;
  }
  MPI_Waitall(4, requests.data(), MPI_STATUSES_IGNORE);
  for (const Leg& leg : legs_[axis]) {
    if (leg.to == comm_.rank()) {
      continue;
    }
    const Real* from = leg.in.data();
    for (const std::uint32_t k : all ? leg.ghosts : leg.ghosts_few) {
      p.position[k] = {from[0], from[1], from[2]};
      p.velocity[k] = {from[3], from[4], from[5]};
      p.angular_velocity[k] = {from[6], from[7], from[8]};
      from += width;
    }
  }
}

}  // namespace porefines::dem
