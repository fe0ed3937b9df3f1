// Walls of a run besides the grains ([[surface]] of the case): planes, cylinders, spheres, meshes, as far as they lie in the box.
import {
  BufferAttribute, BufferGeometry, CylinderGeometry, DoubleSide, Group, Mesh, MeshLambertMaterial, Plane, PlaneGeometry, Quaternion,
  SphereGeometry, Vector3,
} from "three";

/** The six faces of the box, a little outside, as planes to cut at. */
function facesOf(sides) {
  const out = 1e-3;
  return sides.flatMap((length, a) => [1, -1].map((sign) => {
    const normal = new Vector3().setComponent(a, sign);
    return new Plane(normal, sign > 0 ? out : length + out);
  }));
}

function turnedTo(mesh, from, to) {
  mesh.setRotationFromQuaternion(new Quaternion().setFromUnitVectors(from, new Vector3(...to).normalize()));
  return mesh;
}

function meshOf(wall, place, scale, long, material) {
  if (wall.kind === "plane") {
    return turnedTo(new Mesh(new PlaneGeometry(2 * long, 2 * long), material), new Vector3(0, 0, 1), wall.normal);
  }
  if (wall.kind === "cylinder") {
    const r = wall.radius_m * scale;
    return turnedTo(new Mesh(new CylinderGeometry(r, r, 4 * long, 64, 1, true), material), new Vector3(0, 1, 0), wall.axis);
  }
  if (wall.kind === "sphere") {
    return new Mesh(new SphereGeometry(wall.radius_m * scale, 48, 32), material);
  }
  const corners = new Float32Array(wall.corners_m.length);
  for (let at = 0; at < corners.length; at += 3) {
    place(...wall.corners_m.slice(at, at + 3)).toArray(corners, at);
  }
  const triangles = new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
  triangles.computeVertexNormals();
  return new Mesh(triangles, material);
}

/** A group of all walls; `place` and `scale` take metres to the scene, whose box has these sides. */
export function drawWalls(walls, place, scale, sides) {
  const material = new MeshLambertMaterial({
    color: 0x8fa3b8, side: DoubleSide, transparent: true, opacity: 0.35, depthWrite: false, clippingPlanes: facesOf(sides),
  });
  const group = new Group();
  for (const wall of walls) {
    const mesh = meshOf(wall, place, scale, Math.hypot(...sides), material);
    if (wall.kind !== "mesh") {
      mesh.position.copy(place(...wall.point_m));
    }
    group.add(mesh);
  }
  return group;
}
