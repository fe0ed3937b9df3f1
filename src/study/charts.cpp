// SPDX-License-Identifier: MPL-2.0
// The charts of a study.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/provenance.hpp"
#include "report/draw_chart.hpp"
#include "study/groups.hpp"

namespace porefines::study {
namespace {

using report::ChartStyle;
using report::Curve;

/// Saves what there is to see.
struct Album {
  const std::string& output;
  const Study& study;
  std::vector<std::string> names = {};

  void add(const std::string& name, const std::vector<Curve>& curves, ChartStyle style) {
    const bool empty = std::all_of(curves.begin(), curves.end(),
                                   [](const Curve& curve) { return curve.x.empty(); });
    if (!empty) {
      style.title = study.title.empty() ? style.title : style.title + ": " + study.title;
      report::write_picture(output + "/" + name + ".png", report::draw_chart(curves, style),
                            io::make_provenance(study.ranks, 0), style.title);
      names.push_back(name + ".png");
    }
  }
};

/// Values of the axes after the first, which tell the curves apart.
std::string others(const Study& study, const Group& group) {
  std::string text;
  for (std::size_t a = 1; a < study.axes.size(); ++a) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", study.axes[a].name,
                        study.axes[a].points[group.at[a]].label);
  }
  return text;
}

/// A number of every group against the first axis; a curve for each combination of the others.
template <typename Read>
std::vector<Curve> against_first_axis(const Study& study, const std::vector<Group>& groups,
                                      const Read& read) {
  std::vector<Curve> curves;
  for (const Group& group : groups) {
    const analysis::Estimate e = read(group);
    if (!std::isfinite(e.value)) {
      continue;
    }
    const std::string name = others(study, group);
    auto curve =
        std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.name == name; });
    if (curve == curves.end()) {
      curve = curves.insert(curves.end(), Curve{.name = name});
    }
    curve->x.push_back(study.axes.front().points[group.at.front()].at);
    curve->y.push_back(e.value);
    curve->low.push_back(e.low);
    curve->high.push_back(e.high);
  }
  for (Curve& curve : curves) {
    curve.look = curve.x.size() > 1 ? Curve::Look::line : Curve::Look::points;
  }
  return curves;
}

/// Steps down at every event, from 1 at zero.
Curve staircase(const std::string& name, const std::vector<analysis::SurvivalStep>& steps,
                Real end) {
  Curve curve{.name = name, .x = {0}, .y = {1}, .low = {1}, .high = {1}};
  const auto add = [&](Real x, Real y, Real low, Real high) {
    curve.x.push_back(x);
    curve.y.push_back(y);
    curve.low.push_back(low);
    curve.high.push_back(high);
  };
  for (const analysis::SurvivalStep& step : steps) {
    add(step.at, curve.y.back(), curve.low.back(), curve.high.back());
    add(step.at, step.survival, step.low, step.high);
  }
  add(std::max(end, curve.x.back()), curve.y.back(), curve.low.back(), curve.high.back());
  return curve;
}

/// Survival curves of all groups.
std::vector<Curve> survival(const Study& study, const std::vector<Group>& groups,
                            const std::vector<analysis::Lifetime> Group::*lives) {
  std::vector<Curve> curves;
  for (const Group& group : groups) {
    if ((group.*lives).empty()) {
      continue;
    }
    Real end = 0;
    for (const analysis::Lifetime& life : group.*lives) {
      end = std::max(end, life.at);
    }
    curves.push_back(
        staircase(group.name, analysis::kaplan_meier(group.*lives, study.confidence), end));
  }
  return curves;
}

Curve band_curve(const Group& group, std::size_t kind) {
  Curve curve{.name = group.name};
  for (const analysis::BandPoint& point : group.bands[kind]) {
    curve.x.push_back(point.x);
    curve.y.push_back(point.mean.value);
    curve.low.push_back(point.mean.low);
    curve.high.push_back(point.mean.high);
  }
  return curve;
}

void draw_curves(Album& album, const std::vector<Group>& groups) {
  for (std::size_t k = 0; k < curve_kinds.size(); ++k) {
    std::vector<Curve> curves;
    for (const Group& group : groups) {
      curves.push_back(band_curve(group, k));
    }
    const CurveKind& kind = curve_kinds[k];
    album.add(kind.name, curves,
              {.title = kind.title,
               .x_name = kind.x_name,
               .x_unit = kind.x_unit,
               .y_name = kind.y_name,
               .y_unit = kind.y_unit});
  }
}

}  // namespace

std::vector<std::string> draw_charts(const std::string& output, const Study& study,
                                     const std::vector<Group>& groups) {
  Album album{output, study};
  if (!study.axes.empty()) {
    const Axis& axis = study.axes.front();
    const ChartStyle style{.x_name = axis.name, .x_unit = axis.unit};
    ChartStyle clogging = style;
    clogging.title = "Clogging probability";
    clogging.y_name = "share of runs that clog";
    album.add("clogging_probability",
              against_first_axis(study, groups,
                                 [](const Group& g) {
                                   return g.clogs
                                              ? analysis::Estimate{g.clogged.share, g.clogged.low,
                                                                   g.clogged.high}
                                              : analysis::Estimate{std::nan(""), 0, 0};
                                 }),
              clogging);
    for (std::size_t k = 0; k < study.readings.size(); ++k) {
      ChartStyle reading = style;
      reading.title = reading.y_name = study.readings[k];
      album.add(study.readings[k],
                against_first_axis(study, groups, [k](const Group& g) { return g.readings[k]; }),
                reading);
    }
  }
  album.add("survival_escapees", survival(study, groups, &Group::escapees),
            {.title = "Not clogged yet", .x_name = "escapees", .y_name = "share of runs"});
  album.add(
      "survival_time", survival(study, groups, &Group::time),
      {.title = "Not clogged yet", .x_name = "time", .x_unit = "s", .y_name = "share of runs"});
  draw_curves(album, groups);
  return album.names;
}

}  // namespace porefines::study
