// The JSON island that porefines wrote (src/page/island.hpp says what is in it).

/** Deflated little-endian bytes in base64 -> ArrayBuffer. */
async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

const none = 65535;

/** 16-bit codes -> numbers over [low, high]; NaN where there is none. */
export function decode(codes, low, high) {
  return Float32Array.from(codes, (code) =>
    code === none ? NaN : low + (code * (high - low)) / (none - 1),
  );
}

async function numbers16(text) {
  return new Uint16Array(await inflate(text));
}

async function unpackMap(map) {
  const codes = await numbers16(map.values);
  map.values = decode(codes, ...map.range);
}

async function unpackTracks(tracks) {
  for (const name of ["particle", "x", "y", "z", "speed", "state"]) {
    tracks[name] = await numbers16(tracks[name]);
  }
  ["x", "y", "z"].forEach((axis, a) => {
    tracks[axis] = decode(tracks[axis], tracks.low_m[a], tracks.high_m[a]);
  });
  tracks.speed = decode(tracks.speed, 0, tracks.fastest_m_s);
}

async function unpackScene(scene) {
  if (scene.outlines) {
    const corners = await numbers16(scene.outlines.corners);
    let at = 0;
    scene.outlines = scene.outlines.counts.map((count) => {
      const outline = [];
      for (let k = 0; k < count; ++k, at += 2) {
        outline.push([
          (corners[at] / (none - 1)) * scene.size_m[0],
          (corners[at + 1] / (none - 1)) * scene.size_m[1],
        ]);
      }
      return outline;
    });
  }
  if (scene.field) {
    scene.field.values = new Uint8Array(await inflate(scene.field.values));
  }
}

export async function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  await Promise.all([
    ...(data.maps ?? []).map(unpackMap),
    data.tracks && unpackTracks(data.tracks),
    data.scene && unpackScene(data.scene),
  ]);
  return data;
}
