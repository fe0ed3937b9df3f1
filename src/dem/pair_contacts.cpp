// SPDX-License-Identifier: MPL-2.0
// Which pairs touch, and what they remember. Their forces: pair_forces.cpp.
#include "dem/pair_contacts.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace porefines::dem {

namespace {

/// Vectors of the loops over pairs hold 8 numbers.
[[nodiscard]] std::size_t padded(std::size_t count) {
  return (count + 7) / 8 * 8;
}

}  // namespace

ContactHistory PairContacts::history_of(std::size_t at) const {
  HistoryNumbers numbers{};
  for (int h = 0; h < length_; ++h) {
    numbers[h] = touching_.history[h][at];
  }
  return std::bit_cast<ContactHistory>(numbers);
}

void PairContacts::clear() {
  list_ = {};
  near_ = {};
  touching_.count = 0;
}

void PairContacts::resize_touching(TouchingPairs& touching, std::size_t count) const {
  touching.count = count;
  TouchingPairs::for_arrays(touching, length_,
                            [count](auto& array) { array.resize(padded(count)); });
}

/// A contact without history at place `at`.
void PairContacts::begin(const Particles& p, std::uint32_t pair, TouchingPairs& t,
                         std::size_t at) const {
  const std::uint32_t i = list_.first[pair];
  const std::uint32_t j = list_.second[pair];
  t.pair[at] = pair;
  t.first[at] = static_cast<std::int32_t>(i), t.second[at] = static_cast<std::int32_t>(j);
  t.row[at] = p.species[i] * species_ + p.species[j];
  t.radius_first[at] = p.radius[i], t.radius_second[at] = p.radius[j];
  t.radius[at] = p.radius[i] * p.radius[j] / (p.radius[i] + p.radius[j]);
  t.mass[at] = 1 / (p.inverse_mass[i] + p.inverse_mass[j]);
  t.inertia[at] = 1 / (p.inverse_inertia[i] + p.inverse_inertia[j]);
  for (int h = 0; h < length_; ++h) {
    t.history[h][at] = 0;
  }
}

void PairContacts::build(const Particles& p, Real skin, const KeptContacts& kept, int species) {
  species_ = species;
  find_pairs(p, skin, list_);
  drop_immobile(p);
  std::size_t count = 0;
  resize_touching(touching_, std::min(list_.size(), kept.entries.size()));
  for (std::uint32_t k = 0; k < list_.size(); ++k) {
    const std::uint64_t partner = p.id[list_.second[k]];
    for (const KeptContact& contact : kept.of(list_.first[k])) {
      if (contact.partner == partner) {
        begin(p, k, touching_, count);
        const auto numbers = std::bit_cast<HistoryNumbers>(contact.history);
        for (int h = 0; h < length_; ++h) {
          touching_.history[h][count] = numbers[h];
        }
        ++count;
      }
    }
  }
  resize_touching(touching_, count);
}

/// Two held particles do not move each other.
void PairContacts::drop_immobile(const Particles& p) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    if (p.inverse_mass[list_.first[k]] + p.inverse_mass[list_.second[k]] > 0) {
      list_.first[count] = list_.first[k];
      list_.second[count++] = list_.second[k];
    }
  }
  list_.first.resize(count), list_.second.resize(count);
}

void PairContacts::narrow(const Particles& p, Real window) {
  near_.pair.clear(), near_.first.clear(), near_.second.clear(), near_.range.clear();
  near_.was.clear();
  std::size_t old = 0;    // walks through touching_, which is in the list's order
  std::size_t still = 0;  // of these, the ones that stay
  for (std::uint32_t k = 0; k < list_.size(); ++k) {
    const std::uint32_t i = list_.first[k];
    const std::uint32_t j = list_.second[k];
    const Vec3 d = p.position[i] - p.position[j];
    const Real touch = p.radius[i] + p.radius[j];
    const bool touched = old < touching_.count && touching_.pair[old] == k;
    const bool near = dot(d, d) < (touch + window) * (touch + window);
    if (near) {
      near_.pair.push_back(k);
      near_.first.push_back(static_cast<std::int32_t>(i));
      near_.second.push_back(static_cast<std::int32_t>(j));
      near_.range.push_back(touch * touch);
      near_.was.push_back(touched ? 1 : 0);
    }
    if (touched && near) {
      TouchingPairs::for_arrays(touching_, length_,
                                [&](auto& array) { array[still] = array[old]; });
      ++still;
    }
    old += touched ? 1 : 0;
  }
  resize_touching(touching_, still);
  near_.now.resize(near_.pair.size());
}

std::vector<std::uint8_t> PairContacts::marked_near(std::size_t particles) const {
  std::vector<std::uint8_t> marks(particles, 0);
  for_near([&marks](std::uint32_t i, std::uint32_t j) { marks[i] = marks[j] = 1; });
  return marks;
}

void PairContacts::find_touching(const Particles& p) {
  if (near_.pair.empty()) {
    return;
  }
  const Real* x = &p.position[0].x;
  const std::int32_t* first = near_.first.data();
  const std::int32_t* second = near_.second.data();
  const Real* range = near_.range.data();
  std::uint8_t* now = near_.now.data();
  const std::size_t count = near_.pair.size();
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t i = 3 * first[k];
    const std::int32_t j = 3 * second[k];
    const Real dx = x[i] - x[j];
    const Real dy = x[i + 1] - x[j + 1];
    const Real dz = x[i + 2] - x[j + 2];
    now[k] = dx * dx + dy * dy + dz * dz < range[k] ? 1 : 0;
  }
  if (std::memcmp(now, near_.was.data(), count) != 0) {
    renew_touching(p);
  }
}

/// Takes pairs that have met into touching_ and those that have parted out of it.
void PairContacts::renew_touching(const Particles& p) {
  const auto count = static_cast<std::size_t>(std::count(near_.now.begin(), near_.now.end(), 1));
  resize_touching(next_, count);
  std::size_t old = 0;
  std::size_t at = 0;
  const std::size_t all = near_.pair.size();
  for (std::size_t k = 0; k < all;) {
    std::size_t run = k;  // pairs that touch as before move together
    while (run < all && near_.now[run] == near_.was[run]) {
      ++run;
    }
    const auto same = static_cast<std::size_t>(
        std::count(near_.was.begin() + static_cast<std::ptrdiff_t>(k),
                   near_.was.begin() + static_cast<std::ptrdiff_t>(run), 1));
    copy_run(old, same, at);
    old += same, at += same;
    if (run < all) {
      if (near_.now[run] != 0) {
        begin(p, near_.pair[run], next_, at++);
      } else {
        ++old;
      }
    }
    k = run + 1;
  }
  std::swap(touching_, next_);
  near_.was = near_.now;
}

void PairContacts::copy_run(std::size_t from, std::size_t count, std::size_t to) {
  const auto copy = [=](const auto& source, auto& target) {
    std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), count,
                target.begin() + static_cast<std::ptrdiff_t>(to));
  };
  copy(touching_.pair, next_.pair);
  copy(touching_.first, next_.first), copy(touching_.second, next_.second);
  copy(touching_.row, next_.row);
  copy(touching_.radius_first, next_.radius_first);
  copy(touching_.radius_second, next_.radius_second);
  copy(touching_.radius, next_.radius);
  copy(touching_.mass, next_.mass), copy(touching_.inertia, next_.inertia);
  for (int h = 0; h < length_; ++h) {
    copy(touching_.history[h], next_.history[h]);
  }
}

}  // namespace porefines::dem
