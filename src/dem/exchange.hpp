// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/box.hpp"
#include "dem/kept_contacts.hpp"
#include "dem/particles.hpp"
#include "par/communicator.hpp"

namespace porefines::dem {

/// Moves particles between the ranks' blocks and keeps ghosts of those near the borders.
///
/// Axis after axis, so that edges and corners are served too; messages go to neighbours only.
/// Axes that are periodic but not cut make ghosts of the rank's own particles.
/// Tests: mpi/dem (1 to 4 ranks, particles on the seams), unit/dem_system (periodic box).
class Exchange {
 public:
  Exchange(const par::Communicator& comm, const Box& box, const Blocks& blocks);

  /// Sends each particle, with its kept contacts, to the rank whose block holds it; wraps positions
  /// across periodic borders. There must be no ghosts.
  void migrate(Particles& particles, KeptContacts& kept);

  /// Appends ghosts of all particles that could come within `reach` of a particle of this block,
  /// surface to surface. @throws InputError when a block is thinner than the largest reach
  void make_ghosts(Particles& particles, Real reach);

  /// Brings position, velocity and angular velocity of the ghosts up to date: of those that were
  /// asked for by restrict_to since make_ghosts, or of all.
  void refresh(Particles& particles, bool all);

  /// From now on refresh only ghosts that `needed` marks (one per particle, owned ones are ignored),
  /// and those that they are copied from. Neighbours are told.
  void restrict_to(std::vector<std::uint8_t> needed, std::size_t owned);

  [[nodiscard]] Index messages() const { return messages_; }

 private:
  /// One direction along one axis: what leaves across this block's low (high) border arrives across
  /// the neighbour's high (low) border.
  struct Leg {
    int to = -1;  ///< rank, or -1 for a border that nothing crosses
    int from = -1;
    Real shift = 0;  ///< [m] added to positions sent: +-length across a periodic border
    std::vector<std::uint32_t> sent;
    std::vector<std::uint32_t> ghosts;    ///< that it delivers, in the same order
    std::vector<std::uint32_t> sent_few;  ///< of these, what was asked for
    std::vector<std::uint32_t> ghosts_few;
    std::vector<Real> out;
    std::vector<Real> in;
  };
  void check_widths(Real range) const;
  bool move_along(int axis, Particles& particles, KeptContacts& kept);
  void refresh_axis(Particles& particles, int axis, bool all);

  par::Communicator comm_;
  Box box_;
  Blocks blocks_;
  Int3 here_{};
  std::array<std::array<Leg, 2>, 3> legs_;  ///< [axis][0: towards low, 1: towards high]
  Index messages_ = 0;
};

}  // namespace porefines::dem
