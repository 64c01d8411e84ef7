// What planes show of the bodies: a cut that opens them, walls that hold them, and all of a body in 2D.
import {
  AlwaysStencilFunc, BackSide, BufferAttribute, BufferGeometry, DecrementWrapStencilOp, FrontSide, Group,
  IncrementWrapStencilOp, KeepStencilOp, Mesh, MeshBasicMaterial, NotEqualStencilFunc, ReplaceStencilOp, Vector3,
} from "three";
import { Sheet } from "./sheet.js";

const LEVELS = 65535;
const MOST_CELLS = 400, MOST_CELLS_OF_PLANE = 1200; // along a side of a face, and of a body in 2D
const HUGE = 1e9;

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
