// SPDX-License-Identifier: MPL-2.0
#include "report/draw_geometry.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "report/picture_parts.hpp"
#include "report/picture_text.hpp"

namespace porefines::report {
namespace {

const cv::Scalar ink(40, 42, 46);
constexpr Rgb pore_colour{244, 248, 251};
constexpr Rgb grain_colour{190, 172, 146};
constexpr Rgb edge_colour{112, 96, 76};
constexpr Rgb closed_colour{226, 120, 92};   // pore that carries no flow, filled
constexpr Rgb opened_colour{150, 205, 150};  // grain opened to pore

/// The plane that is drawn: axes to the right and up, and the voxel along the third.
struct Cut {
  std::array<int, 2> axes;
  int normal;
  int at;  ///< voxel along the normal

  [[nodiscard]] Int3 voxel(int u, int v) const {
    Int3 x{};
    x[static_cast<std::size_t>(axes[0])] = u;
    x[static_cast<std::size_t>(axes[1])] = v;
    x[static_cast<std::size_t>(normal)] = at;
    return x;
  }
};

Cut choose_cut(const GeometryView& view) {
  const Int3 n = view.kept.n;
  if (n[2] > 1 && axis_of(view.flow_to) == 2) {
    return {{2, 0}, 1, n[1] / 2};
  }
  return {{0, 1}, 2, n[2] / 2};
}

Rgb mix(const Rgb& a, const Rgb& b, Real t) {
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::lround(a[c] + t * (b[c] - a[c])));
  }
  return out;
}

/// What cleaning did to the drawn plane.
struct Changes {
  bool closed = false;
  bool opened = false;
};

/// Paint pore, grain and changes; `scale` is picture pixels per voxel.
Changes paint(cv::Mat& canvas, const cv::Rect& plot, const GeometryView& view, const Cut& cut,
              Real scale) {
  const Int3 n = view.kept.n;
  const Real pixel = view.solid->pixel;
  Changes changes;
  for (int y = 0; y < plot.height; ++y) {
    auto* const row = canvas.ptr<cv::Vec3b>(plot.y + y) + plot.x;
    const Real v = (plot.height - 1 - y + 0.5) / scale;
    for (int x = 0; x < plot.width; ++x) {
      const Real u = (x + 0.5) / scale;
      Vec3 at;
      at[cut.axes[0]] = u * pixel;
      at[cut.axes[1]] = v * pixel;
      at[cut.normal] = (cut.at + 0.5) * pixel;
      const Real s = geom::signed_distance(*view.solid, at) / pixel * scale;  // picture pixels
      const Int3 w =
          cut.voxel(std::min(static_cast<int>(u), n[static_cast<std::size_t>(cut.axes[0])] - 1),
                    std::min(static_cast<int>(v), n[static_cast<std::size_t>(cut.axes[1])] - 1));
      const bool found = view.found.at(w[0], w[1], w[2]);
      const bool kept = view.kept.at(w[0], w[1], w[2]);
      Rgb pore = pore_colour;
      Rgb grain = grain_colour;
      if (found && !kept) {
        grain = closed_colour;
        changes.closed = true;
      } else if (kept && !found) {
        pore = opened_colour;
        changes.opened = true;
      }
      const Real edge = std::clamp(1.8 - std::abs(s + 0.8), 0.0, 1.0);
      const Rgb c = mix(mix(grain, pore, std::clamp(0.5 + s, 0.0, 1.0)), edge_colour,
                        found && !kept ? 0 : 0.8 * edge);
      row[x] = {c[0], c[1], c[2]};
    }
  }
  return changes;
}

/// Widths at the ends of the colour bar: 2 % and 98 % of the throats.
ColourScale throat_scale(const std::vector<geom::Throat>& throats) {
  std::vector<Real> widths;
  for (const auto& throat : throats) {
    widths.push_back(throat.width);
  }
  std::sort(widths.begin(), widths.end());
  ColourScale scale{0, 1, false, Colormap::speed};
  if (!widths.empty()) {
    scale.high = widths[static_cast<std::size_t>(0.98 * static_cast<Real>(widths.size() - 1))];
  }
  return scale;
}

