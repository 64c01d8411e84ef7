// The walls of a case, where they are in each frame.
import {
  BackSide, BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, Vector3,
} from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import { Contact } from "./section.js";

const COLOUR = 0xb4bcc6, INSIDE = 0x949ca6;
const CREASE = 0.7; // [radians] edges that are sharper stay so

class Wall {
  constructor(wall, uniforms, edge, is_flat) {
    this.wall = wall;
    this.object = new Group();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(wall.position), 3));
    geometry.setIndex(wall.triangles);
    this.materials = is_flat
      ? [new MeshBasicMaterial({ color: COLOUR, side: DoubleSide, depthTest: false })]
      : [new MeshLambertMaterial({ color: COLOUR, side: FrontSide }), new MeshBasicMaterial({ color: INSIDE, side: BackSide })];
    // The face of a half-space hides nothing from behind; the inside of other solids looks full where they are cut.
    if (wall.plane) this.materials.length = 1;
    const shape = is_flat ? geometry : toCreasedNormals(geometry, CREASE);
    for (const material of this.materials) this.object.add(new Mesh(shape, material));
    for (const mesh of this.object.children) mesh.frustumCulled = false;
    if (wall.plane && wall.holds && !is_flat) this.contact = new Contact(wall.plane, uniforms, edge);
  }

  show(frame, cut) {
    this.shift = new Vector3(...(this.wall.shift?.[frame] ?? [0, 0, 0]));
    this.object.position.copy(this.shift);
    for (const material of this.materials) material.clippingPlanes = cut ? [cut.plane] : [];
  }
}

export class Walls {
  constructor(run, uniforms, edge) {
    this.walls = run.walls.map((wall) => new Wall(wall, uniforms, edge, run.dimension === 2));
    this.solids = new Group();
    this.contacts = new Group();
    for (const { object, contact } of this.walls) {
      this.solids.add(object);
      if (contact) this.contacts.add(contact.object);
    }
  }

  /** `points`: the particles where the bodies are shown by open surfaces, else null. */
  show(frame, cut, points, field, cell, box) {
    this.contacts.visible = Boolean(points);
    for (const wall of this.walls) {
      wall.show(frame, cut);
      if (points) wall.contact?.show(points, field, cut, cell, box, wall.shift);
    }
  }
}
