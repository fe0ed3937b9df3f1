import { h } from "../dom.js";
import { addFigure, frame } from "../plot.js";
import { palette } from "../theme.js";
import { quantity as worded, unitFor } from "../units.js";

const scales = { speed: "Viridis", pressure: "Cividis" };

/** The end of a colour scale that a few fast cells do not stretch. */
function upperEnd(values) {
  const sorted = values.filter((value) => !Number.isNaN(value)).sort();
  return sorted[Math.floor(0.998 * (sorted.length - 1))] ?? 1;
}

/** One quantity on one plane: cells in colour, grains in grey. */
function addMap(parent, map, kind) {
  const [width, height] = map.n;
  const length = unitFor(Math.max(width * map.step_m[0], height * map.step_m[1]), "m");
  const values = unitFor(Math.max(...map.range.map(Math.abs)), map.unit);
  const along = (axis, cells) =>
    Array.from({ length: cells }, (_, k) => (map.low_m[axis] + k * map.step_m[axis]) / length.factor);
  const rows = Array.from({ length: height }, (_, row) =>
    Array.from(map.values.subarray(row * width, (row + 1) * width), (value) =>
      Number.isNaN(value) ? null : value / values.factor));
  const [right, up] = map.axes;
  const aspect = (height * map.step_m[1]) / (width * map.step_m[0]);
  const name = `${map.quantity}-${map.normal}`;
  addFigure(parent, {
    name,
    height: (width) => Math.min(aspect > 1 ? 440 : 680, (width - 150) * aspect + 64),
    caption: `${map.quantity === "speed" ? "Speed of the water" : "Pressure"} on the plane ${map.normal} = ${
      worded(map.position_m, "m", 3)}${kind === "inertial" || kind === "coupled" ? `, at ${worded(map.time_s, "s", 3)}` : ""}; grains${map.quantity === "pressure" && kind === "coupled" ? " and fines" : ""} are grey.${
      map.thinned > 1 ? ` Every ${map.thinned}th cell is drawn.` : ""}`,
    csv: {
      [`${right}_m`]: rows.flatMap((row) => row.map((_, k) => map.low_m[0] + k * map.step_m[0])),
      [`${up}_m`]: rows.flatMap((row, k) => row.map(() => map.low_m[1] + k * map.step_m[1])),
      [`${map.quantity}_${map.unit.replace("/", "_")}`]: Array.from(map.values),
    },
    traces: () => [{
      type: "heatmap",
      x: along(0, width),
      y: along(1, height),
      z: rows,
      zmin: map.range[0] / values.factor,
      zmax: upperEnd(map.values) / values.factor,
      zsmooth: false,
      colorscale: scales[map.quantity],
      meta: { column: map.quantity, factor: values.factor },
      colorbar: { title: { text: `${map.quantity} (${values.unit})`, side: "right" }, thickness: 12, outlinewidth: 0, len: 1 },
      hovertemplate: `%{z:.4g} ${values.unit} at (%{x:.4g}, %{y:.4g}) ${length.unit}<extra></extra>`,
    }],
    layout: () => ({
      margin: { l: 60, r: 8, t: 12, b: 48 },
      plot_bgcolor: palette().grain,
      xaxis: { title: { text: `${right} (${length.unit})` }, showgrid: false, constrain: "domain" },
      yaxis: { title: { text: `${up} (${length.unit})` }, showgrid: false, scaleanchor: "x", constrain: "domain" },
    }),
  });
}

function addPicture(parent, picture) {
  const words = { speed: "Speed of the water", pressure: "Pressure", particles: "Fines by fate, at the end of the run" };
  parent.append(frame(`picture-${picture.name}`,
    h("img", { src: picture.address, alt: words[picture.name] }),
    `${words[picture.name]}, as the run drew it. Write the fields ([[output]] kind = "fields") for a picture that tells values.`));
}

export function flow(data) {
  if (data.maps.length > 0) {
    return {
      id: "flow",
      title: "Flow",
      fill(section) {
        for (const quantity of ["speed", "pressure"]) {
          const maps = data.maps.filter((map) => map.quantity === quantity);
          const place = maps.length > 1 ? h("div", { class: "pair" }) : section;
          maps.forEach((map) => addMap(place, map, data.kind));
          if (place !== section) {
            section.append(place);
          }
        }
      },
    };
  }
  if (data.pictures.length > 0 && data.kind !== "dry") {
    return { id: "flow", title: "Flow", fill: (section) => data.pictures.filter(({ name }) => name !== "particles" || !data.tracks).forEach((picture) => addPicture(section, picture)) };
  }
  return {
    title: "Pictures of the flow",
    missing: data.kind === "dry" ? "There is no fluid in this run." : 'Neither fields nor pictures were written: add [[output]] kind = "fields" to the case.',
  };
}
