// A body of one frame as three.js draws it: its surface, or its particles.
import {
  BufferAttribute, BufferGeometry, DoubleSide, FrontSide, GLSL3, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, Points, ShaderMaterial,
} from "three";

const LEVELS = 65535;
const LEAST_GAP = 1e-5; // of a surface, in the units of the box: its area, in 2D its width

/** Uniforms of everything that shows a field: its colours, and the ends of their scale in 0 ... 1. */
export const colour_uniforms = () => ({ colours: { value: null }, low: { value: 0 }, high: { value: 1 } });

const COLOUR_OF_VALUE = `
  vec3 colour_of(float value) {
    return texture(colours, vec2(clamp((value - low) / max(high - low, 1e-9), 0.002, 0.998), 0.5)).rgb;
  }`;

/** Gives a material of three.js the colour of an attribute `value` instead of its own. */
export function coloured(material, uniforms) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", "attribute float value; varying float shown;\nvoid main() { shown = value;");
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", `varying float shown; uniform sampler2D colours; uniform float low, high;
        ${COLOUR_OF_VALUE}\nvoid main() {`)
      .replace("#include <color_fragment>", "diffuseColor.rgb = colour_of(shown);");
  };
  return material;
}

/** The array of a geometry under this name, as long as it must be; made anew where it is too short. */
function array_of(geometry, name, Type, length, size) {
  const old = geometry.getAttribute(name);
  if (old && old.array.length >= length) {
    old.needsUpdate = true;
    return old.array;
  }
  const made = new BufferAttribute(new Type(Math.ceil(length * 1.2)), size);
  geometry.setAttribute(name, made);
  return made.array;
}

/** Positions in 0 ... 1 along the longest side of the box, and values in 0 ... 1. */
function fill(geometry, points, field, chosen) {
  const count = chosen ? chosen.length : points.count;
  const position = array_of(geometry, "position", Float32Array, 3 * count, 3);
  const value = array_of(geometry, "value", Float32Array, count, 1);
  const [x, y, z] = points.position;
  const shown = points.values[field];
  for (let i = 0; i < count; ++i) {
    const p = chosen ? chosen[i] : i;
    position[3 * i] = x[p] / LEVELS;
    position[3 * i + 1] = y[p] / LEVELS;
    position[3 * i + 2] = z[p] / LEVELS;
    value[i] = shown ? shown[p] / LEVELS : 0.5;
  }
  return count;
}

/** Fewer triangles of the same vertices: one stands for all in its cell of a grid of 2^bits cells along a side. */
function rough_pieces({ position: [x, y, z], count, pieces }, bits) {
  const shift = 16 - bits;
  const of_cell = new Int32Array(1 << (3 * bits)).fill(-1);
  const of_vertex = new Uint32Array(count);
  for (let i = 0; i < count; ++i) {
    const cell = ((((x[i] >> shift) << bits) | (y[i] >> shift)) << bits) | (z[i] >> shift);
    if (of_cell[cell] < 0) of_cell[cell] = i;
    of_vertex[i] = of_cell[cell];
  }
  const rough = new Uint32Array(pieces.length);
  let length = 0;
  for (let t = 0; t < pieces.length; t += 3) {
    const a = of_vertex[pieces[t]], b = of_vertex[pieces[t + 1]], c = of_vertex[pieces[t + 2]];
    if (a === b || b === c || c === a) continue;
    rough[length++] = a;
    rough[length++] = b;
    rough[length++] = c;
  }
  return rough.subarray(0, length);
}

/**
 * Whether a surface has no gaps. The line integral of a field along all edges is that around the gaps, hence the flux of
 * the field's curl through them (Stokes). In 2D it is the difference of a function between the ends of the outline.
 */
function is_closed({ pieces, count, position }, corners) {
  const field = position.map(() => new Float64Array(count));
  for (let axis = 0; axis < 3; ++axis) {
    const u = position[(axis + 1) % 3], v = position[(axis + 2) % 3];
    for (let i = 0; i < count; ++i) field[axis][i] = Math.sin((5 * u[i] + 3 * v[i]) / LEVELS + axis); // has no symmetry
  }
  let sum = 0;
  for (let i = 0; i < pieces.length; i += corners) {
    if (corners === 2) sum += field[2][pieces[i + 1]] - field[2][pieces[i]];
    for (let c = 0; corners === 3 && c < 3; ++c) {
      const a = pieces[i + c], b = pieces[i + (c + 1) % 3];
      for (let axis = 0; axis < 3; ++axis) {
        sum += ((field[axis][a] + field[axis][b]) * (position[axis][b] - position[axis][a])) / (2 * LEVELS);
      }
    }
  }
  return pieces.length > 0 && Math.abs(sum) < LEAST_GAP;
}

/** Triangles in 3D, lines in 2D. */
export class Surface {
  constructor(corners, uniforms) {
    this.geometry = new BufferGeometry();
    this.corners = corners;
    this.is_solid = corners === 3;
    this.material = this.is_solid
      ? coloured(new MeshLambertMaterial({ side: DoubleSide }), uniforms)
      : new LineBasicMaterial({ color: 0x555b63, depthTest: false, transparent: true });
    const Shape = this.is_solid ? Mesh : LineSegments;
    this.object = new Group();
    this.object.add(new Shape(this.geometry, this.material));
    for (const child of this.object.children) {
      child.frustumCulled = false;
      child.renderOrder = this.is_solid ? 0 : 3;
    }
  }

  show(points, field) {
    fill(this.geometry, points, field, null);
    if (this.points?.pieces !== points.pieces) {
      this.indices = []; // [bits]
      this.is_closed = is_closed(points, this.corners);
      this.show_sides(this.is_closed ? FrontSide : DoubleSide);
    }
    this.points = points;
    if (this.is_solid) this.smooth(points);
  }

  /** The insides of closed surfaces cannot be seen: drawing them takes half of the time. */
  show_sides(side) {
    if (!this.is_solid || side === this.material.side) return;
    this.material.side = side;
    this.material.needsUpdate = true;
  }

  /** Draws fewer triangles, those of a grid of 2^bits cells along a side, or with 0 bits all of them. */
  simplify(bits) {
    if (!this.points) return; // nothing is shown yet
    const kept = this.is_solid ? bits : 0;
    this.indices[kept] ??= new BufferAttribute(kept > 0 ? rough_pieces(this.points, kept) : this.points.pieces, 1);
    if (this.geometry.index !== this.indices[kept]) this.geometry.setIndex(this.indices[kept]);
  }

  /** Normals at the vertices: sums of those of their triangles, weighted by area. */
  smooth(points) {
    const normal = array_of(this.geometry, "normal", Float32Array, 3 * points.count, 3);
    const position = this.geometry.getAttribute("position").array;
    const { pieces } = points;
    normal.fill(0);
    for (let t = 0; t < pieces.length; t += 3) {
      const a = 3 * pieces[t], b = 3 * pieces[t + 1], c = 3 * pieces[t + 2];
      const ux = position[b] - position[a], uy = position[b + 1] - position[a + 1], uz = position[b + 2] - position[a + 2];
      const vx = position[c] - position[a], vy = position[c + 1] - position[a + 1], vz = position[c + 2] - position[a + 2];
      const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      for (const at of [a, b, c]) {
        normal[at] += nx;
        normal[at + 1] += ny;
        normal[at + 2] += nz;
      }
    }
    for (let i = 0; i < 3 * points.count; i += 3) {
      const length = Math.hypot(normal[i], normal[i + 1], normal[i + 2]) || 1;
      normal[i] /= length;
      normal[i + 1] /= length;
      normal[i + 2] /= length;
    }
  }
}

const BALL = {
  vertex: `
    in float value;
    out float shown;
    out vec3 centre;
    uniform float diameter, pixels;
    void main() {
      shown = value;
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      centre = seen.xyz;
      gl_Position = projectionMatrix * seen;
      gl_PointSize = max(1.5, diameter * pixels * projectionMatrix[1][1] / gl_Position.w);
    }`,
  // A ball that faces the camera: what lies within the circle has the normal of the ball there.
  fragment: `
    precision highp float;
    in float shown;
    in vec3 centre;
    out vec4 result;
    uniform sampler2D colours;
    uniform float low, high, diameter, is_flat;
    uniform mat4 projectionMatrix;
    ${COLOUR_OF_VALUE}
    void main() {
      vec2 at = 2.0 * gl_PointCoord - 1.0;
      float rest = 1.0 - dot(at, at);
      if (rest < 0.0) discard;
      float front = sqrt(rest);
      vec3 normal = vec3(at.x, -at.y, front);
      float light = mix(0.45 + 0.6 * max(dot(normal, normalize(vec3(-0.35, 0.5, 0.8))), 0.0), 1.0, is_flat);
      vec4 seen = projectionMatrix * vec4(centre + 0.5 * diameter * (1.0 - is_flat) * vec3(0.0, 0.0, front), 1.0);
      gl_FragDepth = 0.5 + 0.5 * seen.z / seen.w;
      result = vec4(colour_of(shown) * light, 1.0);
      result.rgb = mix(12.92 * result.rgb, 1.055 * pow(result.rgb, vec3(1.0 / 2.4)) - 0.055,
                       step(0.0031308, result.rgb));
    }`,
};

export class Particles {
  constructor(uniforms, diameter, is_flat) {
    this.geometry = new BufferGeometry();
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: BALL.vertex,
      fragmentShader: BALL.fragment,
      uniforms: { ...uniforms, diameter: { value: diameter }, pixels: { value: 1 }, is_flat: { value: is_flat ? 1 : 0 } },
    });
    this.object = new Points(this.geometry, this.material);
    this.object.frustumCulled = false;
  }

  /** `chosen`: the indices of those to draw. */
  show(points, field, chosen) {
    this.geometry.setDrawRange(0, fill(this.geometry, points, field, chosen));
  }
}
