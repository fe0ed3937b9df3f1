import { facts, h } from "../dom.js";
import { addFigure, line } from "../plot.js";
import { abscissa, column, hasData, thinning } from "../series.js";
import { hue } from "../theme.js";
import { largest, number, unitFor } from "../units.js";

/** Thin vertical lines where a throat clogged, for plots against pore volumes or time. */
export function clogLines(data, axis) {
  return (data.clogging ?? [])
    .filter((event) => event.event === "clogged")
    .map((event) => ({
      type: "line",
      x0: event[axis.name] / axis.factor,
      x1: event[axis.name] / axis.factor,
      yref: "paper",
      y0: 0,
      y1: 1,
      line: { color: hue.vermilion, width: 1, dash: "dot" },
    }));
}

function tensor(summary) {
  const names = ["x", "y", "z"];
  const rows = names.filter((i) => names.some((j) => summary[`k_${i}${j}`] !== undefined));
  if (rows.length === 0) {
    return null;
  }
  return h("table", { class: "grid" },
    h("caption", {}, "Permeability tensor (m²)"),
    ...rows.map((i) => h("tr", {}, ...names.map((j) => h("td", {}, number(summary[`k_${i}${j}`]))))));
}

function addRatio(section, data) {
  const axis = abscissa(data);
  const ratio = column(data, "permeability_ratio");
  addFigure(section, {
    name: "permeability-ratio",
    caption: `Permeability over that of the clean sample, k/k₀, from the flow rate and the pressure drop of every sample.${
      (data.clogging ?? []).length ? " Dotted lines: a throat clogged." : ""}${thinning(data)}`,
    csv: { [axis.name]: axis.values, permeability_ratio: ratio },
    traces: () => [line("permeability_ratio", axis.values, ratio, { name: "k/k₀", xFactor: axis.factor, line: { color: hue.blue, width: 2 } })],
    layout: () => ({
      hovermode: "x unified",
      xaxis: { title: { text: axis.title } },
      yaxis: { title: { text: "k / k₀" }, rangemode: "tozero" },
      shapes: clogLines(data, axis),
    }),
  });
}

function addDrive(section, data) {
  const axis = abscissa(data);
  const rate = column(data, "flow_rate_m3_s");
  const drop = column(data, "pressure_drop_pa");
  const rates = { factor: 1e-9 / 60, unit: "µL/min" };
  const drops = unitFor(largest(drop), "Pa");
  addFigure(section, {
    name: "flow-rate",
    caption: "Flow rate (left axis) and pressure drop over the sample (right axis): what is driven and what answers.",
    csv: { [axis.name]: axis.values, flow_rate_m3_s: rate, pressure_drop_pa: drop },
    traces: () => [
      line("flow_rate_m3_s", axis.values, rate, { name: `flow rate (${rates.unit})`, factor: rates.factor, xFactor: axis.factor, line: { color: hue.blue, width: 2 } }),
      line("pressure_drop_pa", axis.values, drop, { name: `pressure drop (${drops.unit})`, factor: drops.factor, xFactor: axis.factor, yaxis: "y2", line: { color: hue.vermilion, width: 2, dash: "dash" } }),
    ],
    layout: () => ({
      hovermode: "x unified",
      margin: { l: 64, r: 64, t: 36, b: 52 },
      xaxis: { title: { text: axis.title } },
      yaxis: { title: { text: `flow rate (${rates.unit})` }, rangemode: "tozero" },
      yaxis2: { title: { text: `pressure drop (${drops.unit})` }, overlaying: "y", side: "right", tickmode: "auto", rangemode: "tozero", showgrid: false },
    }),
  });
}

export function permeability(data) {
  const { summary: s, kind } = data;
  if (kind === "dry") {
    return { title: "Permeability", missing: "There is no fluid in this run." };
  }
  if (!Number.isFinite(s.permeability_m2)) {
    return { title: "Permeability", missing: "This run did not come to a permeability." };
  }
  return {
    id: "permeability",
    title: "Permeability",
    fill(section) {
      section.append(facts([
        ["k", `${number(s.permeability_m2)} m² = ${number(s.permeability_darcy)} darcy`],
        ["k₀, before the first fine", s.permeability_clean_m2 && `${number(s.permeability_clean_m2)} m²`],
        ["k / k₀", s.permeability_ratio !== undefined ? number(s.permeability_ratio, 4) : ""],
        ["measured over", s.length_m && `${number(1e6 * s.length_m)} µm along the flow, k = μ U L / Δp`],
      ]));
      const table = tensor(s);
      if (table) {
        section.append(table);
      }
      if (hasData(column(data, "permeability_ratio"))) {
        addRatio(section, data);
        addDrive(section, data);
      }
    },
  };
}
