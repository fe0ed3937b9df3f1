// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "io/provenance.hpp"
#include "report/draw_chart.hpp"
#include "study/fit_run.hpp"

namespace porefines::study {
namespace {

using analysis::Filtration;
using report::Curve;

constexpr int model_points = 200;
constexpr Real few_pores = 20;  ///< below, a sample has no bed to average over
constexpr std::uint64_t seed = 1;

void draw(const std::string& path, const std::string& title, const Curve& data, const Curve& model,
          const std::array<std::string, 3>& names) {
  report::write_picture(
      path,
      report::draw_chart(
          {data, model},
          {.title = title, .x_name = names[0], .x_unit = names[1], .y_name = names[2]}),
      io::make_provenance(1, 0), title);
}

/// The model between 0 and `end`.
template <typename Model>
Curve model_curve(Real end, const Model& model) {
  Curve curve{.name = "model"};
  for (int i = 0; i <= model_points; ++i) {
    curve.x.push_back(end * i / model_points);
    curve.y.push_back(model(curve.x.back()));
  }
  return curve;
}

void draw_all(const std::string& output, const RunBed& run, const Filtration& f) {
  const auto& [bed, data, pores] = run;
  const Real last = data.volumes.back();
  const auto dots = [](const std::vector<Real>& x, const std::vector<Real>& y) {
    return Curve{.name = "run", .x = x, .y = y, .look = Curve::Look::points};
  };
  draw(output + "/fit_retention.png", "Retained fines along the flow", dots(data.x, data.s),
       model_curve(bed.length,
                   [&](Real x) { return analysis::retained(bed, f.lambda, x, data.profile_at); }),
       {"x", "m", "volume per bulk volume"});
  draw(output + "/fit_breakthrough.png", "Breakthrough", dots(data.volumes, data.concentration),
       model_curve(
           last,
           [&](Real t) { return analysis::suspended(bed, f.lambda, bed.length, t) / bed.feed; }),
       {"pore volumes", "", "C/C0"});
  draw(output + "/fit_permeability.png", "Formation damage", dots(data.volumes, data.resistance),
       model_curve(last, [&](Real t) { return analysis::resistance_ratio(bed, f, t); }),
       {"pore volumes", "", "k0/k"});
}

Json to_json(const RunBed& run, const analysis::BedFit& fit, Real confidence) {
  Json json;
  const auto set = [&](const std::string& name, const analysis::Estimate& e, Real deviation) {
    json.set(name, e.value);
    json.set(name + "_low", e.low);
    json.set(name + "_high", e.high);
    json.set(name + "_standard_error", deviation);
  };
  set("lambda_per_m", fit.lambda, fit.lambda_deviation);
  set("beta", fit.beta, fit.beta_deviation);
  json.set("confidence", confidence);
  json.set("retention_misfit", fit.retention_misfit);
  json.set("breakthrough_misfit", fit.breakthrough_misfit);
  json.set("resistance_misfit", fit.resistance_misfit);
  json.set("length_m", run.bed.length);
  json.set("porosity", run.bed.porosity);
  json.set("feed_volume_fraction", run.bed.feed);
  json.set("pore_volumes", run.data.profile_at);
  json.set("length_in_pores", run.pores);
  for (const auto& [name, value] : io::entries(io::make_provenance(1, 0))) {
    json.set(name, value);
  }
  return json;
}

void say(const RunBed& run, const analysis::BedFit& fit, Real confidence) {
  fmt::print("lambda     {:.4g} 1/m ({:.4g} to {:.4g}): a fine goes {:.3g} lengths of the sample\n",
             fit.lambda.value, fit.lambda.low, fit.lambda.high,
             1 / (fit.lambda.value * run.bed.length));
  fmt::print("beta       {:.4g} ({:.4g} to {:.4g}): k0/k = 1 + beta s\n", fit.beta.value,
             fit.beta.low, fit.beta.high);
  fmt::print(
      "intervals  {:.0f} %; misfit: retention {:.2g}, breakthrough {:.2g}, k0/k {:.2g} of "
      "their means\n",
      100 * confidence, fit.retention_misfit, fit.breakthrough_misfit, fit.resistance_misfit);
  if (run.pores < few_pores) {
    fmt::print(
        "warning: the sample is {:.2g} pores long; a filtration coefficient means something "
        "over many: take it as a share caught per length\n",
        run.pores);
  }
  if (run.data.profile_at < 1) {
    fmt::print("warning: only {:.2g} pore volumes went through: no breakthrough to fit\n",
               run.data.profile_at);
  }
}

}  // namespace

void fit_run(const std::string& folder, const std::string& output, Real confidence, int resamples) {
  const RunBed run = read_run_bed(folder);
  const analysis::BedFit fit = analysis::fit_bed(run.bed, run.data, confidence, resamples, seed);
  make_folder(output);
  write_file(output + "/fit.json", to_json(run, fit, confidence).text());
  draw_all(output, run, {fit.lambda.value, fit.beta.value});
  say(run, fit, confidence);
  fmt::print(
      "results    {}/fit.json, fit_retention.png, fit_breakthrough.png, fit_permeability.png\n",
      output);
}

}  // namespace porefines::study
