import { facts, folded, h } from "../dom.js";
import { count, duration, quantity } from "../units.js";

function memory(bytes) {
  return Number.isFinite(bytes) ? `${Math.round(bytes / 2 ** 20)} MiB` : "";
}

export function caseSection(data) {
  const { summary: s } = data;
  return {
    id: "case",
    title: "Case and provenance",
    fill(section) {
      section.append(
        h("p", {}, "Everything that is needed to run this again: the case with every default filled in, in SI, and where the numbers come from."),
        facts([
          ["source of the grains", data.source],
          ["reference", data.reference],
          ["cells", s.cells && `${count(s.cells)}, of ${quantity(s.cell_size_m, "m")}${s.fluid_cells ? `; ${count(s.fluid_cells)} in the fluid` : ""}`],
          ["solver", s.solver_residual && `residual ${s.solver_residual.toPrecision(2)}, flux varies by ${(s.flux_variation ?? 0).toPrecision(2)} along the flow`],
          ["steps", s.steps && count(s.steps)],
          ["largest overlap", s.max_overlap !== undefined && s.max_overlap !== null ? `${(100 * s.max_overlap).toPrecision(3)} % of a radius` : ""],
          ["wall time", s.wall_time_s && duration(s.wall_time_s)],
          ["memory", memory(s.peak_memory_bytes)],
          ["porefines", `${s.version ?? ""}, commit ${s.commit ?? ""}`],
          ["ranks, seed", `${s.ranks ?? ""}, ${s.seed ?? ""}`],
          ["run on", s.date],
          ["page written", data.made],
        ]),
        folded("case.toml", data.case),
        folded("summary.json", JSON.stringify(s, null, 2)),
        folded("log.txt", data.log));
    },
  };
}
