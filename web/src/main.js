// The page of a run: each section is a module that says what it shows, or why it has nothing to show.
import { readData } from "./data.js";
import { h } from "./dom.js";
import { drawFigures, figures } from "./plot.js";
import { startTheme } from "./theme.js";
import { showValidation } from "./validation.js";
import { header } from "./sections/header.js";
import { caseSection } from "./sections/case.js";
import { geometry } from "./sections/geometry.js";
import { flow } from "./sections/flow.js";
import { permeability } from "./sections/permeability.js";
import { breakthrough } from "./sections/breakthrough.js";
import { retention } from "./sections/retention.js";
import { motion } from "./sections/motion.js";
import { forces } from "./sections/forces.js";
import { particles } from "./sections/particles.js";
import { clogging } from "./sections/clogging.js";
import { agreement } from "./sections/agreement.js";
import { absent, cite, warnings } from "./sections/ending.js";

const sections = [
  warnings, geometry, flow, permeability, breakthrough, retention, particles, clogging, motion, forces, agreement, caseSection,
];

/** Adds a section, or notes what the run does not have. */
function add(page, data, section, missing) {
  const made = section(data);
  if (!made) {
    return null;
  }
  if (made.missing) {
    missing.push([made.title, made.missing]);
    return null;
  }
  const element = h("section", { id: made.id }, h("h2", {}, made.title));
  page.append(element);
  made.fill(element);
  return [made.id, made.title];
}

function showRun(page, data) {
  document.title = `${data.summary.title || data.folder} – porefines`;
  page.append(header(data));
  const contents = h("nav", { "aria-label": "Contents" });
  page.append(contents);
  const missing = [];
  const shown = sections.map((section) => add(page, data, section, missing));
  for (const last of [absent(missing), cite]) {
    shown.push(add(page, data, last, missing));
  }
  contents.append(...shown.filter(Boolean).map(([id, title]) => h("a", { href: `#${id}` }, title)));
}

async function show() {
  startTheme();
  const data = await readData();
  (data.kind === "validation" ? showValidation : showRun)(document.getElementById("page"), data);
  await drawFigures();
  document.documentElement.dataset.ready = "yes";
  window.porefines = { ...window.porefines, data, figures };
}

show().catch((error) => {
  document.getElementById("page").append(h("p", { class: "note" }, `This page could not be drawn: ${error.message}`));
  throw error;
});
