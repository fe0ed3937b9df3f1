// SPDX-License-Identifier: MPL-2.0
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

using std::numbers::pi;

constexpr auto periodic_flow =
    "[flow]\nperiodic = [\"x\", \"y\", \"z\"]\npressure_gradient = \"1 Pa/m\"\n[[output]]\nkind = "
    "\"pictures\"\n";

/// Equal spheres at places [cells of the lattice] that fill `share` of a cube of 1 mm.
Job sphere_job(const std::string& lattice, const std::vector<Vec3>& places, Real share) {
  const Real radius = std::cbrt(3 * share / (4 * pi * static_cast<Real>(places.size())));
  std::string list;
  for (const Vec3& x : places) {
    list += fmt::format("{} {} {} {}\n", x.x, x.y, x.z, radius);
  }
  return {
      .name = fmt::format("{}_{:.3g}", lattice, share),
      .case_text = fmt::format(
          "title = \"{} array of spheres, solid fraction {:.3g}\"\n[geometry]\nkind = \"spheres\"\n"
          "source = \"grains.txt\"\nsize = [\"1 mm\", \"1 mm\", \"1 mm\"]\nlist_unit = \"1 mm\"\n"
          "[grid]\ncells = [48, 48, 48]\n{}",
          lattice, share, periodic_flow),
      .files = {{"grains.txt", list}}};
}

