// Where the bodies are cut, and which of their particles can be seen then.
import { Plane, ShaderChunk, Vector3 } from "three";

const LEVELS = 65535;

// three.js compares the middle of a pixel with the plane, also where it lies outside of the triangle: then edges of what
// is cut off would show as dots. A centroid lies inside.
for (const chunk of ["clipping_planes_pars_vertex", "clipping_planes_pars_fragment"]) {
  ShaderChunk[chunk] = ShaderChunk[chunk].replace("varying", "centroid varying");
}

/** Where the bodies are cut: axis 0 ... 2, place in the units of the box, and the side that stays. */
export class Cut {
  constructor(axis, place, flip) {
    Object.assign(this, { axis, place, side: flip ? -1 : 1 });
    const normal = new Vector3().setComponent(axis, -this.side);
    this.plane = new Plane(normal, this.side * place);
  }

  /** Distance from the plane into the part that stays. */
  depth(points, p) {
    return this.side * (this.place - points.position[this.axis][p] / LEVELS);
  }
}

/**
 * The particles that can be seen: those with a free cell of a grid beside them. `cut` frees the cells
 * beyond it. Particles inside are hidden by the others, and not drawing them saves most of the time.
 */
export function visible_particles(points, cell, cut) {
  const [x, y, z] = points.position;
  const size = cell * LEVELS;
  const side = Math.floor(LEVELS / size) + 3;
  const occupied = new Set();
  const key_of = (i, j, k) => (i * side + j) * side + k;
  const cells = new Float64Array(points.count);
  for (let p = 0; p < points.count; ++p) {
    const key = key_of(1 + Math.floor(x[p] / size), 1 + Math.floor(y[p] / size), 1 + Math.floor(z[p] / size));
    cells[p] = key;
    if (!cut || cut.depth(points, p) >= 0) occupied.add(key);
  }
  const steps = [1, -1, side, -side, side * side, -side * side];
  const inside = new Map();
  const is_inside = (key) => {
    if (!inside.has(key)) inside.set(key, steps.every((step) => occupied.has(key + step)));
    return inside.get(key);
  };
  const chosen = new Uint32Array(points.count);
  let count = 0;
  for (let p = 0; p < points.count; ++p) {
    if (cut && cut.depth(points, p) < 0) continue;
    if (!is_inside(cells[p])) chosen[count++] = p;
  }
  return chosen.subarray(0, count);
}
