// SPDX-License-Identifier: MPL-2.0
#include "analysis/readings.hpp"

#include "core/error.hpp"

namespace porefines::analysis {
namespace {

io::SeriesWriter begin(const std::string& path, const std::vector<std::string>& columns,
                       std::optional<Real> resume) {
  return resume ? io::SeriesWriter::resume(path, columns, *resume)
                : io::SeriesWriter(path, columns);
}

constexpr std::size_t meter_numbers = 5;

}  // namespace

std::vector<Real> pack(const ReadingState& state) {
  const BreakthroughMeter& m = state.breakthrough;
  std::vector<Real> out{m.last.flow, m.last.injected, m.last.out, m.fed_from, m.fed_to};
  const std::vector<Real> clogging = pack(state.clogging);
  out.insert(out.end(), clogging.begin(), clogging.end());
  return out;
}

ReadingState unpack_readings(std::span<const Real> numbers) {
  if (numbers.size() < meter_numbers) {
    throw RunError("checkpoint: the numbers of the readings do not fit together");
  }
  ReadingState state;
  state.breakthrough = {{numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4]};
  state.clogging = unpack_clogging(numbers.subspan(meter_numbers));
  return state;
}

ReadingTables::ReadingTables(const std::string& folder, const geom::PoreNetwork& network,
                             std::optional<Real> resume)
    : clogging(begin(folder + "/clogging.csv", clogging_columns(), resume)),
      retention(begin(folder + "/retention.csv", retention_columns(), resume)),
      pressure(begin(folder + "/throats_pressure.csv", throat_pressure_columns(), resume)) {
  geom::write_throats(folder + "/throats.csv", network.throats);
  geom::write_pores(folder + "/pores.csv", network.pores);
}

std::vector<std::string> reading_columns() {
  return {"inlet_concentration", "outlet_concentration", "concentration_ratio", "piping_share",
          "bridging_share",      "clogged_share",        "resting_share",       "clogged_throats"};
}

std::vector<Real> reading_row(const Reading& reading) {
  const FateCounts& c = reading.counts;
  return {reading.breakthrough.inlet, reading.breakthrough.outlet,
          reading.breakthrough.ratio, c.share(c.piping),
          c.share(c.bridging),        c.share(c.clogged),
          c.share(c.resting),         static_cast<Real>(reading.clogged_throats)};
}

Reading take_reading(ReadingState& state, const ReadingSetup& setup, const RunSample& sample,
                     const Throughput& throughput, const std::vector<ThroatPressure>& pressures,
                     ReadingTables* tables) {
  Reading reading;
  reading.breakthrough = take_breakthrough(state.breakthrough, throughput, setup.c0);
  reading.events = update_clogging(state.clogging, sample, setup.network, setup.rest, setup.blocks);
  reading.counts = state.clogging.counts;
  reading.clogged_throats = static_cast<Index>(state.clogging.clogs.size());
  if (tables != nullptr) {
    const RetentionProfile profile = retention_along(sample, state.clogging.fates, setup.bins);
    tables->clogging.append_lines(clogging_rows(reading.events, setup.network));
    tables->retention.append_lines(
        retention_rows(sample, profile, setup.pore_volumes, setup.area, setup.bins));
    tables->pressure.append_lines(
        throat_pressure_rows(sample.time, sample.pore_volumes, pressures));
  }
  return reading;
}

}  // namespace porefines::analysis
