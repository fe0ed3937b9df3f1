import { h } from "../dom.js";

export function warnings(data) {
  if (data.warnings.length === 0) {
    return null;
  }
  return {
    id: "warnings",
    title: "Warnings",
    fill(section) {
      section.append(h("ul", { class: "warnings" }, ...data.warnings.map((text) => h("li", {}, text))));
    },
  };
}

/** What the run does not have, said once instead of holes on the page. */
export function absent(missing) {
  return () => missing.length === 0 ? null : {
    id: "absent",
    title: "What this run does not have",
    fill(section) {
      section.append(h("dl", { class: "absent" },
        ...missing.flatMap(([title, why]) => [h("dt", {}, title), h("dd", {}, why)])));
    },
  };
}

export function cite(data) {
  return {
    id: "cite",
    title: "How to cite",
    fill(section) {
      const { summary: s } = data;
      const year = (s.date ?? data.made).slice(0, 4);
      section.append(
        h("p", {}, `The porefines maintainers (${year}). porefines: fines migration at the pore scale, from an image to clogging. Version ${
          s.version ?? data.version}, commit ${s.commit ?? "unknown"}. MPL-2.0. State the case (above), the seed and the number of ranks: the same three give the same digits.`),
        h("p", {}, "The method grew from: A. Elrahmani (2021), thesis, Qatar University."),
        data.reference ? h("p", {}, `This case: ${data.reference}.`) : "",
        h("p", { class: "colophon" }, "Plots: Plotly.js. Player: three.js. This file is complete: it needs no network."));
    },
  };
}