void draw_throats(cv::Mat& canvas, const cv::Rect& plot, const GeometryView& view, const Cut& cut,
                  Real scale, const ColourScale& colours) {
  constexpr int shift = 4;  // OpenCV's sixteenths of a pixel
  const Real pixel = view.solid->pixel;
  const auto place = [&](const Vec3& x) {
    const Real u = plot.x + x[cut.axes[0]] / pixel * scale - 0.5;
    const Real v = plot.y + plot.height - x[cut.axes[1]] / pixel * scale - 0.5;
    return cv::Point(static_cast<int>(std::lround(u * (1 << shift))),
                     static_cast<int>(std::lround(v * (1 << shift))));
  };
  cv::Mat area = canvas(plot);
  const auto inside = [&](cv::Point p) {
    return cv::Point(p.x - (plot.x << shift), p.y - (plot.y << shift));
  };
  const int thick = std::clamp(static_cast<int>(std::lround(plot.width / 420.0)), 2, 4);
  for (const auto& throat : *view.throats) {
    const Real off = std::abs(throat.centre[cut.normal] / pixel - cut.at - 0.5);
    if (view.kept.n[2] > 1 && off > 2) {
      continue;
    }
    const Rgb c = colour(colours.colormap, 0.92 * colours.position(throat.width));
    const cv::Point a = inside(place(throat.from));
    const cv::Point b = inside(place(throat.to));
    cv::line(area, a, b, cv::Scalar(255, 255, 255), thick + 2, cv::LINE_AA, shift);
    cv::line(area, a, b, cv::Scalar(c[0], c[1], c[2]), thick, cv::LINE_AA, shift);
  }
}

/// A swatch with its name; returns where the next one starts.
int draw_key(cv::Mat& canvas, int x, int y, const Rgb& c, const std::string& name) {
  constexpr int side = 18;
  const cv::Rect box(x, y - side / 2, side, side);
  cv::rectangle(canvas, box, cv::Scalar(c[0], c[1], c[2]), cv::FILLED);
  cv::rectangle(canvas, box, ink, 1);
  const TextStyle text{.height = layout::text};
  draw_text(canvas, name, x + side + 9, y + static_cast<int>(layout::text / 2), text);
  return x + side + 9 + text_width(name, text) + 26;
}

}  // namespace

Picture draw_geometry(const GeometryView& view, const std::string& title, int longer_side) {
  const Cut cut = choose_cut(view);
  const int nu = view.kept.n[static_cast<std::size_t>(cut.axes[0])];
  const int nv = view.kept.n[static_cast<std::size_t>(cut.axes[1])];
  const Real scale = static_cast<Real>(longer_side) / std::max(nu, nv);
  const int width = std::max(static_cast<int>(std::lround(nu * scale)), 1);
  const int height = std::max(static_cast<int>(std::lround(nv * scale)), 1);

  const ColourScale colours = throat_scale(*view.throats);
  const PictureStyle style{.title = title, .quantity = "throat width", .unit = "m"};
  cv::Rect plot;
  cv::Mat canvas = start_canvas(width, height, style, colours, true, plot);
  const Changes changes = paint(canvas, plot, view, cut, scale);
  draw_throats(canvas, plot, view, cut, scale, colours);
  cv::rectangle(canvas, {plot.x - 1, plot.y - 1, plot.width + 2, plot.height + 2}, ink, 1);

  const int y = plot.y + plot.height + 34;
  const Real metres = view.solid->pixel / scale;
  draw_scale_bar(canvas, plot.x, y, plot.width, metres);
  int x = plot.x + plot.width / 2 - 130;
  x = draw_key(canvas, x, y, pore_colour, "pore");
  x = draw_key(canvas, x, y, grain_colour, "grain");
  if (changes.closed) {
    x = draw_key(canvas, x, y, closed_colour, "filled");
  }
  if (changes.opened) {
    draw_key(canvas, x, y, opened_colour, "opened");
  }
  draw_flow_arrow(canvas, plot.x + plot.width, y, cut.axes, view.flow_to);
  return to_picture(canvas);
}

}  // namespace porefines::report
