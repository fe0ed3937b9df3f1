import { h } from "../dom.js";
import { addFigure, line } from "../plot.js";
import { column, hasData, thinning, timeAxis } from "../series.js";
import { hue } from "../theme.js";
import { largest, unitFor } from "../units.js";

function addSpeed(grid, data, time) {
  const speed = column(data, "mean_speed_m_s");
  const { factor, unit } = unitFor(largest(speed), "m/s");
  addFigure(grid, {
    name: "mean-speed",
    height: 300,
    caption: `Mean speed of the particles inside (the counterpart of the thesis's fig. 18).${thinning(data)}`,
    csv: { time_s: time.values, mean_speed_m_s: speed },
    traces: () => [line("mean_speed_m_s", time.values, speed, { name: "mean speed", factor, xFactor: time.factor, line: { color: hue.blue, width: 2 } })],
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: time.title } }, yaxis: { title: { text: `mean speed (${unit})` }, rangemode: "tozero" } }),
  });
}

function addSpread(grid, data, time) {
  const axes = ["x", "y", "z"];
  const spreads = axes.map((axis) => column(data, `sigma_${axis}_m`));
  const { factor, unit } = unitFor(Math.max(...spreads.map(largest)), "m");
  const colours = [hue.blue, hue.vermilion, hue.green];
  addFigure(grid, {
    name: "spread",
    height: 300,
    caption: "Spread of the particles along each axis, σ = √(Σ(x − mean)²/N) (thesis eq. 19, fig. 19).",
    csv: { time_s: time.values, ...Object.fromEntries(axes.map((axis, k) => [`sigma_${axis}_m`, spreads[k]])) },
    traces: () => axes.map((axis, k) => line(`sigma_${axis}_m`, time.values, spreads[k], {
      name: `σ ${axis}`, factor, xFactor: time.factor, line: { color: colours[k], width: 2, dash: ["solid", "dash", "dot"][k] },
    })),
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: time.title } }, yaxis: { title: { text: `σ (${unit})` }, rangemode: "tozero" } }),
  });
}

function addEnergy(grid, data, time) {
  const parts = ["kinetic_j", "rotational_j", "elastic_j"].filter((name) => hasData(column(data, name)));
  const { factor, unit } = unitFor(Math.max(...parts.map((name) => largest(column(data, name)))), "J");
  addFigure(grid, {
    name: "energy",
    height: 300,
    caption: "Energy of the particles: of their motion, of their rotation, stored in contacts.",
    csv: { time_s: time.values, ...Object.fromEntries(parts.map((name) => [name, column(data, name)])) },
    traces: () => parts.map((name) => line(name, time.values, column(data, name), { name: name.replace("_j", ""), factor, xFactor: time.factor })),
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: time.title } }, yaxis: { title: { text: `energy (${unit})` } } }),
  });
}

function addContacts(grid, data, time) {
  const names = { contacts: "with each other", wall_contacts: "with grains and walls" };
  addFigure(grid, {
    name: "contacts",
    height: 300,
    caption: "Contacts of particles.",
    csv: { time_s: time.values, contacts: column(data, "contacts"), wall_contacts: column(data, "wall_contacts") },
    traces: () => Object.entries(names).map(([name, label]) => line(name, time.values, column(data, name), { name: label, xFactor: time.factor, line: { shape: "hv" } })),
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: time.title } }, yaxis: { title: { text: "contacts" }, rangemode: "tozero" } }),
  });
}

export function motion(data) {
  if (!hasData(column(data, "mean_speed_m_s"))) {
    return { title: "Motion of particles", missing: "This run has no particles, or series.csv is missing." };
  }
  return {
    id: "motion",
    title: "Motion of particles",
    fill(section) {
      const time = timeAxis(data);
      const grid = h("div", { class: "pair" });
      section.append(grid);
      addSpeed(grid, data, time);
      addSpread(grid, data, time);
      if (hasData(column(data, "kinetic_j"))) {
        addEnergy(grid, data, time);
      }
      if (hasData(column(data, "contacts"))) {
        addContacts(grid, data, time);
      }
    },
  };
}
