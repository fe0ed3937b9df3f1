import { h } from "../dom.js";
import { addFigure, line } from "../plot.js";
import { abscissa, column, hasData, thinning } from "../series.js";
import { fateHue, hue } from "../theme.js";
import { largest, unitFor } from "../units.js";

const fates = ["piping", "bridging", "clogged", "resting"];
const meanings = "piping: moves, or has left; bridging: in an arch; clogged: sieved, or behind a clog; resting: attached or settled without a clogged throat";

function addShares(section, data) {
  const axis = abscissa(data);
  const came = column(data, "particles_injected");
  const shares = fates.map((fate) =>
    column(data, `${fate}_share`).map((share, k) => (came[k] > 0 ? share : null))); // of nobody there is no share
  addFigure(section, {
    name: "fates",
    caption: `What became of all fines that ever came in (${meanings}).${thinning(data)}`,
    csv: { [axis.name]: axis.values, ...Object.fromEntries(fates.map((fate, k) => [`${fate}_share`, shares[k]])) },
    traces: () => fates.map((fate, k) => line(`${fate}_share`, axis.values, shares[k], {
      name: fate, factor: 0.01, xFactor: axis.factor, stackgroup: "fates", line: { color: fateHue[fate], width: 0.5 }, fillcolor: fateHue[fate],
      hovertemplate: "%{y:.3g} %<extra>%{fullData.name}</extra>",
    })),
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: axis.title } }, yaxis: { title: { text: "share of fines (%)" }, range: [0, 100] } }),
  });
}

function addProfile(grid, name, { x, xTitle, csv, values, title, factor, caption, colour }) {
  addFigure(grid, {
    name,
    height: 280,
    caption,
    csv,
    traces: () => values.map(({ column: meta, y, label, dash }) => line(meta, x.values, y, {
      name: label, factor, xFactor: x.factor, line: { color: colour, width: 2, shape: "hvh", dash }, fill: values.length === 1 ? "tozeroy" : undefined,
    })),
    layout: () => ({ hovermode: "x unified", showlegend: values.length > 1, xaxis: { title: { text: xTitle } }, yaxis: { title: { text: title }, rangemode: values.length === 1 ? "tozero" : "normal" } }),
  });
}

export function retention(data) {
  const profile = data.retention?.columns;
  if (!profile) {
    return { title: "Retention", missing: data.kind === "coupled" ? "retention.csv is missing or empty." : "Only runs with fines in a flow retain any." };
  }
  return {
    id: "retention",
    title: "Retention",
    fill(section) {
      if (hasData(column(data, "piping_share"))) {
        addShares(section, data);
      }
      const length = unitFor(largest(profile.x_m), "m");
      const x = { values: profile.x_m, factor: length.factor };
      const xTitle = `along the flow (${length.unit})`;
      const grid = h("div", { class: "pair" });
      section.append(grid);
      addProfile(grid, "retention-profile", {
        x, xTitle, title: "retained / pore volume (%)", factor: 0.01, colour: hue.vermilion,
        csv: { x_m: profile.x_m, retained: profile.retained, retained_fraction: profile.retained_fraction, suspended_fraction: profile.suspended_fraction },
        values: [{ column: "retained_fraction", y: profile.retained_fraction, label: "retained" }],
        caption: "Retention profile at the end of the run: retained fines by volume, per pore volume of each slice.",
      });
      addProfile(grid, "porosity-profile", {
        x, xTitle, title: "porosity", factor: 1, colour: hue.blue,
        csv: { x_m: profile.x_m, porosity_clean: profile.porosity_clean, porosity: profile.porosity },
        values: [
          { column: "porosity_clean", y: profile.porosity_clean, label: "clean", dash: "dot" },
          { column: "porosity", y: profile.porosity, label: "at the end" },
        ],
        caption: "Porosity along the flow, of the clean sample and with retained fines as solid.",
      });
    },
  };
}
