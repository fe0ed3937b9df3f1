// SPDX-License-Identifier: MPL-2.0
// Keys of [[particles]] and [injection].
#include <fmt/format.h>

#include "config/item_key.hpp"
#include "config/sizes.hpp"

namespace porefines::config {
namespace {

constexpr Range densities{0, 1e5, true};
constexpr Range moduli{0, 1e13, true};
constexpr Range poisson_ratios{0, 0.5};
constexpr Range counts{1, 1e9};
constexpr Range shares{0, 1, true};
constexpr Range speeds{0, 1e3, true};
constexpr Range flow_rates{0, 1e3, true};

ItemKey<Particles> diameter_item() {
  return {
      "diameter",
      "length, or `{ mean = \"5 um\", standard_deviation = \"0.5 um\" }`",
      "also with `distribution` (`\"normal\"`, `\"lognormal\"`, `\"table\"` with `diameters` and "
      "`shares`), `smallest` and `largest` (three standard deviations from the mean), and `by`: "
      "`\"number\"` or `\"volume\"`",
      [](Particles& p, const Node& node, const Case&) { p.diameter = read_sizes(node); },
      [](const Particles& p) { return write_sizes(p.diameter); },
      "required without source"};
}

ItemKey<Particles> count_item() {
  return {"count",
          "whole number, " + counts.text(),
          "particles placed at the start",
          [](Particles& p, const Node& node, const Case&) { p.count = read_integer(node, counts); },
          [](const Particles& p) { return p.count > 0 ? std::to_string(p.count) : ""; },
          "none"};
}

/// pulses = { period = "1 s", duration = "0.2 s" }
void read_pulses(Injection& injection, const Node& node, const Case&) {
  constexpr auto example = "{ period = \"1 s\", duration = \"0.2 s\" }";
  (void)read_table(node, {"period", "duration"});
  const Node* period = find(node, "period");
  const Node* duration = find(node, "duration");
  if (period == nullptr || duration == nullptr) {
    fail(node.place, "needs both period and duration", example);
  }
  injection.pulse_period = read_quantity(*period, kind::time, above_zero);
  injection.pulse_duration = read_quantity(*duration, kind::time, above_zero);
  if (injection.pulse_duration > injection.pulse_period) {
    fail(node.place, "a pulse is longer than its period", example);
  }
}

std::string write_pulses(const Injection& injection) {
  return injection.pulse_period > 0
             ? fmt::format("{{ period = {}, duration = {} }}",
                           toml_quantity(injection.pulse_period, kind::time),
                           toml_quantity(injection.pulse_duration, kind::time))
             : "";
}

/// One of the three ways to say how much; that one is given is checked in validate().
ItemKey<Injection> amount_item(const std::string& name, Concentration concentration,
                               const QuantityKind& wanted, Range range, const std::string& doc) {
  return {name,
          wanted.si_unit.empty() ? "number, " + range.text()
                                 : fmt::format("{}, e.g. `\"{}\"`", wanted.name, wanted.example),
          doc,
          [=](Injection& injection, const Node& node, const Case&) {
            injection.kind = concentration;
            injection.value = read_quantity(node, wanted, range);
          },
          [=](const Injection& injection) -> std::string {
            return injection.kind == concentration && injection.value > 0
                       ? toml_quantity(injection.value, wanted)
                       : "";
          },
          "one of three"};
}

}  // namespace

Key particles_key() {
  using P = Particles;
  const auto placed = [](const P& p) {
    return p.count > 0 || p.fill > 0 || p.filling == Filling::dense;
  };
  std::vector<ItemKey<P>> items{
      text_item("name", &P::name, "", "how other tables call this species"),
      diameter_item(),
      quantity_item("density", &P::density, kind::density, densities, "", "mass density"),
      quantity_item("young", &P::young, kind::pressure, moduli, "",
                    "Young's modulus; a softer one affords larger steps, see contact.max_overlap"),
      quantity_item("poisson", &P::poisson, kind::number, poisson_ratios, "", "Poisson's ratio"),
      path_item("source", &P::source, "none",
                "particles at the start: a CSV file with the columns `x_m,y_m,z_m,diameter_m` and, "
                "if wanted, `u_m_s,v_m_s,w_m_s` (or `u,v,w`); relative to the case file"),
      count_item(),
      quantity_item("fill", &P::fill, kind::number, shares, "none",
                    "particles placed at the start: share of the region's volume that they take"),
      only_where(placed, choice_item("filling", &P::filling, {"loose", "dense"},
                                     "how `count` or `fill` are placed: at random without contact, "
                                     "or as a random dense packing at rest")),
      region_item("region", &P::region, "the whole box", "where `count` or `fill` are placed"),
      only_where(placed, triple_item("velocity", &P::velocity, kind::velocity,
                                     "at the start, of those that are placed")),
      flag_item("fixed", &P::fixed, "held where they are; force and torque are recorded"),
      only_where([](const P& p) { return !p.fixed; },
                 triple_item("force", &P::force, kind::force, "on each, besides gravity"))};
  return list_key("particles", &Case::particles, items,
                  "A species of particles, and where its particles are at the start");
}

Key injection_key() {
  using I = Injection;
  std::vector<ItemKey<I>> items{
      text_item("species", &I::species, "the only species", "name of a [[particles]]"),
      choice_item("face", &I::face, face_names(), "the box face through which they enter"),
      amount_item("volume_fraction", Concentration::volume_fraction, kind::number,
                  Range{0, 0.6, true},
                  "volume of particles in the volume of suspension that enters"),
      amount_item("mass_fraction", Concentration::mass_fraction, kind::number, Range{0, 0.9, true},
                  "mass of particles in the mass of suspension that enters"),
      amount_item("rate", Concentration::rate, kind::frequency, above_zero, "particles per time"),
      quantity_item("start", &I::start, kind::time, not_negative, "", "when it begins"),
      quantity_item("stop", &I::stop, kind::time, above_zero, "the end of the run", "when it ends"),
      {"pulses", "`{ period = \"1 s\", duration = \"0.2 s\" }`",
       "enter only in the first `duration` of each `period`, counted from `start`", read_pulses,
       write_pulses, "continuous"},
      quantity_item("velocity", &I::velocity, kind::velocity, speeds, "that of the flow",
                    "of particles that enter, inwards; needed without a flow"),
      quantity_item("flow_rate", &I::flow_rate, kind::flow_rate, flow_rates, "velocity x area",
                    "of suspension, for the fractions, without a flow"),
      region_item("region", &I::region, "the whole face",
                  "part of the face; what it says along the face's normal is ignored")};
  return list_key("injection", &Case::injection, items,
                  "Particles that enter through a face of the box");
}

}  // namespace porefines::config
