// SPDX-License-Identifier: MPL-2.0
// From what a case says about particles to what the DEM needs.
#pragma once

#include "config/case.hpp"
#include "dem/injection.hpp"
#include "dem/sizes.hpp"
#include "dem/system.hpp"
#include "geom/build.hpp"

namespace porefines::sim {

[[nodiscard]] inline Vec3 vec(const config::Triple& t) {
  return {t[0], t[1], t[2]};
}

/// [N] on a particle of this radius in the fluid: weight less buoyancy, and the force of the case.
[[nodiscard]] Vec3 outer_force(const config::Case& the_case, const config::Particles& species,
                               Real radius);

[[nodiscard]] dem::Sizes dem_sizes(const config::Sizes& sizes);

/// Species in the order of the case, then walls with friction, then smooth walls.
[[nodiscard]] dem::MaterialTable make_materials(const config::Case& the_case);

/// The contact law. A linear spring without a given stiffness stores as much energy as Hertz's at
/// the same overlap, that of an impact of two mean particles at `speed` [m/s]:
///
///     k = (16/15) E sqrt(R) (15 m v^2 / (16 E sqrt(R)))^(1/5)
[[nodiscard]] dem::ContactModel make_contact_model(const config::Case& the_case, Real speed);

/// [m/s] at which particles of this case may meet: what falling through the box gives, or the
/// fastest start or entry; contact.top_speed when it is given.
[[nodiscard]] Real expected_speed(const config::Case& the_case, const Vec3& box);

/// Everything but the particles: box, walls and grains, materials, law, gravity.
/// @throws InputError  walls that cannot be read
[[nodiscard]] dem::Settings make_settings(const config::Case& the_case, const geom::Sample& sample);
/// The same in a box that is larger than the sample.
[[nodiscard]] dem::Settings make_settings(const config::Case& the_case, const geom::Sample& sample,
                                          const dem::Box& box);

/// Is a point in a wall or a grain?
[[nodiscard]] bool in_wall(const dem::Settings& settings, const Vec3& x);

/// [m^3/s] of particles of this density [kg/m^3] in a flow of suspension [m^3/s], for an injection by
/// volume or mass fraction.
[[nodiscard]] Real injected_volume(const config::Case& the_case, const config::Injection& injection,
                                   Real density, Real flow);

/// How many enter by `end` [s] at this rate: particles/s or, where the inlet counts volume, [m^3/s].
[[nodiscard]] Real particles_entering(const dem::Inlet& inlet, Real rate, Real end);

/// The injections of the case.
/// @throws InputError  a window outside the face, or one that lets no particle through
[[nodiscard]] std::vector<dem::Inlet> make_inlets(const config::Case& the_case,
                                                  const dem::Box& box);

}  // namespace porefines::sim
