// The page of porefines validate: a table and a figure per comparison, green or red with its tolerance.
import { h } from "./dom.js";
import { addFigure, frame } from "./plot.js";
import { themeSwitch } from "./sections/header.js";
import { hue } from "./theme.js";
import { duration, number, percent } from "./units.js";

function verdict(agrees) {
  return h("span", { class: agrees ? "verdict good" : "verdict bad" }, agrees ? "✓ green" : "✗ red");
}

function table(comparison) {
  const head = ["", "here", "reference", "off by", "tolerance", "", ...comparison.literature];
  const row = (r) => h("tr", {},
    h("th", { scope: "row" }, r.label),
    h("td", {}, number(r.value, 5) + (r.error > 0 ? ` ± ${number(r.error, 1)}` : "")),
    h("td", {}, number(r.reference, 6)),
    h("td", {}, r.reference === 0 ? "–" : percent(r.value === null ? NaN : r.value / r.reference - 1, 2)),
    h("td", {}, r.tolerance === 0 ? "exactly" : `± ${r.reference === 0 ? number(r.tolerance, 2) : percent(r.tolerance, 2)}`),
    h("td", {}, verdict(r.agrees)),
    ...r.literature.map((value) => h("td", {}, number(value, 4))));
  return h("div", { class: "scroll tall" }, h("table", { class: "log comparison" },
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...comparison.rows.map(row))));
}

function figure(section, comparison) {
  const { rows, literature } = comparison;
  const x = rows.map((row) => row.x);
  const symbols = ["triangle-up", "square", "diamond", "cross", "triangle-down"];
  addFigure(section, {
    name: comparison.name,
    caption: `${comparison.title}: ${comparison.quantity} against ${comparison.along}; bars are the tolerances around the references.`,
    csv: {
      label: rows.map((row) => row.label), x, here: rows.map((row) => row.value), reference: rows.map((row) => row.reference), tolerance: rows.map((row) => row.tolerance),
      ...Object.fromEntries(literature.map((name, k) => [name, rows.map((row) => row.literature[k])])),
    },
    traces: () => [
      { type: "scatter", mode: "markers", name: "reference", x, y: rows.map((row) => row.reference), error_y: { type: "data", array: rows.map((row) => row.tolerance * row.reference), thickness: 1, width: 5 }, marker: { symbol: "line-ew-open", size: 16, color: hue.grey, line: { width: 2 } }, text: rows.map((row) => row.label) },
      ...literature.map((name, k) => ({ type: "scatter", mode: "markers", name, x, y: rows.map((row) => row.literature[k]), marker: { symbol: symbols[k % symbols.length], size: 7, opacity: 0.75 } })),
      { type: "scatter", mode: "markers", name: "here", x, y: rows.map((row) => row.value), meta: { column: "value", factor: 1 }, marker: { size: 9, color: hue.blue }, text: rows.map((row) => row.label), hovertemplate: "%{text}: %{y:.5g}<extra>here</extra>" },
    ],
    layout: () => ({
      xaxis: { title: { text: comparison.along } },
      yaxis: { title: { text: comparison.quantity }, type: comparison.logarithmic ? "log" : "linear" },
    }),
  });
}

/** "3 runs, 12 s of wall time in all." */
function ran({ runs, seconds }) {
  return runs === 0 ? "No run is needed." : `${runs} ${runs > 1 ? "runs" : "run"}, ${duration(seconds)} of wall time in all.`;
}

/** Wall time of every comparison. */
function timings(comparisons) {
  const seconds = (value) => (value > 0 ? duration(value) : "–");
  return h("section", { id: "timings-section" }, h("h2", {}, "Timings"),
    h("p", {}, "Wall time of the runs of each comparison: for information, nothing here is red or green."),
    h("div", { class: "scroll tall" }, h("table", { class: "log comparison" },
      h("thead", {}, h("tr", {}, ...["", "runs", "wall time"].map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...comparisons.map(({ title, runs, seconds: took }) => h("tr", {},
        h("th", { scope: "row" }, title), h("td", {}, runs), h("td", {}, seconds(took))))))));
}

export function showValidation(page, data) {
  const rows = data.comparisons.flatMap((comparison) => comparison.rows);
  page.append(h("header", {},
    h("div", { class: "kicker" }, h("span", {}, "Validation"), themeSwitch()),
    h("h1", {}, data.red === 0 ? `All ${rows.length} numbers agree` : `${data.red} of ${rows.length} numbers do not agree`),
    h("p", { class: "provenance" }, `porefines ${data.version}, commit ${data.commit} · ${data.made.replace("T", " ").replace("Z", " UTC")}${data.quick ? " · quick: coarser grids, without what takes longer" : ""}`)));
  page.append(h("nav", { "aria-label": "Contents" }, ...data.comparisons.map(({ name, title }) => h("a", { href: `#${name}-section` }, title)), h("a", { href: "#timings-section" }, "Timings")));
  for (const comparison of data.comparisons) {
    const section = h("section", { id: `${comparison.name}-section` }, h("h2", {}, comparison.title),
      h("p", {}, `Compared: ${comparison.quantity}. Reference: ${comparison.reference}. ${ran(comparison)}`),
      table(comparison));
    page.append(section);
    if (comparison.along) {
      figure(section, comparison);
    }
    comparison.pictures.filter(({ address }) => address).forEach(({ address, caption }, k) =>
      section.append(frame(`${comparison.name}-picture-${k}`, h("img", { src: address, alt: caption }), caption)));
  }
  page.append(timings(data.comparisons));
}
