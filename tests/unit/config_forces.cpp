// SPDX-License-Identifier: MPL-2.0
// The file of `porefines forces`.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "config/forces_file.hpp"
#include "core/error.hpp"

namespace porefines::config {
namespace {

const std::string shortest = R"([colloid]
hamaker = "1e-20 J"
zeta_particle = "-40 mV"
zeta_wall = "-30 mV"
ionic_strength = "10 mM"

[particles]
diameter = "5 um"
)";

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse_forces(text, "f.toml", overrides);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ForcesFile, is_read_into_si_with_defaults) {
  const ForcesFile file = parse_forces(shortest, "f.toml");
  EXPECT_DOUBLE_EQ(file.colloid.ionic_strength, 10);
  EXPECT_DOUBLE_EQ(file.colloid.zeta_particle, -0.04);
  EXPECT_DOUBLE_EQ(file.colloid.hamaker_particles, 1e-20);
  EXPECT_DOUBLE_EQ(file.colloid.wavelength, 100e-9);
  EXPECT_DOUBLE_EQ(file.colloid.temperature, 293.15);
  EXPECT_DOUBLE_EQ(file.fluid.viscosity, 1.002e-3);
  EXPECT_EQ(file.colloid.model, DoubleLayer::hhf);
  EXPECT_EQ(file.colloid.born_diameter, 0);
  EXPECT_FALSE(file.collector);
}

TEST(ForcesFile, takes_every_key) {
  const ForcesFile file = parse_forces(
      shortest, "f.toml",
      {"colloid.model=superposition", "colloid.temperature=25 degC", "colloid.permittivity=78.4",
       "colloid.born_diameter=0.5 nm", "colloid.work_of_adhesion=50 mJ/m^2",
       "colloid.roughness=5 nm", "colloid.hamaker_particles=2e-20 J", "colloid.wavelength=1 m",
       "colloid.ionic_strength=1 mM", "particles.density=2.65 g/cm^3", "particles.young=3.4 GPa",
       "particles.poisson=0.3", "contact.wall_young=70 GPa", "fluid.viscosity=0.8903 mPa s",
       "fluid.density=997 kg/m^3", "collector.diameter=0.6 mm", "collector.porosity=0.39",
       "collector.velocity=9 um/s"});
  EXPECT_EQ(file.colloid.model, DoubleLayer::superposition);
  EXPECT_DOUBLE_EQ(file.colloid.temperature, 298.15);
  EXPECT_DOUBLE_EQ(file.colloid.permittivity, 78.4);
  EXPECT_DOUBLE_EQ(file.colloid.born_diameter, 0.5e-9);
  EXPECT_DOUBLE_EQ(file.colloid.work_of_adhesion, 0.05);
  EXPECT_DOUBLE_EQ(file.colloid.roughness, 5e-9);
  EXPECT_DOUBLE_EQ(file.colloid.hamaker_particles, 2e-20);
  EXPECT_DOUBLE_EQ(file.colloid.wavelength, 1);
  EXPECT_DOUBLE_EQ(file.colloid.ionic_strength, 1);
  EXPECT_DOUBLE_EQ(file.particles.density, 2650);
  EXPECT_DOUBLE_EQ(file.particles.young, 3.4e9);
  EXPECT_DOUBLE_EQ(file.contact.wall_young, 70e9);
  EXPECT_DOUBLE_EQ(file.contact.wall_poisson, 0.3) << "that of the particle";
  EXPECT_DOUBLE_EQ(file.fluid.density, 997);
  EXPECT_DOUBLE_EQ(file.fluid.viscosity, 0.8903e-3);
  ASSERT_TRUE(file.collector);
  EXPECT_DOUBLE_EQ(file.collector->diameter, 0.6e-3);
  EXPECT_DOUBLE_EQ(file.collector->porosity, 0.39);
  EXPECT_DOUBLE_EQ(file.collector->velocity, 9e-6);
}

TEST(ForcesFile, says_where_and_what_is_wrong) {
  EXPECT_EQ(message_of("[colloid]\nhamacker = \"1e-20 J\"\n"),
            "f.toml:2: [colloid] hamacker: unknown key; did you mean hamaker?");
  EXPECT_EQ(message_of("[colloid]\nhamaker = \"1e-20 N\"\n"),
            "f.toml:2: [colloid] hamaker wants an energy such as \"9e-21 J\", found \"1e-20 N\" "
            "(a force)");
  EXPECT_EQ(message_of(shortest, {"colloid.ionic_strength=10"}),
            "command line: colloid.ionic_strength wants a concentration such as \"10 mmol/L\", "
            "found 10\na bare number has no unit; if SI is meant, write \"10 mol/m^3\"");
  EXPECT_EQ(message_of(shortest, {"colloid.ionic_strength=0 M"}),
            "command line: colloid.ionic_strength: \"0 M\" is out of range, allowed is from "
            "1e-05 mol/m^3 to 10000 mol/m^3\nfor example \"10 mmol/L\"");
  EXPECT_EQ(message_of(shortest, {"colloid.model=hfh"}),
            "command line: colloid.model wants \"hhf\" or \"superposition\", "
            "found \"hfh\"\ndid you mean \"hhf\"?");
  EXPECT_EQ(message_of("[colloid]\n"),
            "f.toml:1: [colloid] hamaker: is required\nenergy, e.g. `\"9e-21 J\"`");
  EXPECT_EQ(message_of(shortest + "[surfaces]\nx = 1\n"),
            "f.toml:9: [surfaces]: unknown table\n"
            "known here: colloid, particles, contact, fluid, collector");
}

TEST(ForcesFile, misses_what_belongs_together) {
  EXPECT_TRUE(message_of(shortest, {"collector.diameter=1 mm"})
                  .starts_with("command line: collector.porosity: is required"))
      << message_of(shortest, {"collector.diameter=1 mm"});
  EXPECT_TRUE(message_of(shortest, {"colloid.hamaker=0 J", "collector.diameter=1 mm",
                                    "collector.porosity=0.4", "collector.velocity=1 um/s"})
                  .starts_with("command line: colloid.hamaker: is 0"));
  EXPECT_TRUE(message_of(shortest, {"particles.young=1 GPa"})
                  .starts_with("command line: particles.young: has no use without adhesion\n"));
  EXPECT_TRUE(message_of(shortest, {"contact.wall_young=1 GPa"})
                  .starts_with("command line: contact.wall_young: has no use without"));
}

TEST(ForcesFile, keys_are_documented) {
  std::ifstream page(PF_SOURCE_DIR "/docs/forces.md");
  std::ostringstream text;
  text << page.rdbuf();
  EXPECT_NE(text.str().find(forces_reference()), std::string::npos)
      << "the table of keys of docs/forces.md should be\n"
      << forces_reference();
}

}  // namespace
}  // namespace porefines::config
