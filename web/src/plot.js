// Figures: a plot, its number and caption, and its files as SVG, PNG and CSV.
import Plotly from "plotly.js-cartesian-dist-min";
import { h, save } from "./dom.js";
import { onTheme, palette, template } from "./theme.js";

/** Every figure of the page by its name, for the tests and for the theme. */
export const figures = new Map();

const config = {
  responsive: true,
  displayModeBar: "hover",  // else it lies on the plot wherever there is no pointer
  displaylogo: false,
  scrollZoom: false,
  modeBarButtonsToRemove: ["toImage", "select2d", "lasso2d", "autoScale2d"],
};

function themed(layout, traces, name) {
  const legend = layout.showlegend ?? traces.length > 1;
  return {
    margin: { l: 60, r: 16, t: legend ? 40 : 12, b: 48 },
    hovermode: "closest",
    ...layout,
    template: template(name),
  };
}

/** Columns { name: [values] } as CSV. */
export function csvText(columns) {
  const names = Object.keys(columns);
  const rows = Math.max(0, ...names.map((name) => columns[name].length));
  const lines = [names.join(",")];
  for (let row = 0; row < rows; ++row) {
    lines.push(names.map((name) => columns[name][row] ?? "").join(","));
  }
  return `${lines.join("\n")}\n`;
}

async function saveImage(figure, format) {
  const width = 900;
  const data = figure.traces();
  const layout = { ...themed(figure.layout(), data, "light"), paper_bgcolor: palette("light").paper };
  const size = { width, height: figure.height(width), scale: format === "png" ? 2 : 1 };
  const address = await Plotly.toImage({ data, layout }, { format, ...size });
  save(`${figure.name}.${format}`, await (await fetch(address)).blob());
}

function tools(figure) {
  const button = (text, label, action) =>
    h("button", { type: "button", title: label, "aria-label": label, onclick: action }, text);
  return h("span", { class: "tools" },
    button("SVG", "Save this figure as SVG", () => saveImage(figure, "svg")),
    button("PNG", "Save this figure as PNG", () => saveImage(figure, "png")),
    button("CSV", "Save the data of this figure as CSV", () =>
      save(`${figure.name}.csv`, new Blob([csvText(figure.csv)], { type: "text/csv" }))));
}

/** Numbers and captions a figure whose content is `inside`. */
export function frame(name, inside, caption, toolbar = null) {
  return h("figure", { id: name }, inside,
    h("figcaption", {}, h("b", {}, "Figure "), h("b", { class: "figure-number" }, ""), " ", caption, toolbar ? " " : "", toolbar));
}

/**
 * @param traces, layout  functions, so that colours follow the theme
 * @param csv             columns of what is shown, in SI
 * @param height          pixels, or a function of the width
 */
export function addFigure(parent, { name, caption, traces, layout, csv, height = 340 }) {
  const plot = h("div", { class: "plot" });
  const figure = { name, plot, traces, layout, csv, height: typeof height === "function" ? height : () => height };
  figures.set(name, figure);
  parent.append(frame(name, plot, caption, tools(figure)));
  figure.fit = () => { plot.style.height = `${Math.round(figure.height(plot.clientWidth))}px`; };
  figure.draw = () => {
    const data = traces();
    figure.fit();
    return Plotly.react(plot, data, themed(layout(), data), config);
  };
  return figure;
}

export async function drawFigures() {
  document.querySelectorAll(".figure-number").forEach((place, k) => {
    place.textContent = `${k + 1}.`;
  });
  for (const figure of figures.values()) {
    await figure.draw();
  }
  onTheme(() => figures.forEach((figure) => figure.draw()));
  addEventListener("resize", () => figures.forEach((figure) => figure.fit()));
}

/** A line of a series, scaled to its unit; the test finds its column by `meta`. */
export function line(column, x, y, { name, factor = 1, xFactor = 1, ...more } = {}) {
  return {
    type: "scatter",
    mode: "lines",
    name: name ?? column,
    x: x.map((value) => (value === null ? null : value / xFactor)),
    y: y.map((value) => (value === null ? null : value / factor)),
    meta: { column, factor, xFactor },
    hovertemplate: "%{y:.4g}<extra>%{fullData.name}</extra>",
    ...more,
  };
}
