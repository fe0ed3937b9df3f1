// SPDX-License-Identifier: MPL-2.0
// A case in the words of OpenFOAM.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "interop/export_case.hpp"
#include "interop/openfoam_text.hpp"
#include "par/communicator.hpp"

namespace porefines::interop {
namespace {

using flow::FaceKind;

/// Corners of the six faces of blockMesh's hexahedron, indexed by BoxFace.
constexpr std::array<const char*, 6> face_corners{"(0 4 7 3)", "(1 2 6 5)", "(0 1 5 4)",
                                                  "(3 7 6 2)", "(0 3 2 1)", "(4 5 6 7)"};

/// What a face of the box is there.
enum class Patch { inlet, outlet, slip, wall };

struct FoamCase {
  const config::Case& the_case;
  sim::Domain domain;
  std::string folder;
  bool grains = false;
  bool steady = true;
};

Patch patch_of(const config::Case& the_case, int face) {
  const auto is = [&](const config::Opening& opening) {
    return static_cast<int>(opening.face) == face;
  };
  if (is(*the_case.flow.inlet)) {
    return Patch::inlet;
  }
  if (is(*the_case.flow.outlet)) {
    return Patch::outlet;
  }
  return the_case.flow.slip[static_cast<std::size_t>(face)] ? Patch::slip : Patch::wall;
}

void write(const FoamCase& foam, const std::string& name, const std::string& kind,
           const std::string& body) {
  const std::string object = name.substr(name.rfind('/') + 1);
  write_file(foam.folder + "/" + name,
             fmt::format("FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n{}", kind,
                         object, body));
}

std::string faces_of(const FoamCase& foam, Patch wanted) {
  std::string text;
  for (int face = 0; face < 6; ++face) {
    if (patch_of(foam.the_case, face) == wanted) {
      text += fmt::format("{}{}", text.empty() ? "" : " ",
                          face_corners[static_cast<std::size_t>(face)]);
    }
  }
  return text;
}

void write_block_mesh(const FoamCase& foam) {
  const Vec3 a = foam.domain.origin();
  const Vec3 b = a + foam.domain.size();
  const Int3& n = foam.domain.cells;
  std::string corners;
  for (const Real z : {a.z, b.z}) {
    corners += fmt::format(
        " ({0:.12g} {1:.12g} {4:.12g}) ({2:.12g} {1:.12g} "
        "{4:.12g}) ({2:.12g} {3:.12g} "
        "{4:.12g}) ({0:.12g} {3:.12g} {4:.12g})",
        a.x, a.y, b.x, b.y, z);
  }
  write(foam, "system/blockMeshDict", "dictionary",
        fmt::format("scale 1;\nvertices ({} );\nblocks (hex (0 1 2 3 4 5 6 7) ({} {} {}) "
                    "simpleGrading (1 1 1));\nedges ();\nboundary\n(\n"
                    "  inlet  {{ type patch; faces ({}); }}\n  outlet {{ type patch; "
                    "faces ({}); }}\n"
                    "  sides  {{ type patch; faces ({}); }}\n  walls  {{ type wall; "
                    "faces ({}); }}\n"
                    ");\nmergePatchPairs ();\n",
                    corners, n[0], n[1], n[2], faces_of(foam, Patch::inlet),
                    faces_of(foam, Patch::outlet), faces_of(foam, Patch::slip),
                    faces_of(foam, Patch::wall)));
}

/// A point in the reservoir before the sample, off all corners and faces of
/// cells.
Vec3 open_point(const FoamCase& foam) {
  const Vec3 h = foam.domain.spacing;
  Vec3 at = foam.domain.origin() + Vec3{1.37 * h.x, 1.41 * h.y, 1.53 * h.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != foam.domain.axis) {
      at[axis] +=
          std::floor(0.5 * foam.domain.cells[static_cast<std::size_t>(axis)]) * h[axis] - h[axis];
    }
  }
  return at;
}

/// What holds on inlet or outlet: the pressure or the rate that is given.
std::array<std::string, 2> opening_conditions(const FoamCase& foam, const config::Opening& opening,
                                              Real sign) {
  const Real density = foam.the_case.fluid.density;
  if (opening.kind == config::DriveKind::pressure) {
    return {fmt::format("type fixedValue; value uniform {:.12g};", opening.value / density),
            "type zeroGradient;"};
  }
  const Real rate = opening.kind == config::DriveKind::flow_rate
                        ? opening.value
                        : opening.value * foam.domain.area();
  return {"type zeroGradient;",
          fmt::format("type flowRateInletVelocity; volumetricFlowRate {:.12g}; "
                      "value uniform (0 0 0);",
                      sign * rate)};
}

void write_fields(const FoamCase& foam) {
  const auto inlet = opening_conditions(foam, *foam.the_case.flow.inlet, 1);
  const auto outlet = opening_conditions(foam, *foam.the_case.flow.outlet, -1);
  write(foam, "0/p", "volScalarField",
        fmt::format("dimensions [0 2 -2 0 0 0 0];\ninternalField uniform "
                    "0;\nboundaryField\n{{\n"
                    "  inlet  {{ {} }}\n  outlet {{ {} }}\n"
                    "  \"(sides|walls|grains)\" {{ type zeroGradient; }}\n}}\n",
                    inlet[0], outlet[0]));
  write(foam, "0/U", "volVectorField",
        fmt::format("dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 "
                    "0);\nboundaryField\n{{\n"
                    "  inlet  {{ {} }}\n  outlet {{ {} }}\n  sides  {{ type slip; }}\n"
                    "  \"(walls|grains)\" {{ type noSlip; }}\n}}\n",
                    inlet[1], outlet[1]));
  write(foam, "constant/transportProperties", "dictionary",
        fmt::format("transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] {:.12g};\n",
                    foam.the_case.fluid.viscosity / foam.the_case.fluid.density));
  write(foam, "constant/turbulenceProperties", "dictionary", "simulationType laminar;\n");
}

/// Mean pressure of the cells that a plane goes through.
std::string plane(const FoamCase& foam, const std::string& name, Real at) {
  Vec3 point = 0.5 * foam.domain.sample_size;
  Vec3 normal;
  point[foam.domain.axis] = at;
  normal[foam.domain.axis] = 1;
  return fmt::format(
      "  {}\n  {{\n    type surfaceFieldValue; libs "
      "(fieldFunctionObjects); log false; writeFields "
      "false;\n"
      "    regionType sampledSurface; name {}; operation "
      "areaAverage; fields (p);\n"
      "    sampledSurfaceDict {{ type cuttingPlane; planeType "
      "pointAndNormal; interpolate false;\n"
      "      pointAndNormalDict {{ point ({:.12g} {:.12g} "
      "{:.12g}); normal ({} {} {}); }} }}\n"
      "    writeControl timeStep; writeInterval 20;\n  }}\n",
      name, name, point.x, point.y, point.z, normal.x, normal.y, normal.z);
}

void write_control(const FoamCase& foam) {
  const config::Case& c = foam.the_case;
  const Real half = 0.5 * foam.domain.spacing[foam.domain.axis];  // to the cells on either side
  const Real step = c.inertia.time_step > 0 ? c.inertia.time_step : 1e-6;
  write(foam, "system/controlDict", "dictionary",
        fmt::format("application {}; startFrom startTime; startTime 0; stopAt endTime; "
                    "endTime {}; deltaT "
                    "{};\n"
                    "writeControl timeStep; writeInterval 1000000; writeFormat binary; "
                    "writePrecision 12;\n"
                    "timeFormat general; timePrecision 12; runTimeModifiable "
                    "false;\nfunctions\n{{\n"
                    "  flow\n  {{\n    type surfaceFieldValue; libs "
                    "(fieldFunctionObjects); log false; "
                    "writeFields false;\n    regionType patch; name outlet; operation "
                    "sum; fields (phi);\n"
                    "    writeControl timeStep; writeInterval 20;\n  }}\n{}{}}}\n",
                    foam.steady ? "simpleFoam" : "pisoFoam",
                    foam.steady ? "2000" : fmt::format("{:.9g}", c.run.end_time),
                    foam.steady ? "1" : fmt::format("{:.9g}", step),
                    plane(foam, "before_begin", -half) + plane(foam, "after_begin", half),
                    plane(foam, "before_end", foam.domain.length() - half) +
                        plane(foam, "after_end", foam.domain.length() + half)));
}

/// nu (Q/A) L / dp of the last line of each table; p where the sample begins is the mean of both sides.
void write_run(const FoamCase& foam) {
  const Real factor = foam.the_case.fluid.viscosity / foam.the_case.fluid.density /
                      foam.domain.area() * foam.domain.length();
  const std::string path = foam.folder + "/Allrun";
  write_file(path, fmt::format(foam_run_script, foam.grains ? "snappyHexMesh -overwrite" : "true",
                               foam.steady ? "simpleFoam" : "pisoFoam", factor));
  make_executable(path);
}

}  // namespace

