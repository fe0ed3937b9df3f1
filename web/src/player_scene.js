// The three-dimensional picture behind the player: box, grains, fines, a ring around a chosen place.
// Lengths are scaled so that the longest side of the box is 10.
import {
  AmbientLight, BoxGeometry, Color, DirectionalLight, EdgesGeometry, ExtrudeGeometry, InstancedMesh,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, Path, PerspectiveCamera, Quaternion, Scene, Shape, ShapeUtils,
  SphereGeometry, TorusGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";
import { MarchingCubes } from "three/examples/jsm/objects/MarchingCubes.js";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { drawWalls } from "./walls.js";

/** Box of the scene in metres: of the sample, or of the tracks where there is none. */
export function boxOf(scene, tracks) {
  if (scene) {
    return { low: [0, 0, 0], size: scene.size_m };
  }
  const size = tracks.low_m.map((low, a) => Math.max(tracks.high_m[a] - low, 1e-9));
  return { low: tracks.low_m, size };
}

function contains(outline, [x, y]) {
  let inside = false;
  for (let i = 0, j = outline.length - 1; i < outline.length; j = i++) {
    const [xi, yi] = outline[i];
    const [xj, yj] = outline[j];
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) {
      inside = !inside;
    }
  }
  return inside;
}

/** Grains of a flat sample, extruded. Outer outlines run counter-clockwise, holes clockwise. */
function extruded(outlines, depth, scale, material) {
  const points = outlines.map((outline) => outline.map(([x, y]) => new Vector2(x * scale, y * scale)));
  const isHole = points.map((corners) => ShapeUtils.isClockWise(corners));
  const shapes = points.map((corners, k) => (isHole[k] ? null : new Shape(corners)));
  outlines.forEach((outline, k) => {
    if (isHole[k]) {
      const owners = outlines
        .map((other, o) => o)
        .filter((o) => !isHole[o] && contains(outlines[o], outline[0]))
        .sort((a, b) => Math.abs(ShapeUtils.area(points[a])) - Math.abs(ShapeUtils.area(points[b])));
      if (owners.length > 0) {
        shapes[owners[0]].holes.push(new Path(points[k]));
      }
    }
  });
  const solid = new ExtrudeGeometry(shapes.filter(Boolean), { depth: depth * scale, bevelEnabled: false });
  return new Mesh(solid, material);
}

/** Surface of the grains of a volume. Beyond the box there is pore, so that it is closed. */
function surface(field, size, scale, material) {
  const [nx, ny, nz] = field.n;
  const edge = Math.max(nx, ny, nz) + 4;
  const cubes = new MarchingCubes(edge, material, false, false, 400000);
  cubes.isolation = 127.5;
  for (let k = 0; k < nz; ++k) {
    for (let j = 0; j < ny; ++j) {
      for (let i = 0; i < nx; ++i) {
        cubes.field[i + 2 + edge * (j + 2 + edge * (k + 2))] = field.values[i + nx * (j + ny * k)];
      }
    }
  }
  cubes.update();
  // Point p of the field stands at -1 + 2 p / edge; its middle of cell i is (i + 1/2) size / n.
  const cell = size.map((length, a) => (length * scale) / field.n[a]);
  cubes.scale.set(...cell.map((length) => (length * edge) / 2));
  cubes.position.set(...cell.map((length) => length * (edge / 2 - 1.5)));
  return cubes;
}

function frameOf(size, colour) {
  const edges = new EdgesGeometry(new BoxGeometry(...size));
  const lines = new LineSegments(edges, new LineBasicMaterial({ color: colour }));
  lines.position.set(...size.map((length) => length / 2));
  return lines;
}

