// SPDX-License-Identifier: MPL-2.0
#include "io/xdmf.hpp"

#include <iterator>

#include <fmt/format.h>

namespace porefines::io {
namespace {

std::string attribute_text(const std::string& name, const std::string& type,
                           const std::string& dimensions, const std::string& dataset) {
  return fmt::format(
      R"(        <Attribute Name="{}" AttributeType="{}" Center="Cell">
          <DataItem Dimensions="{}" NumberType="Float" Precision="4" Format="HDF">{}</DataItem>
        </Attribute>
)",
      name, type, dimensions, dataset);
}

}  // namespace

std::string xdmf_text(const Int3& cells, const Vec3& origin, const Vec3& spacing,
                      const std::vector<FieldStep>& steps, const Provenance& provenance) {
  const auto [nx, ny, nz] = cells;
  const std::string per_cell = fmt::format("{} {} {}", nz, ny, nx);
  std::string text = R"(<?xml version="1.0" ?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0">
  <Domain>
)";
  auto out = std::back_inserter(text);
  for (const auto& [name, value] : entries(provenance)) {
    fmt::format_to(out, "    <Information Name=\"{}\" Value=\"{}\"/>\n", name, value);
  }
  text += "    <Grid Name=\"porefines\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const FieldStep& step : steps) {
    fmt::format_to(out,
                   R"(      <Grid Name="{}" GridType="Uniform">
        <Time Value="{}"/>
        <Topology TopologyType="3DCoRectMesh" Dimensions="{} {} {}"/>
        <Geometry GeometryType="ORIGIN_DXDYDZ">
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{} {} {}</DataItem>
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{} {} {}</DataItem>
        </Geometry>
)",
                   step.file, step.time, nz + 1, ny + 1, nx + 1, origin.z, origin.y, origin.x,
                   spacing.z, spacing.y, spacing.x);
    const std::string where = step.file + ":/";
    for (const std::string& name : step.scalars) {
      text += attribute_text(name, "Scalar", per_cell, where + name);
    }
    for (const std::string& name : step.vectors) {
      text += attribute_text(name, "Vector", per_cell + " 3", where + name);
    }
    text += "      </Grid>\n";
  }
  text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
  return text;
}

}  // namespace porefines::io
