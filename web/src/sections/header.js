import { h } from "../dom.js";
import { setTheme, theme } from "../theme.js";
import { count, duration, number, percent, quantity } from "../units.js";

const kinds = {
  flow: "Creeping flow",
  coupled: "Fines in a creeping flow",
  dry: "Particles without a fluid",
  inertial: "Flow with inertia",
};

function permeability(value) {
  return `${number(value / 9.869233e-13, 4)} darcy`;
}

/** Key numbers of each kind of run; those without a value are left out. */
function keyNumbers({ kind, summary: s }) {
  const size = [["cells", count(s.cells)], ["wall time", duration(s.wall_time_s)]];
  if (kind === "coupled") {
    const entered = s.particles_placed + s.particles_injected;
    return [
      ["permeability, clean", permeability(s.permeability_clean_m2), `k₀ = ${number(s.permeability_clean_m2)} m²`],
      ["k / k₀ at the end", number(s.permeability_ratio, 3), `after ${number(s.pore_volumes_injected, 3)} pore volumes`],
      ["porosity", number(s.porosity, 4), ""],
      ["fines that came in", count(entered), `${count(s.particles_out)} left again`],
      ["still inside", count(s.particles_inside), `${percent(s.inside_fraction)} of all`],
      ["throats clogged", count(s.clogged_throats), ""],
    ];
  }
  if (kind === "dry") {
    return [
      ["particles", count(s.particles_injected), `${count(s.particles_placed)} placed at the start`],
      ["still inside", count(s.particles_inside), `${count(s.particles_out)} left`],
      ["contacts per particle", number(s.coordination_number, 3), ""],
      ["largest overlap", percent(s.max_overlap), "of a radius"],
      ["simulated", quantity(s.time_s, "s", 3), `${count(s.steps)} steps`],
      size[1],
    ];
  }
  if (kind === "inertial") {
    return [
      ["Reynolds number", number(s.reynolds_body ?? s.reynolds, 4), ""],
      ["drag coefficient", number(s.body_1_mean_drag_coefficient ?? s.body_1_drag_coefficient, 4), "mean over whole periods where there are any"],
      ["lift amplitude", number(s.body_1_lift_amplitude, 3), ""],
      ["Strouhal number", number(s.body_1_strouhal, 4), ""],
      ["simulated", quantity(s.time_s, "s", 3), `${count(s.steps)} steps`],
      ...size,
    ];
  }
  return [
    ["permeability", permeability(s.permeability_m2), `${number(s.permeability_m2)} m²`],
    ["porosity", number(s.porosity, 4), s.porosity_connected < s.porosity ? `connected ${number(s.porosity_connected)}` : ""],
    ["Darcy velocity", quantity(s.darcy_velocity_m_s, "m/s"), `under ${quantity(s.pressure_drop_pa, "Pa")}`],
    ["Reynolds number", number(s.reynolds, 3), ""],
    ...size,
  ];
}

export function themeSwitch() {
  const button = h("button", { type: "button", class: "theme", onclick: () => {
    setTheme(theme() === "dark" ? "light" : "dark");
    name();
  } });
  const name = () => {
    button.textContent = theme() === "dark" ? "Light" : "Dark";
    button.setAttribute("aria-label", `Switch to ${theme() === "dark" ? "light" : "dark"} colours`);
  };
  name();
  return button;
}

export function header(data) {
  const { summary: s, kind } = data;
  const made = `porefines ${s.version ?? data.version}, commit ${s.commit ?? "unknown"} · ${s.ranks ?? 1} ${
    s.ranks > 1 ? "ranks" : "rank"} · seed ${s.seed ?? "–"} · ${(s.date ?? "").replace("T", " ").replace("Z", " UTC")}`;
  const cards = keyNumbers(data)
    .filter(([, value]) => value !== "–")
    .map(([name, value, more]) => h("div", { class: "card" }, h("dt", {}, name), h("dd", {}, value), more ? h("p", {}, more) : null));
  return h("header", {},
    h("div", { class: "kicker" }, h("span", {}, `Report of a run · ${kinds[kind]}`), themeSwitch()),
    h("h1", {}, s.title || data.folder),
    h("p", { class: "provenance" }, made),
    s.status && s.status !== "done" ? h("p", { class: "note" }, `This run ended early: ${s.status}${s.reason ? `, ${s.reason}` : ""}.`) : null,
    h("dl", { class: "cards" }, ...cards));
}
