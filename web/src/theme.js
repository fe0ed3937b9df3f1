// Light and dark: the reader's system decides until the switch is used. Colours are Okabe and Ito's,
// which readers with any colour vision can tell apart.
export const hue = {
  blue: "#0072b2",
  vermilion: "#d55e00",
  green: "#009e73",
  orange: "#e69f00",
  sky: "#56b4e9",
  purple: "#cc79a7",
  grey: "#8a8f98",
};

export const fateHue = {
  piping: hue.sky,
  bridging: hue.orange,
  clogged: hue.vermilion,
  resting: hue.grey,
};

const palettes = {
  light: { ink: "#24292f", soft: "#5b6470", grid: "#e3e6ea", line: "#9aa2ac", grain: "#c9cdd3", paper: "#ffffff" },
  dark: { ink: "#e4e7eb", soft: "#a3abb6", grid: "#2f363f", line: "#5c6672", grain: "#4a525c", paper: "#14181d" },
};

const listeners = [];
const system = matchMedia("(prefers-color-scheme: dark)");
let chosen = null;

export function theme() {
  return chosen ?? (system.matches ? "dark" : "light");
}

export function palette(name = theme()) {
  return palettes[name];
}

export function onTheme(listener) {
  listeners.push(listener);
}

function tell() {
  document.documentElement.dataset.theme = theme();
  listeners.forEach((listener) => listener());
}

export function setTheme(name) {
  chosen = name;
  tell();
}

export function startTheme() {
  document.documentElement.dataset.theme = theme();
  system.addEventListener("change", tell);
  let before = null;
  addEventListener("beforeprint", () => {
    before = { chosen };
    setTheme("light");
  });
  addEventListener("afterprint", () => {
    if (before) {
      setTheme(before.chosen);
      before = null;
    }
  });
}

/** What plots take from the theme. */
export function template(name = theme()) {
  const colours = palettes[name];
  const axis = {
    gridcolor: colours.grid,
    linecolor: colours.line,
    zerolinecolor: colours.grid,
    tickcolor: colours.line,
    ticks: "outside",
    ticklen: 4,
    showline: true,
    title: { standoff: 8, font: { size: 13 } },
    automargin: true,
  };
  return {
    layout: {
      font: { family: "system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif", size: 12, color: colours.ink },
      paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: "rgba(0,0,0,0)",
      colorway: [hue.blue, hue.vermilion, hue.green, hue.purple, hue.orange, hue.sky],
      xaxis: axis,
      yaxis: axis,
      modebar: { bgcolor: "rgba(0,0,0,0)", color: colours.line, activecolor: colours.ink },
      hoverlabel: { bgcolor: colours.paper, bordercolor: colours.line, font: { color: colours.ink } },
      legend: { orientation: "h", traceorder: "normal", y: 1.02, yanchor: "bottom", x: 0, bgcolor: "rgba(0,0,0,0)" },
    },
  };
}
