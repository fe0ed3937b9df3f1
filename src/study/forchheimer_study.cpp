// SPDX-License-Identifier: MPL-2.0
#include "study/forchheimer_study.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "analysis/forchheimer.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/json_read.hpp"
#include "io/provenance.hpp"
#include "io/read_table.hpp"
#include "report/draw_chart.hpp"

namespace porefines::study {
namespace {

using analysis::InertiaFit;
using analysis::Measured;
using analysis::SweepFluid;
using analysis::SweepPoint;

struct Sweep {
  std::vector<SweepPoint> points;
  SweepFluid fluid;
};

Sweep read_sweep(const std::string& folder) {
  const std::string path = folder + "/members.csv";
  const io::TextTable table = io::read_table(path);
  io::require_columns(table, path, {"folder", "status"});
  const std::vector<std::string> folders = table.texts("folder");
  const std::vector<std::string> status = table.texts("status");
  Sweep sweep;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string member = fmt::format("{}/members/{}/summary.json", folder, folders[i]);
    const auto summary = status[i] == "done" ? read_flat_json(member) : std::nullopt;
    if (!summary) {
      continue;
    }
    const std::string* regime = summary->find("regime");
    if (regime == nullptr || *regime != "navier-stokes") {
      throw InputError(
          fmt::format("{}: is no flow with inertia, whose permeability depends on its speed\n"
                      "set = [\"flow.regime=navier-stokes\"] in the study",
                      member));
    }
    const SweepFluid fluid{summary->number("fluid_density_kg_m3"),
                           summary->number("fluid_viscosity_pa_s")};
    if (!sweep.points.empty() &&
        (fluid.density != sweep.fluid.density || fluid.viscosity != sweep.fluid.viscosity)) {
      throw InputError(
          fmt::format("{}: has another fluid than the members before it\n"
                      "sweep pressures, rates or velocities alone",
                      member));
    }
    sweep.fluid = fluid;
    sweep.points.push_back(
        {std::abs(summary->number("darcy_velocity_m_s")),
         std::abs(summary->number("pressure_drop_pa")) / summary->number("length_m")});
  }
  return sweep;
}

Json to_json(const InertiaFit& fit, const SweepFluid& fluid) {
  Json json;
  const auto set = [&](const std::string& name, const std::string& unit, const Measured& m) {
    json.set(name + unit, m.value);
    json.set(name + "_standard_error" + unit, m.error);
  };
  set("permeability", "_m2", fit.permeability);
  set("forchheimer_permeability", "_m2", fit.forchheimer_permeability);
  set("beta", "_per_m", fit.beta);
  set("exponent", "", fit.exponent);
  json.set("darcy_end_m_s", fit.darcy_end);
  json.set("darcy_end_reynolds", fit.darcy_end_reynolds);
  json.set("darcy_end_excess", analysis::darcy_excess);
  json.set("slow_points", static_cast<Index>(fit.slow));
  json.set("fast_points", static_cast<Index>(fit.fast));
  json.set("fluid_density_kg_m3", fluid.density);
  json.set("fluid_viscosity_pa_s", fluid.viscosity);
  for (const auto& [name, value] : io::entries(io::make_provenance(1, 0))) {
    json.set(name, value);
  }
  return json;
}

std::string to_table(const InertiaFit& fit, const SweepFluid& fluid) {
  std::string text =
      "velocity_m_s,gradient_pa_m,reynolds,excess,apparent_permeability_m2,slow_law_pa_m,"
      "forchheimer_pa_m\n";
  for (std::size_t i = 0; i < fit.points.size(); ++i) {
    const auto& [u, gradient] = fit.points[i];
    text += fmt::format("{},{},{},{},{},{},{}\n", u, gradient, fit.reynolds[i], fit.excess[i],
                        fluid.viscosity * u / gradient, analysis::slow_gradient(fit, fluid, u),
                        analysis::fast_gradient(fit, fluid, u));
  }
  return text;
}

/// What the gradient is above Darcy's, against Re.
void draw(const std::string& path, const InertiaFit& fit, const SweepFluid& fluid) {
  constexpr int count = 200;
  using report::Curve;
  Curve runs{.name = "runs", .look = Curve::Look::points};
  runs.x = fit.reynolds;
  runs.y = fit.excess;
  Curve slow{.name = "slow law"};
  Curve fast{.name = "Forchheimer", .look = Curve::Look::dashed};
  const Real first = fit.points.front().velocity;
  const Real range = fit.points.back().velocity / first;
  for (int i = 0; i <= count; ++i) {
    const Real u = first * std::pow(range, static_cast<Real>(i) / count);
    const Real darcy = fluid.viscosity * u / fit.permeability.value;
    const Real excess = analysis::slow_gradient(fit, fluid, u) / darcy - 1;
    slow.x.push_back(fit.reynolds.front() * u / first);
    slow.y.push_back(excess < 2 * analysis::darcy_excess ? excess : std::nan(""));
    fast.x.push_back(slow.x.back());
    fast.y.push_back(analysis::fast_gradient(fit, fluid, u) / darcy - 1);
  }
  std::vector<Curve> curves{runs, slow};
  if (std::isfinite(fit.beta.value)) {
    curves.push_back(fast);
  }
  report::write_picture(path,
                        report::draw_chart(curves, {.title = "Departure from Darcy's law",
                                                    .x_name = "Re = rho U sqrt(k) / mu",
                                                    .y_name = "gradient over Darcy's, less 1",
                                                    .logarithmic = true}),
                        io::make_provenance(1, 0), "Departure from Darcy's law");
}

void say(const InertiaFit& fit) {
  fmt::print("k          {:.5g} m^2 (+- {:.2g}), from {} points\n", fit.permeability.value,
             fit.permeability.error, fit.slow);
  fmt::print("slow law   dp/L = mu U/k (1 + {:.4g} Re^{:.3g}), Re = rho U sqrt(k)/mu\n", fit.c,
             fit.exponent.value);
  if (std::isfinite(fit.beta.value)) {
    fmt::print("beta       {:.5g} 1/m (+- {:.2g}), k_F {:.5g} m^2, from {} points\n",
               fit.beta.value, fit.beta.error, fit.forchheimer_permeability.value, fit.fast);
  } else {
    fmt::print("beta       unknown: {} points are {:.0f} % and more above Darcy's law, 3 needed\n",
               fit.fast, 100 * analysis::darcy_excess);
  }
  if (std::isfinite(fit.darcy_end)) {
    fmt::print("Darcy      ends at {:.4g} m/s, Re {:.3g}: {:.0f} % more gradient\n", fit.darcy_end,
               fit.darcy_end_reynolds, 100 * analysis::darcy_excess);
  }
}

}  // namespace

bool is_study(const std::string& folder) {
  return std::filesystem::exists(folder + "/study.json");
}

void fit_sweep(const std::string& folder, const std::string& output) {
  const Sweep sweep = read_sweep(folder);
  const InertiaFit fit = analysis::fit_inertia(sweep.points, sweep.fluid);
  make_folder(output);
  write_file(output + "/forchheimer.json", to_json(fit, sweep.fluid).text());
  write_file(output + "/forchheimer.csv", to_table(fit, sweep.fluid));
  draw(output + "/forchheimer.png", fit, sweep.fluid);
  say(fit);
  fmt::print("results    {}/forchheimer.json, forchheimer.csv, forchheimer.png\n", output);
}

}  // namespace porefines::study
