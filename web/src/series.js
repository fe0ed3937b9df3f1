// series.csv against pore volumes injected, or time where there is no flow through.
import { finite, largest, unitFor } from "./units.js";

export function column(data, name) {
  return data.series?.columns[name];
}

/** The column that runs along the x axes: { name, values, factor, title }. */
export function abscissa(data) {
  const volumes = column(data, "pore_volumes");
  if (volumes && largest(volumes) > 0) {
    return { name: "pore_volumes", values: volumes, factor: 1, title: "pore volumes injected" };
  }
  const time = column(data, "time_s") ?? [];
  const { factor, unit } = unitFor(largest(time), "s");
  return { name: "time_s", values: time, factor, title: `time (${unit})` };
}

export function timeAxis(data) {
  const time = column(data, "time_s") ?? [];
  const { factor, unit } = unitFor(largest(time), "s");
  return { name: "time_s", values: time, factor, title: `time (${unit})` };
}

export function hasData(values) {
  return Boolean(values) && finite(values).length > 1;
}

/** "every third of 6,000 rows" where the series was thinned, or "". */
export function thinning(data) {
  const rows = data.series?.rows ?? 0;
  const shown = (column(data, "time_s") ?? []).length;
  return shown < rows ? ` Every ${Math.round(rows / shown)}th of ${rows} samples is drawn.` : "";
}
