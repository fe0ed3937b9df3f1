// SPDX-License-Identifier: MPL-2.0
// The clogging log's memory as a row of numbers, for checkpoints.
#include "analysis/clogging.hpp"
#include "core/error.hpp"

namespace porefines::analysis {
namespace {

/// Reads numbers one by one.
class Reader {
 public:
  explicit Reader(std::span<const Real> numbers) : numbers_(numbers) {}

  Real next() {
    if (at_ >= numbers_.size()) {
      fail();
    }
    return numbers_[at_++];
  }
  std::size_t count() {
    const Real value = next();
    if (!(value >= 0) || value > static_cast<Real>(numbers_.size())) {
      fail();
    }
    return static_cast<std::size_t>(value);
  }
  void require_end() const {
    if (at_ != numbers_.size()) {
      fail();
    }
  }

 private:
  [[noreturn]] static void fail() {
    throw RunError("checkpoint: the numbers of the clogging log do not fit together");
  }
  std::span<const Real> numbers_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Real> pack(const CloggingState& state) {
  std::vector<Real> out{state.rest.fastest_fluid, static_cast<Real>(state.rest.resting.size())};
  for (const Resting& one : state.rest.resting) {
    out.insert(out.end(), {static_cast<Real>(one.id), one.place.x, one.place.y, one.place.z,
                           one.since, one.retained ? 1.0 : 0.0});
  }
  out.push_back(static_cast<Real>(state.clogs.size()));
  for (const Clog& clog : state.clogs) {
    out.insert(out.end(), {static_cast<Real>(clog.throat), static_cast<Real>(clog.kind),
                           static_cast<Real>(clog.behind), static_cast<Real>(clog.most), clog.since,
                           static_cast<Real>(clog.ids.size())});
    out.insert(out.end(), clog.ids.begin(), clog.ids.end());
  }
  return out;
}

CloggingState unpack_clogging(std::span<const Real> numbers) {
  Reader read(numbers);
  CloggingState state;
  state.rest.fastest_fluid = read.next();
  state.rest.resting.resize(read.count());
  for (Resting& one : state.rest.resting) {
    one.id = static_cast<std::uint64_t>(read.next());
    one.place = {read.next(), read.next(), read.next()};
    one.since = read.next();
    one.retained = read.next() != 0;
  }
  state.clogs.resize(read.count());
  for (Clog& clog : state.clogs) {
    clog.throat = static_cast<std::int32_t>(read.next());
    clog.kind = read.next() == 0 ? ClogKind::sieve : ClogKind::arch;
    clog.behind = static_cast<Index>(read.next());
    clog.most = static_cast<Index>(read.next());
    clog.since = read.next();
    clog.ids.resize(read.count());
    for (std::uint64_t& id : clog.ids) {
      id = static_cast<std::uint64_t>(read.next());
    }
  }
  read.require_end();
  return state;
}

}  // namespace porefines::analysis
