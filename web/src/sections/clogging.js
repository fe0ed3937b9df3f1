import { h } from "../dom.js";
import { addFigure } from "../plot.js";
import { hue, palette } from "../theme.js";
import { number, quantity, unitFor } from "../units.js";

const words = { clogged: "clogged", grown: "has grown", released: "released" };

/** Grains as filled outlines, one trace for all. */
function grainTrace(scene, factor) {
  const x = [];
  const y = [];
  for (const outline of scene.outlines) {
    for (const [a, b] of [...outline, outline[0]]) {
      x.push(a / factor);
      y.push(b / factor);
    }
    x.push(null);
    y.push(null);
  }
  return { type: "scatter", mode: "lines", x, y, fill: "toself", fillcolor: palette().grain, line: { color: palette().line, width: 0.5 }, hoverinfo: "skip", name: "grains", showlegend: false };
}

function throatTrace(throats, factor) {
  return {
    type: "scatter", mode: "markers", name: "throats",
    x: throats.x_m.map((x) => x / factor),
    y: throats.y_m.map((y) => y / factor),
    customdata: throats.id.map((id, k) => [id, throats.width_m[k] * 1e6]),
    marker: { size: 5, color: hue.grey },
    hovertemplate: "throat %{customdata[0]}: %{customdata[1]:.3g} µm wide<extra></extra>",
  };
}

function eventTrace(events, factor, chosen) {
  return {
    type: "scatter", mode: "markers", name: "clogging events",
    x: events.map((event) => event.x_m / factor),
    y: events.map((event) => event.y_m / factor),
    meta: { column: "y_m", factor, xFactor: factor },
    customdata: events.map((event) => [event.throat, words[event.event] ?? event.event, event.kind, event.particles]),
    marker: {
      symbol: "circle",
      size: events.map((_, k) => (k === chosen ? 22 : 11)),
      color: events.map((_, k) => (k === chosen ? hue.purple : hue.vermilion)),
      opacity: 0.85,
      line: { color: palette().paper, width: 1.5 },
    },
    hovertemplate: "throat %{customdata[0]} %{customdata[1]}: %{customdata[2]} of %{customdata[3]}<extra></extra>",
  };
}

function addMap(section, data, state) {
  const { scene, clogging: events, throats } = data;
  const size = scene?.size_m ?? [1, 1, 1];
  const { factor, unit } = unitFor(Math.max(...size), "m");
  return addFigure(section, {
    name: "clogging-map",
    height: (width) => Math.min(600, ((width - 80) * size[1]) / size[0] + 90),
    caption: "Where throats clogged, seen along z. Choose a row below to find its place here and in the player.",
    csv: Object.fromEntries(Object.keys(events[0]).map((name) => [name, events.map((event) => event[name])])),
    traces: () => [
      ...(scene?.outlines ? [grainTrace(scene, factor)] : []),
      ...(throats ? [throatTrace(throats.columns, factor)] : []),
      eventTrace(events, factor, state.chosen),
    ],
    layout: () => ({
      margin: { l: 60, r: 12, t: 30, b: 48 },
      xaxis: { title: { text: `x (${unit})` }, showgrid: false, range: [0, size[0] / factor], constrain: "domain" },
      yaxis: { title: { text: `y (${unit})` }, showgrid: false, range: [0, size[1] / factor], scaleanchor: "x", constrain: "domain" },
    }),
  });
}

function row(event, k, choose) {
  const cells = [
    quantity(event.time_s, "s", 3), number(event.pore_volumes, 3), `${event.throat}`, quantity(event.width_m, "m", 3), words[event.event] ?? event.event,
    `${event.kind}`, `${event.particles}`, `${event.behind}`, `${event.out}`,
  ];
  return h("tr", { tabindex: 0, "data-row": k, onclick: () => choose(k), onkeydown: (press) => {
    if (press.key === "Enter" || press.key === " ") {
      press.preventDefault();
      choose(k);
    }
  } }, ...cells.map((cell) => h("td", {}, cell)));
}

function logTable(events, choose) {
  const heads = ["time", "pore volumes", "throat", "width", "event", "kind", "fines in it", "behind", "left before"];
  return h("div", { class: "scroll" }, h("table", { class: "log" },
    h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...events.map((event, k) => row(event, k, choose)))));
}

export function clogging(data) {
  const events = data.clogging;
  if (!events) {
    return { title: "Clogging", missing: "Only runs with fines in a flow keep a clogging log." };
  }
  if (events.length === 0) {
    return { title: "Clogging", missing: "No throat clogged in this run." };
  }
  return {
    id: "clogging",
    title: "Clogging",
    fill(section) {
      const state = { chosen: -1 };
      const map = addMap(section, data, state);
      const choose = (k) => {
        state.chosen = k;
        section.querySelectorAll("tr[data-row]").forEach((line) => line.classList.toggle("chosen", Number(line.dataset.row) === k));
        map.draw();
        const event = events[k];
        window.porefines.player?.show(event.time_s, [event.x_m, event.y_m, event.z_m], 1.3 * event.width_m);
      };
      section.append(logTable(events, choose));
    },
  };
}
