import { h } from "../dom.js";
import { frame } from "../plot.js";
import { Player } from "../player.js";
import { count } from "../units.js";

function story(tracks) {
  const drawn = tracks.times.length;
  const thin = drawn < tracks.times_in_file
    ? `${drawn} of the ${count(tracks.times_in_file)} times of tracks.csv are on this page, thinned evenly; between them particles go straight.`
    : `All ${drawn} times of tracks.csv are on this page; between them particles go straight.`;
  return `${thin} Drag to turn, wheel or pinch to zoom.`;
}

export function particles(data) {
  if (!data.tracks) {
    return {
      title: "Particles in motion",
      missing: data.kind === "flow" || data.kind === "inertial" ? "This run has no particles." : 'No tracks were written: add [[output]] kind = "tracks" to the case.',
    };
  }
  return {
    id: "particles",
    title: "Particles in motion",
    fill(section) {
      const player = new Player(data);
      section.append(frame("player", player.element, `Particles at their true size${data.scene?.outlines || data.scene?.field ? " between the grains" : ""}${
        data.walls ? "; walls of the case are seen through" : ""}. ${story(data.tracks)}`));
      window.porefines = { ...window.porefines, player };
      try {
        player.start();
      } catch (error) {
        player.canvas.replaceWith(h("p", { class: "note" }, "The player needs WebGL, which this browser does not offer."));
      }
    },
  };
}
