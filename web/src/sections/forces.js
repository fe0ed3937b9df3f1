import { facts, h } from "../dom.js";
import { addFigure, line } from "../plot.js";
import { column, hasData, thinning, timeAxis } from "../series.js";
import { hue } from "../theme.js";
import { largest, number, quantity, unitFor } from "../units.js";

/** Drag and lift of each body of a run with inertia. */
function addBodies(section, data, bodies) {
  const time = timeAxis(data);
  for (const body of bodies) {
    const drag = column(data, `body_${body}_drag_coefficient`);
    const lift = column(data, `body_${body}_lift_coefficient`);
    addFigure(section, {
      name: `body-${body}`,
      caption: `Drag and lift coefficient of ${bodies.length > 1 ? `body ${body}` : "the body"}, C = 2F/(ρ D u²).${thinning(data)}`,
      csv: { time_s: time.values, [`body_${body}_drag_coefficient`]: drag, [`body_${body}_lift_coefficient`]: lift },
      traces: () => [
        line(`body_${body}_drag_coefficient`, time.values, drag, { name: "drag", xFactor: time.factor, line: { color: hue.blue, width: 2 } }),
        line(`body_${body}_lift_coefficient`, time.values, lift, { name: "lift", xFactor: time.factor, line: { color: hue.vermilion, width: 2, dash: "dash" } }),
      ],
      layout: () => ({ hovermode: "x unified", xaxis: { title: { text: time.title } }, yaxis: { title: { text: "coefficient" } } }),
    });
  }
}

function addParticleForces(section, forces) {
  const time = unitFor(largest(forces.time_s), "s");
  const { factor, unit } = unitFor(largest(forces.max_n), "N");
  addFigure(section, {
    name: "particle-forces",
    caption: "Force on the particles at each time of tracks.csv: mean and largest length.",
    csv: forces,
    traces: () => [
      line("mean_n", forces.time_s, forces.mean_n, { name: "mean", factor, xFactor: time.factor, line: { color: hue.blue, width: 2 } }),
      line("max_n", forces.time_s, forces.max_n, { name: "largest", factor, xFactor: time.factor, line: { color: hue.vermilion, width: 1.5, dash: "dash" } }),
    ],
    layout: () => ({ hovermode: "x unified", xaxis: { title: { text: `time (${time.unit})` } }, yaxis: { title: { text: `force (${unit})` }, type: "log" } }),
  });
}

export function forces(data) {
  const { summary: s } = data;
  const bodies = [1, 2, 3, 4].filter((body) => hasData(column(data, `body_${body}_drag_coefficient`)));
  const onParticles = data.tracks?.forces;
  if (bodies.length === 0 && !onParticles && s.drag_n === undefined && s.body_1_force_x_n === undefined) {
    return { title: "Forces", missing: data.kind === "flow" ? "Drag is reported for lists of grains in a periodic box." : 'Forces on particles are written with [[output]] kind = "tracks", forces = true.' };
  }
  return {
    id: "forces",
    title: "Forces",
    fill(section) {
      section.append(facts([
        ["mean drag on a grain", s.drag_n !== undefined ? quantity(s.drag_n, "N") : ""],
        ["drag over Stokes drag, K", s.drag_coefficient_mean !== undefined ? number(s.drag_coefficient_mean, 6) : ""],
        ["drag per length over μU", s.drag_per_length_over_viscosity_velocity !== undefined ? number(s.drag_per_length_over_viscosity_velocity, 6) : ""],
        ["force on the body", s.body_1_force_x_n !== undefined && `(${["x", "y", "z"].map((axis) => number(s[`body_1_force_${axis}_n`], 4)).join(", ")}) N`],
        ["drag coefficient", s.body_1_drag_coefficient !== undefined ? number(s.body_1_mean_drag_coefficient ?? s.body_1_drag_coefficient, 5) : ""],
        ["wake", s.wake_length_over_diameter !== undefined ? `${number(s.wake_length_over_diameter, 4)} diameters` : ""],
      ]));
      addBodies(section, data, bodies);
      if (onParticles) {
        addParticleForces(section, onParticles);
      }
    },
  };
}
