// A rectangle that shows the particles near it: their colours, and where the place is full of them.
import { DataTexture, DoubleSide, FloatType, GLSL3, Mesh, PlaneGeometry, RGFormat, ShaderMaterial } from "three";

const LEVELS = 65535;

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
    void main() {
      at = uv;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragment: `
    precision highp float;
    in vec2 at;
    out vec4 result;
    uniform sampler2D colours, values;
    uniform float low, high, least;
    void main() {
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

/** A rectangle without a place yet. */
export function rectangle(material) {
  const quad = new Mesh(new PlaneGeometry(1, 1), material);
  quad.frustumCulled = false;
  quad.matrixAutoUpdate = false;
  return quad;
}

/** Puts a rectangle in its place: { corner, u, v, normal }. */
export function lay(quad, { corner, u, v, normal }) {
  const middle = corner.clone().addScaledVector(u, 0.5).addScaledVector(v, 0.5);
  quad.matrix.makeBasis(u, v, normal).setPosition(middle);
  quad.matrixWorldNeedsUpdate = true;
}

/** A rectangle with the colours of the particles near it, where at least the part `least` of it is full of them. */
export class Sheet {
  constructor(uniforms, least, settings) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: FACE.vertex, fragmentShader: FACE.fragment, side: DoubleSide, transparent: true,
      uniforms: { ...uniforms, values: { value: null }, least: { value: least } },
      ...settings,
    });
    this.quad = rectangle(material);
  }

  show(points, field, place, cell, depth, most_cells) {
    const { pairs, columns, rows } = values_on(points, field, place, cell, depth, most_cells);
    this.texture?.dispose();
    this.texture = new DataTexture(pairs, columns, rows, RGFormat, FloatType);
    this.texture.needsUpdate = true;
    this.quad.material.uniforms.values.value = this.texture;
    lay(this.quad, place);
  }
}
