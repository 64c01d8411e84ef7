// What planes show of the bodies: the faces of a cut, and all of a body in 2D.
import {
  AlwaysStencilFunc, BackSide, BufferAttribute, BufferGeometry, DecrementWrapStencilOp, FrontSide, Group,
  IncrementWrapStencilOp, KeepStencilOp, Mesh, MeshBasicMaterial, NotEqualStencilFunc, ReplaceStencilOp, Vector3,
} from "three";
import { Sheet } from "./sheet.js";

const MOST_CELLS = 400, MOST_CELLS_OF_PLANE = 1200; // along a side of a face, and of a body in 2D
const HUGE = 1e9;

/** The box of the bodies and a cell around it: { low, sides }. */
const grown = ({ low, sides }, cell) => ({ low: low.map((value) => value - cell), sides: sides.map((value) => value + 2 * cell) });

/** The rectangle of a box across an axis. */
export function across(axis, at, { low, sides }) {
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

/** Meshes that count in the stencil how many more backs than fronts of a surface there are along each ray. */
export function stencil_layers(geometry, order) {
  return [[BackSide, IncrementWrapStencilOp], [FrontSide, DecrementWrapStencilOp]].map(([side, operation]) => {
    const material = new MeshBasicMaterial({
      side, depthWrite: false, depthTest: false, colorWrite: false, stencilWrite: true, stencilFunc: AlwaysStencilFunc,
      stencilFail: operation, stencilZFail: operation, stencilZPass: operation,
    });
    const layer = new Mesh(geometry, material);
    layer.frustumCulled = false;
    layer.renderOrder = order;
    return layer;
  });
}

/** Settings of what shows where the layers have counted, and lets them start anew. */
export const COUNTED = {
  stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc, stencilFail: KeepStencilOp,
  stencilZFail: ReplaceStencilOp, stencilZPass: ReplaceStencilOp,
};

/**
 * A body in 2D: the place inside its outline, or, where that is open as at walls, the place that its particles fill.
 * Triangles from one point to all pieces of the outline count in the stencil how often it goes round a place.
 */
export class Filling {
  constructor(uniforms, edge) {
    this.edge = edge;
    this.fan = new BufferGeometry();
    this.layers = stencil_layers(this.fan, 1);
    this.sheet = new Sheet(uniforms, edge, { depthTest: false, depthWrite: false, ...COUNTED });
    this.sheet.quad.renderOrder = 2;
    this.object = new Group();
    this.object.add(...this.layers, this.sheet.quad);
  }

  /** `outline`: the surface; none where the run has none. */
  show(points, field, cell, box, outline) {
    const closed = Boolean(outline?.is_closed);
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
    if (closed) this.fan.setAttribute("position", outline.geometry.getAttribute("position"));
    const { material } = this.sheet.quad;
    material.stencilFunc = closed ? NotEqualStencilFunc : AlwaysStencilFunc;
    material.uniforms.least.value = closed ? 0.02 : this.edge;
    this.sheet.show(points, field, across(2, 0, grown(box, 2 * cell)), cell, HUGE, MOST_CELLS_OF_PLANE);
  }
}

/**
 * The face of the cut through closed surfaces. Along a ray that leaves a body through the plane one
 * more back than front remains behind the plane; the stencil counts them.
 */
export class Face {
  constructor(surface, uniforms, edge) {
    this.surface = surface;
    this.layers = stencil_layers(surface.geometry, 1);
    // Rays count wrong where the surface has gaps, as along cuts. Then what is full of particles shows too.
    this.filling = new Sheet(uniforms, edge, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.face = new Sheet(uniforms, 0.2, COUNTED);
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
    this.filling.quad.visible = !this.surface.is_closed;
    const sheets = this.filling.quad.visible ? [this.filling, this.face] : [this.face];
    for (const sheet of sheets) sheet.show(points, field, place, cell, 1.2 * cell, MOST_CELLS);
  }
}
