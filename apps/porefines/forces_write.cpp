// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "forces.hpp"
#include "io/provenance.hpp"
#include "report/draw_chart.hpp"

namespace porefines {
namespace {

using report::Curve;

constexpr Real nearest = 0.1e-9;  ///< [m] of tables and charts
constexpr Real none = config::not_given;

/// The farthest gap of the tables [m].
Real farthest(const ForceCurve& curve) {
  const Real layers = 8 / curve.law.layers.kappa;
  return curve.marks.secondary ? std::max(layers, 2 * curve.marks.secondary->gap) : layers;
}

std::string to_table(const ForceCurve& curve, Real thermal) {
  constexpr int count = 600;
  std::string text =
      "gap_m,van_der_waals_kT,double_layer_kT,born_kT,energy_kT,force_N,stiffness_N_m\n";
  const Real scale = curve.radius / thermal;
  for (int i = 0; i <= count; ++i) {
    const Real h = nearest * std::pow(farthest(curve) / nearest, static_cast<Real>(i) / count);
    const surface::Push push = curve.radius * curve.law.push(h);
    text += fmt::format("{:.6g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", h,
                        scale * curve.law.attraction.energy(h), scale * curve.law.layers.energy(h),
                        scale * curve.law.born.energy(h), scale * curve.law.energy(h), push.force,
                        push.stiffness);
  }
  return text;
}

/// Part of the plane of gap [m] and energy [kT]; beyond it a curve has left the picture.
struct Window {
  Real left;
  Real right;
  Real low;
  Real high;
};

/// The barrier with half of it below zero, or where there is none what the nearest gaps have.
Window whole(const ForceCurve& curve, Real thermal) {
  const surface::Landmarks& marks = curve.marks;
  const Real right = 6 / curve.law.layers.kappa;
  if (marks.barrier && marks.barrier->energy > 0) {
    const Real top = marks.barrier->energy / thermal;
    return {nearest, std::max(right, 3 * marks.barrier->gap), -0.6 * top, 1.3 * top};
  }
  const Real gap = marks.primary ? marks.primary->gap : 5 * nearest;
  const Real depth = curve.radius * curve.law.energy(gap) / thermal;
  return {nearest, right, 1.2 * std::min(depth, -0.3 * std::abs(depth)),
          1.2 * std::max(depth, 0.3 * std::abs(depth))};
}

Window around(const surface::Well& well, Real thermal) {
  const Real depth = well.energy / thermal;
  return {0.4 * well.gap, 2 * well.gap, 1.4 * depth, -0.7 * depth};
}

/// The total and its parts, divided by `unit` [J]. Born repulsion ends where it can no longer be told from zero.
std::vector<Curve> energies(const ForceCurve& curve, Real thermal, const Window& window,
                            Real unit) {
  constexpr int count = 1500;
  const Real visible = 0.003 * (window.high - window.low);
  std::vector<Curve> lines{
      {.name = "total"}, {.name = "van der Waals"}, {.name = "double layer"}, {.name = "Born"}};
  for (int i = 0; i <= count; ++i) {
    const Real h = window.left * std::pow(window.right / window.left, static_cast<Real>(i) / count);
    const std::array<Real, 4> values{curve.law.energy(h), curve.law.attraction.energy(h),
                                     curve.law.layers.energy(h), curve.law.born.energy(h)};
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Real value = curve.radius * values[k] / thermal;
      const bool shown = value >= window.low && value <= window.high && (k < 3 || value > visible);
      lines[k].x.push_back(h);
      lines[k].y.push_back(shown ? value * thermal / unit : none);
    }
  }
  std::erase_if(lines, [](const Curve& line) {
    return std::all_of(line.y.begin(), line.y.end(), [](Real y) { return std::isnan(y); });
  });
  return lines;
}

void draw(const std::string& path, const Forces& f, const ForceCurve& curve, const Window& window) {
  const std::string title =
      fmt::format("{}, {:.3g} um, {:.3g} mM", curve.title, 1e6 * f.file.particles.diameter,
                  f.file.colloid.ionic_strength);
  const bool large = std::max(window.high, -window.low) > 9999;
  const report::ChartStyle style{.title = title,
                                 .x_name = "gap",
                                 .x_unit = "m",
                                 .y_name = large ? "energy / 1000 kT" : "energy / kT"};
  const Real unit = large ? 1000 * f.thermal : f.thermal;
  report::write_picture(path, report::draw_chart(energies(curve, f.thermal, window, unit), style),
                        io::make_provenance(1, 0), title);
}

void set_curve(Json& json, const ForceCurve& curve, Real thermal) {
  const auto set = [&](const std::string& name, Real value) {
    json.set(curve.name + "_" + name, value);
  };
  const auto set_well = [&](const std::string& name, const std::optional<surface::Well>& well) {
    set(name + "_kT", well ? well->energy / thermal : none);
    set(name + "_gap_m", well ? well->gap : none);
    set(name + "_pull_N", well ? well->pull : none);
    set(name + "_pull_gap_m", well ? well->pull_gap : none);
  };
  set_well("primary_minimum", curve.marks.primary);
  set("barrier_kT", curve.marks.barrier ? curve.marks.barrier->energy / thermal : none);
  set("barrier_gap_m", curve.marks.barrier ? curve.marks.barrier->gap : none);
  set_well("secondary_minimum", curve.marks.secondary);
}

Json to_json(const Forces& f) {
  Json json;
  json.set("kT_J", f.thermal);
  json.set("debye_length_m", f.debye_length);
  json.set("diffusivity_m2_s", f.diffusivity);
  for (const ForceCurve& curve : f.curves) {
    set_curve(json, curve, f.thermal);
  }
  if (f.adhesion) {
    json.set("jkr_pull_off_N", f.adhesion->jkr);
    json.set("dmt_pull_off_N", f.adhesion->dmt);
    json.set("jkr_contact_radius_m", f.adhesion->contact_radius);
    json.set("tabor_number", f.adhesion->tabor);
  }
  json.set("lever_m", f.lever);
  for (const Detachment& d : f.detachments) {
    std::string name = "critical_shear_stress_" + d.held_by + "_Pa";
    std::replace(name.begin(), name.end(), ' ', '_');
    json.set(name, d.stress);
  }
  if (f.filtration) {
    json.set("collector_efficiency", f.filtration->efficiency.total());
    json.set("collector_efficiency_diffusion", f.filtration->efficiency.diffusion);
    json.set("collector_efficiency_interception", f.filtration->efficiency.interception);
    json.set("collector_efficiency_gravity", f.filtration->efficiency.gravity);
    json.set("collector_efficiency_rajagopalan_tien", f.filtration->rajagopalan_tien);
    json.set("collector_interception_happel", f.filtration->happel_interception);
    json.set("filtration_coefficient_per_m", f.filtration->coefficient);
  }
  for (const auto& [name, value] : io::entries(io::make_provenance(1, 0))) {
    json.set(name, value);
  }
  return json;
}

}  // namespace

std::vector<std::string> write_forces(const std::string& folder, const Forces& f) {
  make_folder(folder);
  std::vector<std::string> names{"summary.json"};
  write_file(folder + "/summary.json", to_json(f).text());
  for (const ForceCurve& curve : f.curves) {
    names.push_back(curve.name + ".csv");
    write_file(folder + "/" + names.back(), to_table(curve, f.thermal));
    names.push_back(curve.name + ".png");
    draw(folder + "/" + names.back(), f, curve, whole(curve, f.thermal));
    if (curve.marks.secondary) {
      names.push_back(curve.name + "_minimum.png");
      draw(folder + "/" + names.back(), f, curve, around(*curve.marks.secondary, f.thermal));
    }
  }
  return names;
}

}  // namespace porefines
