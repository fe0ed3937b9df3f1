// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cmath>

#include "core/types.hpp"

namespace porefines::analysis {

/// What has gone through so far [m^3].
struct Throughput {
  Real flow = 0;      ///< suspension: fluid and particles
  Real injected = 0;  ///< volume of particles that came in
  Real out = 0;       ///< and that left through the outlet
};

/// Memory of the breakthrough curve; all of it belongs into a checkpoint.
struct BreakthroughMeter {
  Throughput last;
  Real fed_from = 0;  ///< [m^3] flow before the first particle came in
  Real fed_to = 0;    ///< [m^3] flow when the last one had come in
};

/// Volume fractions over the interval since the last sample; NaN when nothing flowed.
struct Breakthrough {
  Real inlet = 0;
  Real outlet = 0;
  Real ratio = 0;  ///< C/C0; NaN before anything was injected
};

/// Takes a sample.
///
///     C = d(out) / d(flow),   C0 = what was asked for, or injected / flow while particles came in
///
/// @param c0  volume fraction of the injection; 0: measured from what came in
/// With few particles per interval the curve is noisy: choose longer intervals.
/// Test: unit/run_readings.
[[nodiscard]] inline Breakthrough take_breakthrough(BreakthroughMeter& meter, const Throughput& now,
                                                    Real c0) {
  const Real flow = now.flow - meter.last.flow;
  if (now.injected > meter.last.injected) {
    meter.fed_from = meter.last.injected > 0 ? meter.fed_from : meter.last.flow;
    meter.fed_to = now.flow;
  }
  const Real fed = meter.fed_to - meter.fed_from;
  const Real feed = c0 > 0 ? c0 : now.injected / fed;
  Breakthrough out{std::nan(""), std::nan(""), std::nan("")};
  if (flow > 0) {
    out.inlet = (now.injected - meter.last.injected) / flow;
    out.outlet = (now.out - meter.last.out) / flow;
    out.ratio = c0 > 0 || fed > 0 ? out.outlet / feed : std::nan("");
  }
  meter.last = now;
  return out;
}

}  // namespace porefines::analysis
