import { addFigure, line } from "../plot.js";
import { abscissa, column, hasData, thinning } from "../series.js";
import { hue } from "../theme.js";

export function breakthrough(data) {
  const came = column(data, "particles_injected");
  if (data.kind !== "coupled" || !hasData(came) || Math.max(...came) === 0) {
    return { title: "Breakthrough", missing: data.kind === "coupled" ? "No fines were injected: they were there from the start." : "No fines are injected with a flow in this run." };
  }
  return {
    id: "breakthrough",
    title: "Breakthrough",
    fill(section) {
      const axis = abscissa(data);
      const ratio = column(data, "concentration_ratio");
      const left = column(data, "particles_out");
      const common = { xFactor: axis.factor };
      if (hasData(ratio)) {
        addFigure(section, {
          name: "breakthrough",
          caption: `Breakthrough curve: concentration at the outlet over that at the inlet, C/C₀, by volume, over the interval of each sample. Few fines per interval make it noisy.${thinning(data)}`,
          csv: { [axis.name]: axis.values, concentration_ratio: ratio },
          traces: () => [line("concentration_ratio", axis.values, ratio, { ...common, name: "C/C₀", line: { color: hue.green, width: 2, shape: "hv" } })],
          layout: () => ({ hovermode: "x unified", xaxis: { title: { text: axis.title } }, yaxis: { title: { text: "C / C₀" }, rangemode: "tozero" } }),
        });
      }
      addFigure(section, {
        name: "injected-and-out",
        caption: "Fines that have come in, and those that have left through the outlet; the gap is what is inside.",
        csv: { [axis.name]: axis.values, particles_injected: came, particles_out: left },
        traces: () => [
          line("particles_injected", axis.values, came, { ...common, name: "came in", line: { color: hue.blue, width: 2, shape: "hv" } }),
          line("particles_out", axis.values, left, { ...common, name: "left", line: { color: hue.vermilion, width: 2, shape: "hv", dash: "dash" } }),
        ],
        layout: () => ({ hovermode: "x unified", xaxis: { title: { text: axis.title } }, yaxis: { title: { text: "number of fines" }, rangemode: "tozero" } }),
      });
    },
  };
}
