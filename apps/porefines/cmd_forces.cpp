// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "forces.hpp"
#include "ranks.hpp"

namespace porefines {
namespace {

/// "1.13 nm": a gap, a lever.
std::string nanometres(Real length) {
  return fmt::format("{:#.4g} nm", 1e9 * length);
}

/// "590 nN", "0.93 pN".
std::string newtons(Real force) {
  return force >= 0.1e-9 ? fmt::format("{:.4g} nN", 1e9 * force)
                         : fmt::format("{:.4g} pN", 1e12 * force);
}

void say_well(const char* name, const std::optional<surface::Well>& well, Real thermal,
              const char* why_not) {
  if (well) {
    fmt::print("  {:<18} {:.5g} kT at {}, a pull of {} frees it\n", name, well->energy / thermal,
               nanometres(well->gap), newtons(well->pull));
  } else {
    fmt::print("  {:<18} none{}\n", name, why_not);
  }
}

void say_curve(const ForceCurve& curve, Real thermal) {
  const surface::Landmarks& marks = curve.marks;
  fmt::print("{}\n", curve.title);
  const bool bottomless = curve.law.born.strength == 0 && curve.law.attraction.strength > 0;
  say_well("primary minimum", marks.primary, thermal,
           bottomless ? ": without born_diameter the energy has no bottom" : "");
  if (marks.barrier) {
    fmt::print("  {:<18} {:.5g} kT at {}\n", "barrier", marks.barrier->energy / thermal,
               nanometres(marks.barrier->gap));
  } else {
    fmt::print("  {:<18} none\n", "barrier");
  }
  say_well("secondary minimum", marks.secondary, thermal, "");
}

void say(const Forces& f) {
  fmt::print("kT                   {:.5e} J\n", f.thermal);
  fmt::print("Debye length         {}\n", nanometres(f.debye_length));
  fmt::print("diffusivity          {:.5g} m^2/s\n", f.diffusivity);
  for (const ForceCurve& curve : f.curves) {
    say_curve(curve, f.thermal);
  }
  if (f.adhesion) {
    fmt::print("adhesion to the wall {} (JKR), {} (DMT)\n", newtons(f.adhesion->jkr),
               newtons(f.adhesion->dmt));
    if (!std::isnan(f.adhesion->contact_radius)) {
      fmt::print("contact              radius {}, Tabor number {:.3g}\n",
                 nanometres(f.adhesion->contact_radius), f.adhesion->tabor);
    }
  }
  for (const Detachment& d : f.detachments) {
    fmt::print("rolls off at         {:.4g} Pa of wall stress, held by {} over a lever of {}\n",
               d.stress, d.held_by, nanometres(f.lever));
  }
  if (f.filtration) {
    const Filtration& n = *f.filtration;
    fmt::print(
        "collector            {:.4g}: diffusion {:.4g}, interception {:.4g}, gravity {:.4g}\n",
        n.efficiency.total(), n.efficiency.diffusion, n.efficiency.interception,
        n.efficiency.gravity);
    fmt::print("                     {:.4g} by Rajagopalan & Tien; interception {:.4g} by Happel\n",
               n.rajagopalan_tien, n.happel_interception);
    fmt::print("filtration           {:.4g} 1/m if every meeting lasts\n", n.coefficient);
  }
  for (const std::string& note : f.notes) {
    fmt::print("note: {}\n", note);
  }
}

}  // namespace

void add_forces(CLI::App& app, int& /*exit_code*/) {
  auto* command = app.add_subcommand("forces", "Surface forces of colloids: laws and curves");
  command->footer(
      "Examples:\n"
      "  porefines forces cases/dlvo/forces.toml\n"
      "  porefines forces cases/dlvo/forces.toml \"colloid.ionic_strength=1 mM\" -o out/fresh\n"
      "No run uses them yet. docs/forces.md explains file and laws.");
  struct Arguments {
    std::string file;
    std::vector<std::string> overrides;
    std::string output = "out/forces";
  };
  auto a = std::make_shared<Arguments>();
  command->add_option("FILE.toml", a->file, "particle, wall and liquid")->required();
  command->add_option("key=value", a->overrides, "values of the file");
  command->add_option("-o,--output", a->output, "output folder (out/forces)");
  command->callback([a] {
    require_one_rank("forces", "it takes a second");
    const Forces forces = find_forces(config::load_forces(a->file, a->overrides));
    const std::vector<std::string> names = write_forces(a->output, forces);
    say(forces);
    fmt::print("results              {}/{}\n", a->output, fmt::join(names, ", "));
  });
}

}  // namespace porefines
