// The walls of a case, where they are in each frame.
import {
  BackSide, BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  Vector3,
} from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import { COUNTED, across, stencil_layers } from "./section.js";
import { lay, rectangle } from "./sheet.js";

const COLOUR = 0xb4bcc6, INSIDE = 0x949ca6;
const GLASS = { color: COLOUR, transparent: true, opacity: 0.4, depthWrite: false };
const CREASE = 0.7; // [radians] edges that are sharper stay so
const FAR = { low: [-9, -9, -9], sides: [18, 18, 18] }; // a box around all walls

// Where a wall and a body lie against each other, the body shows.
const FARTHER = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 };

function materials_of(wall, is_flat) {
  if (is_flat) return [new MeshBasicMaterial({ color: COLOUR, side: DoubleSide, depthTest: false })];
  const outside = new MeshLambertMaterial({ color: COLOUR, side: FrontSide, ...FARTHER });
  // The face of a half-space hides no body from behind.
  return wall.is_plane ? [outside, new MeshBasicMaterial({ ...GLASS, side: BackSide, ...FARTHER })] : [outside];
}

class Wall {
  constructor(wall, is_flat) {
    this.wall = wall;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(wall.position), 3));
    geometry.setIndex(wall.triangles);
    const shape = is_flat ? geometry : toCreasedNormals(geometry, CREASE);
    this.layers = is_flat || wall.is_plane ? [] : stencil_layers(shape, -2);
    const meshes = materials_of(wall, is_flat).map((material) => new Mesh(shape, material));
    for (const mesh of meshes) mesh.frustumCulled = false;
    this.object = new Group();
    this.object.add(...meshes, ...this.layers);
  }

  show(frame, cut) {
    this.object.position.set(...(this.wall.shift?.[frame] ?? [0, 0, 0]));
    if (this.wall.angle) this.object.quaternion.setFromAxisAngle(new Vector3(...this.wall.axis), this.wall.angle[frame]);
    for (const { material } of this.object.children) material.clippingPlanes = cut ? [cut.plane] : [];
    for (const layer of this.layers) layer.visible = Boolean(cut);
  }
}

export class Walls {
  constructor(run) {
    this.walls = run.walls.map((wall) => new Wall(wall, run.dimension === 2));
    this.face = rectangle(new MeshBasicMaterial({ color: INSIDE, side: DoubleSide, ...COUNTED }));
    this.face.renderOrder = -1;
    this.object = new Group();
    this.object.add(...this.walls.map((wall) => wall.object), this.face);
  }

  show(frame, cut) {
    for (const wall of this.walls) wall.show(frame, cut);
    this.face.visible = Boolean(cut);
    if (cut) lay(this.face, across(cut.axis, cut.place, FAR));
  }
}
