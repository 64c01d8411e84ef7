// What planes show of the bodies: a cut that opens them, walls that hold them, and all of a body in 2D.
import {
  AlwaysStencilFunc, BackSide, BufferAttribute, BufferGeometry, DataTexture, DecrementWrapStencilOp, DoubleSide, FloatType, FrontSide, GLSL3, Group,
  IncrementWrapStencilOp, KeepStencilOp, Mesh, MeshBasicMaterial, NotEqualStencilFunc, Plane, PlaneGeometry,
  RGFormat, ReplaceStencilOp, ShaderMaterial, Vector3, Vector4,
} from "three";

const LEVELS = 65535;
const MOST_CELLS = 400, MOST_CELLS_OF_PLANE = 1200; // along a side of a face, and of a body in 2D
const HUGE = 1e9;

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

/**
 * Values of the particles near a rectangle, as pairs on a grid [row][column] in it: the mean, and how much of the
 * place is full of particles, 1 inside of bodies and 0.5 at their edges. `place`: { corner, u, v, normal }, the
 * sides as vectors; particles as far from it as `depth` count.
 */
function values_on(points, field, place, cell, depth, most_cells) {
  const width = place.u.length(), height = place.v.length();
  const columns = Math.min(most_cells, Math.max(2, Math.ceil((2 * width) / cell)));
  const rows = Math.min(most_cells, Math.max(2, Math.ceil((2 * height) / cell)));
  const pairs = new Float32Array(2 * columns * rows);
  const step = [width / (columns - 1), height / (rows - 1)];
  const reach = Math.max(2 * cell, 1.5 * step[0], 1.5 * step[1]);
  const first = place.u.clone().divideScalar(width), second = place.v.clone().divideScalar(height);
  const [px, py, pz] = points.position;
  const values = points.values[field];
  const seen = [];
  for (let p = 0; p < points.count; ++p) {
    const x = px[p] / LEVELS - place.corner.x, y = py[p] / LEVELS - place.corner.y, z = pz[p] / LEVELS - place.corner.z;
    const away = x * place.normal.x + y * place.normal.y + z * place.normal.z;
    if (Math.abs(away) > depth) continue;
    const u = x * first.x + y * first.y + z * first.z, v = x * second.x + y * second.y + z * second.z;
    const c0 = Math.max(0, Math.ceil((u - reach) / step[0])), c1 = Math.min(columns - 1, Math.floor((u + reach) / step[0]));
    const r0 = Math.max(0, Math.ceil((v - reach) / step[1])), r1 = Math.min(rows - 1, Math.floor((v + reach) / step[1]));
    if (c0 <= c1 && r0 <= r1) seen.push(Math.round((r0 + r1) / 2) * columns + Math.round((c0 + c1) / 2));
    const shown = values ? values[p] / LEVELS : 0.5;
    for (let r = r0; r <= r1; ++r) {
      for (let c = c0; c <= c1; ++c) {
        const d2 = ((u - c * step[0]) ** 2 + (v - r * step[1]) ** 2) / reach ** 2;
        if (d2 >= 1) continue;
        const w = (1 - d2) ** 2;
        const i = 2 * (r * columns + c);
        pairs[i] += w * shown;
        pairs[i + 1] += w;
      }
    }
  }
  // What is full is what most particles have around them: the mean of those above the mean.
  const mean = (list) => list.reduce((sum, i) => sum + pairs[2 * i + 1], 0) / (list.length || 1);
  const usual = mean(seen);
  const full = mean(seen.filter((i) => pairs[2 * i + 1] >= usual)) || 1;
  for (let i = 0; i < pairs.length; i += 2) {
    if (pairs[i + 1] > 0) pairs[i] /= pairs[i + 1];
    pairs[i + 1] /= full;
  }
  return { pairs, columns, rows };
}