Comparison spheres() {
  Comparison c{
      .name = "spheres",
      .title = "Arrays of spheres",
      .quantity = "drag factor F/(6πμaU)",
      .along = "solid fraction",
      .reference =
          "Zick & Homsy 1982, recomputed to all digits shown; 48 cells per lattice constant",
      .logarithmic = true};
  const std::vector<Vec3> sc{{0.5, 0.5, 0.5}};
  const std::vector<Vec3> bcc{{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}};
  const std::vector<Vec3> fcc{
      {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
  struct Known {
    const char* lattice;
    const std::vector<Vec3>* places;
    Real share;
    Real factor;
  };
  for (const Known& known :
       {Known{"SC", &sc, 0.027, 2.007748}, Known{"SC", &sc, 0.064, 2.810198},
        Known{"SC", &sc, 0.125, 4.291589}, Known{"SC", &sc, 0.216, 7.441953},
        Known{"SC", &sc, 0.343, 15.39949}, Known{"SC", &sc, 0.45, 28.0863},
        Known{"SC", &sc, pi / 6, 42.1}, Known{"BCC", &bcc, 0.064, 2.88938},
        Known{"BCC", &bcc, 0.125, 4.44638}, Known{"BCC", &bcc, 0.343, 16.33507},
        Known{"FCC", &fcc, 0.064, 2.88875}, Known{"FCC", &fcc, 0.125, 4.44572},
        Known{"FCC", &fcc, 0.343, 16.63892}}) {
    c.rows.push_back({.label = fmt::format("{}, {:.3g}", known.lattice, known.share),
                      .x = known.share,
                      .job = c.jobs.size(),
                      .source = FromSummary{"drag_coefficient_mean"},
                      .reference = known.factor,
                      .tolerance = 0.005});
    c.jobs.push_back(sphere_job(known.lattice, *known.places, known.share));
  }
  return c;
}

/// One cylinder in a square cell, or two in a hexagonal one of 1 x sqrt(3).
Job cylinder_job(bool hexagonal, Real share) {
  const Real high = hexagonal ? std::numbers::sqrt3 : 1;
  const Real radius = std::sqrt(share * high / (pi * (hexagonal ? 2 : 1)));
  std::string list = fmt::format("0.5 {} {}\n", high / (hexagonal ? 4 : 2), radius);
  if (hexagonal) {
    list += fmt::format("0 {} {}\n", 3 * high / 4, radius);
  }
  const int across = share > 0.6 ? 128 : 64;  // narrow gaps
  const auto up = std::lround(across * high);
  return {
      .name = fmt::format("{}_{}", hexagonal ? "hexagonal" : "square", share),
      .case_text = fmt::format(
          "title = \"Array of cylinders, solid fraction {}\"\n[geometry]\nkind = \"cylinders\"\n"
          "source = \"grains.txt\"\nsize = [\"1 mm\", \"{} mm\", \"0.0625 mm\"]\nlist_unit = \"1 "
          "mm\"\n"
          "[grid]\ncells = [{}, {}, {}]\n{}",
          share, high, across, up, across / 16, periodic_flow),
      .files = {{"grains.txt", list}}};
}

Comparison cylinders() {
  Comparison c{.name = "cylinders",
               .title = "Arrays of cylinders, flow across",
               .quantity = "drag per length F/(μU)",
               .along = "solid fraction",
               .reference =
                   "Sangani & Acrivos 1982, recomputed to all digits shown; 64 cells per period, "
                   "128 above 0.6",
               .logarithmic = true};
  struct Known {
    bool hexagonal;
    Real share;
    Real drag;
  };
  for (const Known& known :
       {Known{false, 0.05, 15.5578}, Known{false, 0.1, 24.8317}, Known{false, 0.2, 51.527},
        Known{false, 0.3, 102.88}, Known{false, 0.4, 217.89}, Known{false, 0.5, 532.55},
        Known{false, 0.6, 1763.6}, Known{false, 0.7, 13518}, Known{true, 0.05, 15.7377},
        Known{true, 0.1, 25.1320}, Known{true, 0.2, 51.1477}, Known{true, 0.4, 185.77},
        Known{true, 0.7, 2769.9}}) {
    c.rows.push_back(
        {.label = fmt::format("{}, {}", known.hexagonal ? "hexagonal" : "square", known.share),
         .x = known.share,
         .job = c.jobs.size(),
         .source = FromSummary{"drag_per_length_over_viscosity_velocity"},
         .reference = known.drag,
         .tolerance = 0.005});
    c.jobs.push_back(cylinder_job(known.hexagonal, known.share));
  }
  return c;
}

Job channel_job(const std::string& name, int wide, int high, const std::string& walls) {
  return {.name = name,
          .case_text = fmt::format("title = \"Channel, {}\"\n[geometry]\nkind = \"empty\"\nsize = "
                                   "[\"20 um\", \"{} um\", \"20 um\"]\n"
                                   "[grid]\ncells = [32, {}, {}]\n[flow]\nperiodic = "
                                   "[\"x\"]\npressure_gradient = [\"1e4 Pa/m\", "
                                   "\"0 Pa/m\", \"0 Pa/m\"]\n{}[[output]]\nkind = \"pictures\"\n",
                                   name, 20 * wide, high * wide, high, walls)};
}

Comparison channels() {
  Comparison c{
      .name = "channels",
      .title = "Channels without grains",
      .quantity = "k/B², B the shorter side",
      .reference = "series solution; the chip 20 µm deep: h²/12 = 33.775 darcy; 32 cells across B"};
  constexpr Real b2 = 20e-6 * 20e-6;
  const std::string plates = "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n";
  const std::string duct = "walls = [\"y-\", \"y+\", \"z-\", \"z+\"]\n";
  c.jobs = {channel_job("slit", 1, 32, plates), channel_job("square", 1, 32, duct),
            channel_job("two_to_one", 2, 32, duct)};
  const std::array<Real, 3> exact{1.0 / 12, 0.0351442537, 0.0571704193};
  const std::array<const char*, 3> labels{"slit (a chip without grains)", "square duct",
                                          "duct 2 : 1"};
  for (std::size_t k = 0; k < 3; ++k) {
    c.rows.push_back({.label = labels[k],
                      .job = k,
                      .source = FromSummary{"permeability_m2", 1 / b2},
                      .reference = exact[k],
                      .tolerance = 0.005});
  }
  return c;
}

}  // namespace

void add_permeability(std::vector<Comparison>& list) {
  list.push_back(channels());
  list.push_back(spheres());
  list.push_back(cylinders());
}

}  // namespace porefines::validate
