// SI values as people read them.
const prefixes = [
  ["G", 1e9], ["M", 1e6], ["k", 1e3], ["", 1], ["m", 1e-3], ["µ", 1e-6], ["n", 1e-9], ["p", 1e-12], ["f", 1e-15],
];

/** The unit in which values up to `largest` read well: { factor, unit }, value = shown * factor. */
export function unitFor(largest, unit) {
  if (!unit) {
    return { factor: 1, unit: "" };
  }
  const size = Math.abs(largest);
  const [prefix, factor] =
    prefixes.find(([, f]) => size >= f * 0.9999) ?? (size > 0 ? prefixes.at(-1) : ["", 1]);
  return { factor, unit: prefix + unit };
}

export function finite(values) {
  return values.filter((value) => value !== null && Number.isFinite(value));
}

export function largest(values) {
  return values.reduce((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
}

/** A number with so many digits, with a true minus and powers of ten as superscripts. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return "–";
  }
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    const [mantissa, power] = value.toExponential(digits - 1).split("e");
    return `${mantissa.replace("-", "−")} × 10${superscript(Number(power))}`;
  }
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

function superscript(power) {
  return String(power).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
}

/** 1.2e-5 m -> "12 µm". */
export function quantity(value, unit, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return "–";
  }
  const scale = unitFor(value, unit);
  return `${number(value / scale.factor, digits)} ${scale.unit}`;
}

export function percent(share, digits = 3) {
  return Number.isFinite(share) ? `${number(100 * share, digits)} %` : "–";
}

export function count(value) {
  return Number.isFinite(value) ? Math.round(value).toLocaleString("en").replaceAll(",", " ") : "–";
}

export function duration(seconds) {
  if (!Number.isFinite(seconds)) {
    return "–";
  }
  const minutes = Math.floor(seconds / 60);
  return minutes < 1 ? `${number(seconds, 3)} s` : `${minutes} min ${Math.round(seconds % 60)} s`;
}
