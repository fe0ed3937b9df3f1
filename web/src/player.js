// Particles that move: play, pause, seek, colour by fate or speed, look from above or aslant.
import { h } from "./dom.js";
import { blockingAt, Frames, rgb, speedColour } from "./frames.js";
import { PlayerScene } from "./player_scene.js";
import { fateHue, onTheme, palette } from "./theme.js";
import { quantity } from "./units.js";

const seconds = 20; // that the whole run takes at speed 1

function choice(label, options, onchange) {
  const select = h("select", { "aria-label": label, onchange: () => onchange(select.value) },
    ...options.map(([value, text]) => h("option", { value }, text)));
  return select;
}

export class Player {
  constructor(data) {
    this.data = data;
    this.frames = new Frames(data.tracks);
    this.at = 0;
    this.rate = 1;
    this.colouring = data.kind === "dry" ? "speed" : "fate";
    this.playing = false;
    this.buildControls();
  }

  buildControls() {
    this.canvas = h("canvas", { "aria-label": "Particles in the pores, drag to turn, wheel to zoom" });
    this.button = h("button", { type: "button", class: "play", onclick: () => (this.playing ? this.pause() : this.play()) }, "Play");
    this.slider = h("input", { type: "range", min: 0, max: this.frames.count - 1, step: "any", value: 0, "aria-label": "Moment of the run",
      oninput: () => this.seek(Number(this.slider.value)) });
    this.clock = h("output", {}, "");
    this.legend = h("div", { class: "legend" });
    this.element = h("div", { class: "player" }, this.canvas,
      h("div", { class: "controls" }, this.button, this.slider, this.clock,
        choice("Speed", [["0.25", "¼ ×"], ["1", "1 ×"], ["4", "4 ×"]], (value) => { this.rate = Number(value); }),
        choice("Colour", [["fate", "by fate"], ["speed", "by speed"]], (value) => { this.colouring = value; this.draw(); }),
        choice("View", this.views(), (value) => this.scene?.look(value === "above"))),
      this.legend);
    this.element.querySelector('[aria-label="Speed"]').value = "1";
    this.element.querySelector('[aria-label="Colour"]').value = this.colouring;
  }

  views() {
    const above = ["above", "from above"];
    const aslant = ["aslant", "aslant"];
    return this.isFlat() ? [above, aslant] : [aslant, above];
  }
  isFlat() {
    const size = this.data.scene?.size_m;
    return Boolean(size) && 4 * size[2] <= Math.min(size[0], size[1]);
  }

  /** Once the element is on the page. */
  start() {
    this.scene = new PlayerScene(this.canvas, this.data, this.frames.most);
    this.positions = new Float32Array(3 * this.frames.most);
    this.radii = new Float32Array(this.frames.most);
    this.colours = new Float32Array(3 * this.frames.most);
    const fit = () => this.scene.resize(this.canvas.clientWidth, this.canvas.clientHeight);
    new ResizeObserver(fit).observe(this.canvas);
    fit();
    this.scene.look(this.isFlat());
    const repaint = () => this.scene.colour(palette());
    onTheme(repaint);
    repaint();
    this.seek(this.frames.count - 1);
  }

  play() {
    if (this.at >= this.frames.count - 1) {
      this.at = 0;
    }
    this.playing = true;
    this.button.textContent = "Pause";
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) {
        return;
      }
      const move = (((now - before) / 1000) * this.rate * this.frames.count) / seconds;
      before = now;
      this.seek(this.at + move);
      if (this.at >= this.frames.count - 1) {
        this.pause();
      } else {
        requestAnimationFrame(step);
      }
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.playing = false;
    this.button.textContent = "Play";
  }

  seek(at) {
    this.at = Math.min(Math.max(at, 0), this.frames.count - 1);
    this.slider.value = this.at;
    this.draw();
  }

  /** Shows the moment and the place of an event. */
  show(time, place, radius) {
    this.pause();
    this.seek(this.frames.frameOf(time));
    this.scene?.mark(place, radius);
  }

  /** What is drawn now: [{ id, x, y, z }] in metres. */
  shown() {
    const out = [];
    this.frames.each(this.at, (particle, x, y, z) => out.push({ id: this.data.tracks.ids[particle], x, y, z }));
    return out;
  }

  draw() {
    if (!this.scene) {
      return;
    }
    const { tracks, clogging } = this.data;
    const time = this.frames.time(this.at);
    const blocking = blockingAt(clogging, time);
    let count = 0;
    this.frames.each(this.at, (particle, x, y, z, speed, state) => {
      const id = tracks.ids[particle];
      const fate = blocking.has(id) ? fateHue.clogged : state === 1 ? fateHue.bridging : fateHue.piping;
      const colour = this.colouring === "speed" ? speedColour(speed / (tracks.fastest_m_s || 1)) : rgb(fate);
      this.positions.set([x, y, z], 3 * count);
      this.colours.set(colour, 3 * count);
      this.radii[count++] = tracks.diameters_m[particle] / 2;
    });
    this.scene.setFines(this.positions, this.radii, this.colours, count);
    this.clock.textContent = `${quantity(time, "s", 3)} · ${count} inside`;
    this.drawLegend();
  }

  drawLegend() {
    if (this.legend.dataset.shows === this.colouring) {
      return;
    }
    this.legend.dataset.shows = this.colouring;
    const patch = (colour, text) => h("span", {}, h("i", { style: `background:${colour}` }), text);
    this.legend.replaceChildren(...(this.colouring === "speed"
      ? [h("span", {}, h("i", { class: "ramp" }), `0 to ${quantity(this.data.tracks.fastest_m_s, "m/s", 3)}`)]
      : [
        patch(fateHue.piping, "moving"),
        this.data.tracks.state.includes(1) ? patch(fateHue.bridging, "held") : "",
        this.data.clogging?.length ? patch(fateHue.clogged, "blocks a throat") : "",
      ]));
  }
}