void export_openfoam(const config::Case& the_case, const std::string& folder) {
  if (!the_case.flow.inlet || !the_case.flow.outlet || the_case.inertia.lid) {
    throw InputError(
        fmt::format("{}: only flows from an inlet to an outlet "
                    "between still walls can be exported "
                    "to OpenFOAM\n"
                    "give [flow] inlet and outlet instead of a "
                    "periodic drive or a moving wall",
                    the_case.path));
  }
  const geom::Sample sample =
      geom::build_sample(sim::geometry_spec(the_case), par::Communicator::self().handle());
  const sim::Domain domain = sim::make_domain(the_case, sample);
  const auto triangles = grain_triangles(the_case, sample, 2 * domain.spacing.z);
  const bool steady =
      the_case.flow.regime != config::Regime::navier_stokes || the_case.inertia.steady;
  const FoamCase foam{the_case, domain, folder, !triangles.empty(), steady};
  for (const char* part : {"/0", "/constant/triSurface", "/system"}) {
    make_folder(folder + part);
  }
  write_block_mesh(foam);
  if (foam.grains) {
    const Vec3 at = open_point(foam);
    write_text_stl(folder + "/constant/triSurface/grains.stl", triangles);
    write(foam, "system/snappyHexMeshDict", "dictionary",
          fmt::format(foam_snappy, fmt::format("{:.12g} {:.12g} {:.12g}", at.x, at.y, at.z)));
  }
  write_fields(foam);
  write(foam, "system/fvSchemes", "dictionary",
        fmt::format(foam_schemes, steady ? "steadyState" : "Euler", steady ? "bounded " : ""));
  write(foam, "system/fvSolution", "dictionary", foam_solution);
  write_control(foam);
  write_run(foam);
}

}  // namespace porefines::interop
