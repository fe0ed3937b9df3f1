// SPDX-License-Identifier: MPL-2.0
// What a case says about particles, and what is wrong with it when it is.
#include <filesystem>

#include <gtest/gtest.h>

#include "config/reader.hpp"
#include "core/error.hpp"
#include "unit/config_cases.hpp"

namespace porefines::config {
namespace {

using test::box_case;
using test::dry_case;

TEST(ParticleConfig, reads_the_tables_of_the_style_example) {
  const Case c = parse_case(dry_case + R"([[particles]]
name        = "latex"
diameter    = { mean = "5.0 um", standard_deviation = "0.15 um", distribution = "normal" }
density     = "1050 kg/m^3"
young       = "30 MPa"
poisson     = 0.33
[injection]
species         = "latex"
face            = "x-"
volume_fraction = 0.01
start           = "2 ms"
stop            = "3 ms"
velocity        = "1 mm/s"
[contact]
model             = "hertz"
restitution       = 0.5
friction          = { particle_particle = 0.2, particle_wall = 0.1 }
rolling           = { model = "none" }
steps_per_contact = 30
max_overlap       = 0.01
[[output]]
kind     = "tracks"
every    = "10 ms"
[[output]]
kind     = "summary"
every    = "10 ms"
)",
                            "cases/a/case.toml");
  EXPECT_TRUE(is_dry(c));
  EXPECT_EQ(c.gravity, (Triple{0, 0, -9.81}));
  ASSERT_EQ(c.particles.size(), 2U);
  const Particles& latex = c.particles[1];
  EXPECT_EQ(latex.name, "latex");
  EXPECT_EQ(latex.diameter.law, SizeLaw::normal);
  EXPECT_DOUBLE_EQ(latex.diameter.mean, 5e-6);
  EXPECT_DOUBLE_EQ(latex.diameter.smallest, 4.55e-6);
  EXPECT_DOUBLE_EQ(latex.diameter.largest, 5.45e-6);
  EXPECT_DOUBLE_EQ(latex.young, 30e6);
  ASSERT_EQ(c.injection.size(), 1U);
  EXPECT_EQ(c.injection[0].kind, Concentration::volume_fraction);
  EXPECT_DOUBLE_EQ(c.injection[0].value, 0.01);
  EXPECT_DOUBLE_EQ(c.injection[0].stop, 3e-3);
  EXPECT_DOUBLE_EQ(c.contact.friction_particle, 0.2);
  EXPECT_DOUBLE_EQ(c.contact.friction_wall, 0.1);
  ASSERT_NE(find_output(c, OutputKind::summary), nullptr);
  EXPECT_DOUBLE_EQ(find_output(c, OutputKind::summary)->every, 0.01);
}

TEST(ParticleConfig, paths_start_at_the_case_file) {
  const Case c = parse_case(dry_case + "[[particles]]\nname = \"a\"\nsource = \"list.csv\"\n",
                            "cases/a/case.toml");
  EXPECT_EQ(c.particles[1].source, std::filesystem::absolute("cases/a/list.csv"));
}

TEST(ParticleConfig, one_item_of_a_list_is_replaced_from_the_command_line) {
  const Case c = parse_case(dry_case, "x.toml", {"particles.0.diameter=80 um"});
  EXPECT_DOUBLE_EQ(c.particles[0].diameter.mean, 80e-6);
  EXPECT_EQ(c.particles[0].count, 20);
  EXPECT_THROW((void)parse_case(dry_case, "x.toml", {"particles.1.count=3"}), InputError);
}

struct Wrong {
  std::string text;     ///< added to the dry case, whose last line is 10
  std::string message;  ///< after "x.toml:"
};

class WrongParticles : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongParticles, are_refused_with_advice) {
  try {
    (void)parse_case(dry_case + GetParam().text, "x.toml");
    ADD_FAILURE() << "accepted:\n" << GetParam().text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), "x.toml:" + GetParam().message);
  }
}

const std::string species = "[[particles]]\nname = \"b\"\n";
const std::string inlet = "[injection]\nspecies = \"sand\"\nrate = \"1 Hz\"\n";

