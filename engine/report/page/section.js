// A plane that opens the bodies: which particles remain, and the face of the cut.
import {
  AlwaysStencilFunc, BackSide, DataTexture, DecrementWrapStencilOp, FloatType, FrontSide, GLSL3, Group,
  IncrementWrapStencilOp, KeepStencilOp, Mesh, MeshBasicMaterial, NotEqualStencilFunc, Plane, PlaneGeometry,
  RedFormat, ReplaceStencilOp, ShaderMaterial, Vector3,
} from "three";

const LEVELS = 65535;
const MOST_CELLS = 400; // along a side of the face

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

/** Values of the particles near the plane on a grid [row][column] in it; NaN where there are none. */
function values_on_plane(points, field, cut, cell, low, sides) {
  const [first, second] = [(cut.axis + 1) % 3, (cut.axis + 2) % 3];
  const columns = Math.min(MOST_CELLS, Math.max(2, Math.ceil((2 * sides[first]) / cell)));
  const rows = Math.min(MOST_CELLS, Math.max(2, Math.ceil((2 * sides[second]) / cell)));
  const sum = new Float32Array(columns * rows), weight = new Float32Array(columns * rows);
  const reach = 2 * cell;
  const step = [sides[first] / (columns - 1), sides[second] / (rows - 1)];
  const values = points.values[field];
  for (let p = 0; p < points.count; ++p) {
    const away = cut.depth(points, p);
    if (Math.abs(away) > reach) continue;
    const u = points.position[first][p] / LEVELS - low[first], v = points.position[second][p] / LEVELS - low[second];
    const c0 = Math.max(0, Math.ceil((u - reach) / step[0])), c1 = Math.min(columns - 1, Math.floor((u + reach) / step[0]));
    const r0 = Math.max(0, Math.ceil((v - reach) / step[1])), r1 = Math.min(rows - 1, Math.floor((v + reach) / step[1]));
    for (let r = r0; r <= r1; ++r) {
      for (let c = c0; c <= c1; ++c) {
        const d2 = (away ** 2 + (u - c * step[0]) ** 2 + (v - r * step[1]) ** 2) / reach ** 2;
        if (d2 >= 1) continue;
        const w = (1 - d2) ** 2 / (d2 + 0.01);
        sum[r * columns + c] += (w * values[p]) / LEVELS;
        weight[r * columns + c] += w;
      }
    }
  }
  for (let i = 0; i < sum.length; ++i) sum[i] = weight[i] > 0 ? sum[i] / weight[i] : -1;
  return { data: sum, columns, rows };
}

const FACE = {
  vertex: "out vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
  fragment: `
    precision highp float;
    in vec2 at;
    out vec4 result;
    uniform sampler2D colours, values;
    uniform float low, high;
    void main() {
      ivec2 size = textureSize(values, 0);
      vec2 place = at * vec2(size - 1);
      ivec2 first = ivec2(place);
      vec2 part = place - vec2(first);
      float sum = 0.0, weight = 0.0;
      for (int r = 0; r < 2; ++r) for (int c = 0; c < 2; ++c) {
        float value = texelFetch(values, min(first + ivec2(c, r), size - 1), 0).r;
        float w = (c == 1 ? part.x : 1.0 - part.x) * (r == 1 ? part.y : 1.0 - part.y) + 1e-6;
        if (value >= 0.0) { sum += w * value; weight += w; }
      }
      if (weight == 0.0) { result = vec4(0.6, 0.6, 0.6, 1.0); return; }
      float shown = (sum / weight - low) / max(high - low, 1e-9);
      vec3 linear = texture(colours, vec2(clamp(shown, 0.002, 0.998), 0.5)).rgb;
      result = vec4(mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear)), 1.0);
    }`,
};

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
  constructor(geometry, uniforms) {
    this.layers = [
      stencil_layer(geometry, BackSide, IncrementWrapStencilOp),
      stencil_layer(geometry, FrontSide, DecrementWrapStencilOp),
    ];
    this.texture = null;
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: FACE.vertex, fragmentShader: FACE.fragment, side: 2,
      uniforms: { ...uniforms, values: { value: null } },
      stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc,
      stencilFail: KeepStencilOp, stencilZFail: KeepStencilOp, stencilZPass: ReplaceStencilOp,
    });
    this.quad = new Mesh(new PlaneGeometry(1, 1), material);
    this.quad.frustumCulled = false;
    this.quad.renderOrder = 2;
    this.object = new Group();
    this.object.add(...this.layers, this.quad);
    this.object.visible = false;
  }

  /** `box`: { low, sides } of the bodies; `cell`: the distance between particles. */
  show(points, field, cut, cell, box) {
    this.object.visible = Boolean(cut && points);
    if (!this.object.visible) return;
    for (const layer of this.layers) layer.material.clippingPlanes = [cut.plane];
    const low = box.low.map((value) => value - cell), sides = box.sides.map((value) => value + 2 * cell);
    const { data, columns, rows } = values_on_plane(points, field, cut, cell, low, sides);
    this.texture?.dispose();
    this.texture = new DataTexture(data, columns, rows, RedFormat, FloatType);
    this.texture.needsUpdate = true;
    this.quad.material.uniforms.values.value = this.texture;
    this.place(cut, low, sides);
  }

  /** Lays the unit square into the plane, its u along the axis after the normal. */
  place(cut, low, sides) {
    const first = (cut.axis + 1) % 3, second = (cut.axis + 2) % 3;
    const u = new Vector3().setComponent(first, sides[first]), v = new Vector3().setComponent(second, sides[second]);
    const middle = new Vector3().setComponent(cut.axis, cut.place);
    middle.setComponent(first, low[first] + sides[first] / 2);
    middle.setComponent(second, low[second] + sides[second] / 2);
    this.quad.matrixAutoUpdate = false;
    this.quad.matrix.makeBasis(u, v, new Vector3().setComponent(cut.axis, 1)).setPosition(middle);
    this.quad.matrixWorldNeedsUpdate = true;
  }
}
