// Where every particle is at any moment between two frames of the tracks.
const viridis = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/** A share 0..1 as a colour of viridis. */
export function speedColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (viridis.length - 1);
  const k = Math.min(Math.floor(at), viridis.length - 2);
  return viridis[k].map((from, c) => (from + (at - k) * (viridis[k + 1][c] - from)) / 255);
}

export function rgb(hex) {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}

/** Particles that block a throat at a time, by the clogging log. */
export function blockingAt(events, time) {
  const blocked = new Map();
  for (const event of events ?? []) {
    if (event.time_s > time) {
      break;
    }
    if (event.event === "released") {
      blocked.delete(event.throat);
    } else {
      blocked.set(event.throat, String(event.ids).split(/[\s;]+/).map(Number));
    }
  }
  return new Set([...blocked.values()].flat());
}

export class Frames {
  constructor(tracks) {
    this.tracks = tracks;
    this.count = tracks.times.length;
    this.most = 0;
    this.rows = [];
    for (let frame = 0; frame < this.count; ++frame) {
      const rows = new Map();
      for (let row = tracks.starts[frame]; row < tracks.starts[frame + 1]; ++row) {
        rows.set(tracks.particle[row], row);
      }
      this.most = Math.max(this.most, rows.size);
      this.rows.push(rows);
    }
  }

  time(at) {
    const k = Math.min(Math.floor(at), this.count - 1);
    const next = Math.min(k + 1, this.count - 1);
    return this.tracks.times[k] + (at - k) * (this.tracks.times[next] - this.tracks.times[k]);
  }

  /** The frame of a time, with its fraction. */
  frameOf(time) {
    const { times } = this.tracks;
    const k = Math.max(times.findLastIndex((t) => t <= time), 0);
    const next = Math.min(k + 1, this.count - 1);
    const span = times[next] - times[k];
    return span > 0 ? Math.min(k + (time - times[k]) / span, this.count - 1) : k;
  }

  /** Calls visit(particle, x, y, z, speed, state) for all at frame `at`; between frames they go straight. */
  each(at, visit) {
    const k = Math.min(Math.floor(at), this.count - 1);
    const share = at - k;
    const ahead = this.rows[Math.min(k + 1, this.count - 1)];
    const t = this.tracks;
    for (const [particle, row] of this.rows[k]) {
      const next = ahead.get(particle) ?? row;
      const mix = (values) => values[row] + share * (values[next] - values[row]);
      visit(particle, mix(t.x), mix(t.y), mix(t.z), t.speed[row], t.state[row]);
    }
  }
}