const Wrong wrongs[] = {
    {"density = \"0 kg/m^3\"\n",
     "11: [[particles]] density: \"0 kg/m^3\" is out of range, allowed is above 0 kg/m^3 and up to "
     "100000 kg/m^3\nfor example \"998.2 kg/m^3\""},
    {"young = \"-1 MPa\"\n",
     "11: [[particles]] young: \"-1 MPa\" is out of range, allowed is above 0 Pa and up to "
     "10000000000000 Pa\nfor example \"12 Pa\""},
    {species + "diameter = \"0 um\"\n",
     "13: [[particles]] diameter: \"0 um\" is out of range, allowed is above 0 m and up to 1 m\n"
     "for example \"5.345 um\""},
    {species + "diameter = \"-5 um\"\n",
     "13: [[particles]] diameter: \"-5 um\" is out of range, allowed is above 0 m and up to 1 m\n"
     "for example \"5.345 um\""},
    {species + "count = 3\n",
     "11: [[particles]]: needs a diameter\n"
     "diameter = \"5 um\", or a source with diameter_m"},
    {species + "diameter = { mean = \"5 um\", distribution = \"normal\" }\ncount = 3\n",
     "13: [[particles]] diameter: needs a standard_deviation\n"
     "{ mean = \"5 um\", standard_deviation = \"0.5 um\" }"},
    {species + "diameter = { diameters = [\"5 um\", \"6 um\"], shares = [0.5, 0.4] }\ncount = 3\n",
     "13: [[particles]] diameter.shares: add up to 0.9, not to 1"},
    {species +
         "diameter = { mean = \"5 um\", standard_deviation = \"1 um\", smallest = \"6 um\" }\n"
         "count = 3\n",
     "13: [[particles]] diameter: the mean of 5e-06 m is not between smallest, 6e-06 m, and "
     "largest, 8e-06 m"},
    {"[[particles]]\nname = \"sand\"\ndiameter = \"5 um\"\ncount = 3\n",
     "7: [[particles]]: there are two species called \"sand\"\ngive each a name of its own"},
    {species + "diameter = \"5 um\"\n",
     "11: [[particles]]: has no particles\n"
     "give source, count or fill, or an [injection] of this species"},
    {species + "diameter = \"5 um\"\ncount = 3\nfill = 0.1\n",
     "11: [[particles]]: says twice which particles there are at the start\n"
     "one of source, count and fill"},
    {"fixed = true\nforce = [\"1 N\", \"0 N\", \"0 N\"]\n",
     "12: [[particles]] force: has no meaning for fixed particles"},
    {"[contact]\nfriction = -0.1\n",
     "12: [contact] friction: -0.1 is out of range, allowed is from 0 to 10"},
    {"[contact]\nfriction = { particle_wall = -0.1 }\n",
     "12: [contact] friction.particle_wall: -0.1 is out of range, allowed is from 0 to 10"},
    {"[contact]\nrestitution = 1.1\n",
     "12: [contact] restitution: 1.1 is out of range, allowed is above 0 and up to 1"},
    {"[contact]\nrolling = { model = \"constant-torque\" }\n",
     "12: [contact] rolling: needs a friction\n{ model = \"constant-torque\", friction = 0.01 }"},
    {"[injection]\nrate = \"1 Hz\"\nspecies = \"snad\"\nvelocity = \"1 m/s\"\n",
     "13: [injection] species: there are no [[particles]] called \"snad\"\nknown: sand"},
    {"[injection]\nvelocity = \"1 m/s\"\n",
     "11: [injection]: does not say how much\n"
     "give one of volume_fraction, mass_fraction and rate"},
    {inlet,
     "11: [injection] velocity: is missing: there is no flow that would carry particles in\n"
     "velocity = \"1 mm/s\""},
    {inlet + "velocity = \"1 m/s\"\nstart = \"2 s\"\nstop = \"1 s\"\n",
     "16: [injection] stop: 1 s is not after start, 2 s"},
    {inlet + "velocity = \"1 m/s\"\nface = \"x-\"\n[box]\nperiodic = [\"x\"]\n",
     "15: [injection] face: x- belongs to a periodic axis\n"
     "particles enter through a face that is none"},
    {"[box]\nperiodic = [\"x\"]\nopen = [\"x+\"]\n",
     "13: [box] open: face x+ belongs to the periodic axis x"},
    {"[[surface]]\nkind = \"cylinder\"\n", "11: [[surface]] radius: is missing\nradius = \"1 mm\""},
    {"[[surface]]\nkind = \"plane\"\nradius = \"1 mm\"\n",
     "13: [[surface]] radius: has no meaning for this kind"},
    {"[[surface]]\nkind = \"plane\"\nnormal = [0, 0, 0]\n",
     "13: [[surface]] normal: has no direction"},
    {"[box]\nopen = [\"x+\"]\n[flow]\nperiodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\n"
     "[grid]\ncells = [4, 4, 4]\n",
     "11: [box]: has no meaning beside a flow, which says what the faces are"},
    {"[contact]\nintegrator = \"overdamped\"\n",
     "12: [contact] integrator: \"overdamped\" needs a liquid that resists\n"
     "\"auto\" or \"newton-euler\" without a flow"},
    {"[[output]]\nkind = \"fields\"\n",
     "11: [[output]]: there are no fields without a flow\n"
     "kinds here: pictures, tracks, summary, movie"},
    {"[flow]\nregime = \"none\"\nslip = [\"x-\"]\n",
     "11: [flow]: says more than regime = \"none\", which has no flow\n"
     "faces of the box are described in [box]"},
};
INSTANTIATE_TEST_SUITE_P(Case, WrongParticles, ::testing::ValuesIn(wrongs));

TEST(ParticleConfig, dry_needs_an_end) {
  try {
    (void)parse_case(
        "[geometry]\nkind = \"empty\"\nsize = [\"1 m\", \"1 m\", \"1 m\"]\n"
        "[[particles]]\ndiameter = \"1 mm\"\ncount = 1\n",
        "x.toml");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "x.toml: [run] end_time: is missing\nend_time = \"0.1 s\"");
  }
}

TEST(ParticleConfig, a_flow_has_no_use_for_them_yet) {
  EXPECT_THROW((void)parse_case(box_case + "[run]\nend_time = \"1 s\"\n", "x.toml"), InputError);
  EXPECT_THROW((void)parse_case(box_case + "[box]\nopen = [\"y-\"]\n", "x.toml"), InputError);
}

}  // namespace
}  // namespace porefines::config