const FACE = {
  vertex: `
    out vec2 at;
    out vec3 here;
    void main() {
      at = uv;
      here = (modelMatrix * vec4(position, 1.0)).xyz;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragment: `
    precision highp float;
    in vec2 at;
    in vec3 here;
    out vec4 result;
    uniform sampler2D colours, values;
    uniform float low, high, least;
    uniform vec4 cut;
    void main() {
      if (dot(cut.xyz, here) + cut.w < 0.0) discard;
      ivec2 size = textureSize(values, 0);
      vec2 place = at * vec2(size - 1);
      ivec2 first = ivec2(place);
      vec2 part = place - vec2(first);
      vec2 sum = vec2(0.0);
      float filled = 0.0;
      for (int r = 0; r < 2; ++r) for (int c = 0; c < 2; ++c) {
        vec2 pair = texelFetch(values, min(first + ivec2(c, r), size - 1), 0).rg;
        float w = (c == 1 ? part.x : 1.0 - part.x) * (r == 1 ? part.y : 1.0 - part.y) + 1e-6;
        filled += w * pair.y;
        if (pair.y > 0.0) sum += w * vec2(pair.x, 1.0);
      }
      float width = max(fwidth(filled), 1e-4);
      float alpha = clamp((filled - least) / width + 0.5, 0.0, 1.0);
      if (alpha <= 0.0 || sum.y == 0.0) discard;
      float shown = (sum.x / sum.y - low) / max(high - low, 1e-9);
      vec3 linear = texture(colours, vec2(clamp(shown, 0.002, 0.998), 0.5)).rgb;
      result = vec4(mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear)), alpha);
    }`,
};

/** A rectangle with the colours of the particles near it, where at least the part `least` of it is full of them. */
class Sheet {
  constructor(uniforms, least, settings) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: FACE.vertex, fragmentShader: FACE.fragment, side: DoubleSide, transparent: true,
      uniforms: { ...uniforms, values: { value: null }, least: { value: least }, cut: { value: new Vector4(0, 0, 0, 1) } },
      ...settings,
    });
    this.quad = new Mesh(new PlaneGeometry(1, 1), material);
    this.quad.frustumCulled = false;
    this.quad.matrixAutoUpdate = false;
  }

  show(points, field, place, cell, depth, most_cells) {
    const { pairs, columns, rows } = values_on(points, field, place, cell, depth, most_cells);
    this.texture?.dispose();
    this.texture = new DataTexture(pairs, columns, rows, RGFormat, FloatType);
    this.texture.needsUpdate = true;
    this.quad.material.uniforms.values.value = this.texture;
    const middle = place.corner.clone().addScaledVector(place.u, 0.5).addScaledVector(place.v, 0.5);
    this.quad.matrix.makeBasis(place.u, place.v, place.normal).setPosition(middle);
    this.quad.matrixWorldNeedsUpdate = true;
  }

  /** Shows only what a cut leaves. */
  open(cut) {
    const { normal, constant } = cut ? cut.plane : { normal: new Vector3(), constant: 1 };
    this.quad.material.uniforms.cut.value.set(normal.x, normal.y, normal.z, constant);
  }
}

/** The box of the bodies and a cell around it: { low, sides }. */
const grown = ({ low, sides }, cell) => ({ low: low.map((value) => value - cell), sides: sides.map((value) => value + 2 * cell) });

/** The rectangle of a box across an axis. */
function across(axis, at, { low, sides }) {
  const first = (axis + 1) % 3, second = (axis + 2) % 3;
  const corner = new Vector3().setComponent(axis, at);
  corner.setComponent(first, low[first]).setComponent(second, low[second]);
  return {
    corner, u: new Vector3().setComponent(first, sides[first]), v: new Vector3().setComponent(second, sides[second]),
    normal: new Vector3().setComponent(axis, 1),
  };
}

/**
 * What part of a place at the edge of a body is full of particles, by `values_on`: half of it where the edge lies
 * between particles and none, three quarters where it goes through the last of them.
 */
export const edge_of = (method) => (["total_lagrangian", "point_based"].includes(method) ? 0.75 : 0.5);

/** Whether each place is the end of as many pieces as it is the start of. */
function is_closed({ pieces, position: [x, y] }) {
  const balance = new Map();
  const count = (vertex, change) => {
    const key = x[vertex] * (LEVELS + 1) + y[vertex];
    balance.set(key, (balance.get(key) ?? 0) + change);
  };
  for (let i = 0; i < pieces.length; i += 2) {
    count(pieces[i], 1);
    count(pieces[i + 1], -1);
  }
  return pieces.length > 0 && [...balance.values()].every((value) => value === 0);
}

/**
 * A body in 2D: the place inside its outline, or, where that is open as at walls, the place that its particles fill.
 * Triangles from one point to all pieces of the outline count in the stencil how often it goes round a place.
 */
export class Filling {
  constructor(uniforms, edge) {
    this.edge = edge;
    this.fan = new BufferGeometry();
    this.layers = [
      stencil_layer(this.fan, FrontSide, IncrementWrapStencilOp),
      stencil_layer(this.fan, BackSide, DecrementWrapStencilOp),
    ];
    this.sheet = new Sheet(uniforms, edge, {
      depthTest: false, depthWrite: false, stencilWrite: true, stencilRef: 0, stencilFail: KeepStencilOp,
      stencilZFail: ReplaceStencilOp, stencilZPass: ReplaceStencilOp,
    });
    this.sheet.quad.renderOrder = 2;
    this.object = new Group();
    this.object.add(...this.layers, this.sheet.quad);
  }

  /** `outline`: the points and pieces of the surface, with the positions that are drawn; none where the run has none. */
  show(points, field, cell, box, outline) {
    const closed = Boolean(outline) && is_closed(outline.points);
    for (const layer of this.layers) layer.visible = closed;
    if (closed && this.pieces !== outline.points.pieces) {
      this.pieces = outline.points.pieces;
      const index = new Uint32Array(1.5 * this.pieces.length);
      for (let i = 0, at = 0; i < this.pieces.length; i += 2) {
        index[at++] = this.pieces[0];
        index[at++] = this.pieces[i];
        index[at++] = this.pieces[i + 1];
      }
      this.fan.setIndex(new BufferAttribute(index, 1));
    }
    if (closed) this.fan.setAttribute("position", outline.position);
    const { material } = this.sheet.quad;
    material.stencilFunc = closed ? NotEqualStencilFunc : AlwaysStencilFunc;
    material.uniforms.least.value = closed ? 0.02 : this.edge;
    this.sheet.show(points, field, across(2, 0, grown(box, 2 * cell)), cell, HUGE, MOST_CELLS_OF_PLANE);
  }
}

/** Where a flat wall holds bodies: their surface is open there. */
export class Contact {
  constructor(plane, uniforms, edge) {
    this.point = new Vector3(...plane.point);
    this.normal = new Vector3(...plane.normal);
    this.sheet = new Sheet(uniforms, edge, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.object = this.sheet.quad;
  }

  show(points, field, cut, cell, box, shift) {
    const middle = new Vector3(...box.low.map((value, a) => value + box.sides[a] / 2));
    const half = new Vector3(...box.sides).length() / 2 + cell;
    const away = middle.clone().sub(this.point).sub(shift).dot(this.normal);
    const u = new Vector3(this.normal.y, this.normal.z, this.normal.x).cross(this.normal);
    if (u.length() < 0.1) u.set(1, 0, 0).cross(this.normal);
    u.setLength(2 * half);
    const v = this.normal.clone().cross(u).setLength(2 * half);
    const corner = middle.addScaledVector(this.normal, -away).addScaledVector(u, -0.5).addScaledVector(v, -0.5);
    this.sheet.show(points, field, { corner, u, v, normal: this.normal }, cell, 1.2 * cell, MOST_CELLS);
    this.sheet.open(cut);
  }
}

function stencil_layer(geometry, side, operation) {
  const material = new MeshBasicMaterial({
    side, depthWrite: false, depthTest: false, colorWrite: false, stencilWrite: true, stencilFunc: AlwaysStencilFunc,
    stencilFail: operation, stencilZFail: operation, stencilZPass: operation,
  });
  const layer = new Mesh(geometry, material);
  layer.frustumCulled = false;
  layer.renderOrder = 1;
  return layer;
}

/**
 * The face of the cut through closed surfaces. Along a ray that leaves a body through the plane one
 * more back than front remains behind the plane; the stencil counts them.
 */
export class Face {
  constructor(geometry, uniforms, edge) {
    this.layers = [
      stencil_layer(geometry, BackSide, IncrementWrapStencilOp),
      stencil_layer(geometry, FrontSide, DecrementWrapStencilOp),
    ];
    // Rays that leave through an open part of the surface count wrong. Then what is full of particles shows instead.
    this.filling = new Sheet(uniforms, edge, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.face = new Sheet(uniforms, 0.05, {
      stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc,
      stencilFail: KeepStencilOp, stencilZFail: KeepStencilOp, stencilZPass: ReplaceStencilOp,
    });
    this.face.quad.renderOrder = 2;
    this.object = new Group();
    this.object.add(...this.layers, this.filling.quad, this.face.quad);
    this.object.visible = false;
  }

  /** `box`: { low, sides } of the bodies; `cell`: the distance between particles. */
  show(points, field, cut, cell, box) {
    this.object.visible = Boolean(cut && points);
    if (!this.object.visible) return;
    for (const layer of this.layers) layer.material.clippingPlanes = [cut.plane];
    const place = across(cut.axis, cut.place, grown(box, cell));
    for (const sheet of [this.filling, this.face]) sheet.show(points, field, place, cell, 1.2 * cell, MOST_CELLS);
  }
}