export class PlayerScene {
  constructor(canvas, data, most) {
    this.box = boxOf(data.scene, data.tracks);
    this.scale = 10 / Math.max(...this.box.size);
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.1, 500);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.render());
    this.grains = new MeshLambertMaterial({ color: 0xc9cdd3 });
    this.lines = null;
    this.addSolids(data.scene);
    if (data.walls) {
      this.renderer.localClippingEnabled = true;
      this.scene.add(drawWalls(data.walls, (...x) => this.place(...x), this.scale, this.sides));
    }
    this.addFines(most);
    this.addLights();
    this.addRing();
  }

  get sides() {
    return this.box.size.map((length) => length * this.scale);
  }
  get flat() {
    return 4 * this.box.size[2] <= Math.min(this.box.size[0], this.box.size[1]);
  }

  place(x, y, z) {
    const [a, b, c] = this.box.low;
    return new Vector3((x - a) * this.scale, (y - b) * this.scale, (z - c) * this.scale);
  }

  addSolids(scene) {
    this.lines = frameOf(this.sides, 0x9aa2ac);
    this.scene.add(this.lines);
    if (scene?.outlines?.length) {
      this.scene.add(extruded(scene.outlines, scene.size_m[2], this.scale, this.grains));
    } else if (scene?.field) {
      this.grains.transparent = true;
      this.grains.opacity = 0.45;
      this.grains.depthWrite = false;
      this.scene.add(surface(scene.field, scene.size_m, this.scale, this.grains));
    }
  }

  addFines(most) {
    this.fines = new InstancedMesh(new SphereGeometry(1, 24, 16), new MeshLambertMaterial(), Math.max(most, 1));
    this.fines.frustumCulled = false;
    this.fines.count = 0;
    this.scene.add(this.fines);
  }

  addLights() {
    this.scene.add(new AmbientLight(0xffffff, 1.6));
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(-3, -6, 12);
    this.scene.add(sun);
  }

  addRing() {
    this.ring = new Mesh(new TorusGeometry(1, 0.09, 12, 48), new MeshLambertMaterial({ color: 0xcc79a7, emissive: 0x883366 }));
    this.ring.visible = false;
    this.scene.add(this.ring);
  }

  /** Positions [m] in triples, radii [m], colours [0..1] in triples; the first `count` of them. */
  setFines(positions, radii, colours, count) {
    const matrix = new Matrix4();
    const turn = new Quaternion();
    const colour = new Color();
    for (let k = 0; k < count; ++k) {
      const r = radii[k] * this.scale;
      matrix.compose(this.place(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]), turn, new Vector3(r, r, r));
      this.fines.setMatrixAt(k, matrix);
      colour.setRGB(colours[3 * k], colours[3 * k + 1], colours[3 * k + 2], "srgb");
      this.fines.setColorAt(k, colour);
    }
    this.fines.count = count;
    this.fines.instanceMatrix.needsUpdate = true;
    if (this.fines.instanceColor) {
      this.fines.instanceColor.needsUpdate = true;
    }
    this.render();
  }

  /** Rings a place [m]; null takes the ring away. */
  mark(place, radius) {
    this.ring.visible = place !== null;
    if (place) {
      this.ring.position.copy(this.place(...place));
      this.ring.position.z = this.flat ? this.sides[2] * 1.02 : this.ring.position.z;
      const r = radius * this.scale;
      this.ring.scale.set(r, r, r);
    }
    this.render();
  }

  colour(colours) {
    this.grains.color.set(colours.grain);
    this.lines.material.color.set(colours.line);
    this.render();
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  /** The whole box in view: a flat one from above, a volume from a corner. */
  look(fromAbove) {
    const middle = new Vector3(...this.sides.map((length) => length / 2));
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const [x, y, z] = this.sides;
    const across = this.flat ? x : Math.hypot(x, y);
    const upright = this.flat || fromAbove ? y : z + 0.5 * y;
    const distance = 1.06 * Math.max(upright / 2 / half, across / 2 / half / this.camera.aspect) + (this.flat ? z : y / 2);
    const from = fromAbove ? [0, -0.001, 1] : this.flat ? [0, -0.55, 0.84] : [-0.5, -0.75, 0.43];
    this.camera.position.copy(middle).addScaledVector(new Vector3(...from).normalize(), distance);
    this.controls.target.copy(middle);
    this.controls.update();
    this.render();
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }
}
