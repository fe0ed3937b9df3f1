import { facts, h } from "../dom.js";
import { addFigure } from "../plot.js";
import { hue } from "../theme.js";
import { count, number, percent, quantity, unitFor } from "../units.js";

function histogram(parent, name, data, { caption, title, weight, colour }) {
  const { factor, unit } = unitFor(data.edges_m.at(-1), "m");
  const low = data.edges_m.slice(0, -1);
  addFigure(parent, {
    name,
    height: 280,
    caption: h("span", {}, `${caption} Median ${quantity(data.median_m, "m", 3)}; the last bin holds all that is larger.`),
    csv: { from_m: low, to_m: data.edges_m.slice(1), share: data.share },
    traces: () => [{
      type: "bar",
      x: low.map((edge, k) => (edge + data.edges_m[k + 1]) / 2 / factor),
      y: data.share.map((share) => 100 * share),
      width: low.map((edge, k) => (0.92 * (data.edges_m[k + 1] - edge)) / factor),
      marker: { color: colour },
      meta: { column: "share", factor: 0.01 },
      hovertemplate: `%{x:.3g} ${unit}: %{y:.3g} %<extra></extra>`,
    }],
    layout: () => ({
      xaxis: { title: { text: `${title} (${unit})` }, rangemode: "tozero" },
      yaxis: { title: { text: `share of ${weight} (%)` } },
      bargap: 0,
      shapes: [{ type: "line", x0: data.median_m / factor, x1: data.median_m / factor, yref: "paper", y0: 0, y1: 1, line: { color: hue.grey, dash: "dot", width: 1.5 } }],
    }),
  });
}

export function geometry(data) {
  const { geometry: g, histograms } = data;
  if (!g) {
    return { title: "Geometry", missing: data.geometry_missing };
  }
  return {
    id: "geometry",
    title: "Geometry",
    fill(section) {
      section.append(facts([
        ["porosity", `${number(g.porosity, 4)}, connected ${number(g.porosity_connected, 4)}`],
        ["specific surface", `${number(g.specific_surface_per_m, 4)} m⁻¹`],
        ["pores", histograms.pores && `median ${quantity(histograms.pores.median_m, "m", 3)} (largest ball that fits, by volume)`],
        ["throats", histograms.throats && `${count(histograms.throats.count)}, median ${quantity(histograms.throats.median_m, "m", 3)}`],
        ["grains", histograms.grains && `${count(histograms.grains.count)}, median ${quantity(histograms.grains.median_m, "m", 3)}`],
        ["throats under four cells", g.throats_under_4_cells_share !== undefined ? `${percent(g.throats_under_4_cells_share)} (flow in them is off by more than 3 %)` : ""],
        ["voxels measured", g.voxels_x && `${g.voxels_x} × ${g.voxels_y} × ${g.voxels_z} of ${quantity(g.pixel_size_m, "m")}`],
      ]));
      const grid = h("div", { class: "pair" });
      section.append(grid);
      if (histograms.pores) {
        histogram(grid, "pore-sizes", histograms.pores, { caption: "Sizes of pores: diameter of the largest ball that holds a place, weighted by volume.", title: "pore diameter", weight: "pore volume", colour: hue.blue });
      }
      if (histograms.throats) {
        histogram(grid, "throat-sizes", histograms.throats, { caption: "Widths of throats, by number: shortest chord from grain to grain.", title: "throat width", weight: "throats", colour: hue.green });
      }
    },
  };
}
