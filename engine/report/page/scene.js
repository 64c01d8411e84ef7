// The 3D view: what is shown, from where, in which light.
import {
  AmbientLight, DirectionalLight, OrthographicCamera, PerspectiveCamera, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Particles, Surface, colour_uniforms } from "./body.js";
import { colour_texture } from "./colours.js";
import { Cut, visible_particles } from "./cut.js";
import { Face, Filling, edge_of } from "./section.js";
import { Sharpness } from "./sharpness.js";
import { Walls } from "./walls.js";

const AXES = "xyz";
const RADIANS = Math.PI / 180;
const REST = 200; // [ms] without a turn until the picture is a full one again

export class View {
  constructor(canvas, run) {
    this.run = run;
    this.is_flat = run.dimension === 2;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, stencil: true, alpha: true });
    this.renderer.localClippingEnabled = true;
    this.canvas = canvas;
    this.sharpness = new Sharpness(this.renderer.getContext());
    this.scene = new Scene();
    this.uniforms = colour_uniforms();
    this.spacing = run.spacing / run.box.size;
    this.box = { low: run.box.low, sides: run.box.sides }; // in units of the longest side
    this.make_bodies();
    this.camera = this.is_flat ? new OrthographicCamera() : new PerspectiveCamera(24, 1, 0.01, 50);
    this.light();
    this.look_from({});
  }

  make_bodies() {
    const { sets, method } = this.run;
    const edge = edge_of(method);
    const find = (kind) => sets.findIndex((set) => set.kind === kind);
    this.surface_at = find("surface");
    this.particles_at = find("particles");
    const corners = this.surface_at >= 0 ? sets[this.surface_at].corners : 0;
    if (corners) {
      this.surface = new Surface(corners, this.uniforms);
      this.scene.add(this.surface.object);
    }
    if (corners === 3) {
      this.face = new Face(this.surface, this.uniforms, edge);
      this.scene.add(this.face.object);
    }
    this.walls = new Walls(this.run);
    this.scene.add(this.walls.object);
    if (this.is_flat) {
      this.filling = new Filling(this.uniforms, edge);
      this.scene.add(this.filling.object);
    }
    const diameter = this.spacing * (this.is_flat ? 1.45 : 1.3);
    this.particles = new Particles(this.uniforms, diameter, this.is_flat);
    this.scene.add(this.particles.object);
  }

  light() {
    const key = new DirectionalLight(0xffffff, 1.9), fill = new DirectionalLight(0xffffff, 0.5);
    key.position.set(-0.5, 0.8, 1);
    fill.position.set(0.9, -0.3, 0.5);
    this.camera.add(key, key.target, fill, fill.target);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.35));
  }

  get middle() {
    const { low, sides } = this.box;
    return new Vector3(...low.map((value, a) => value + sides[a] / 2));
  }

  /** The camera: azimuth about the upward axis and elevation above the plane across it, in degrees. */
  look_from({ azimuth = -60, elevation = 25, zoom = 1, up = this.up ?? "z" }) {
    this.up = up;
    const middle = this.middle;
    const distance = 0.56 * new Vector3(...this.box.sides).length() / Math.tan(12 * RADIANS);
    const direction = new Vector3(0, 0, 1);
    if (!this.is_flat) {
      const axis = AXES.indexOf(up);
      const flat = Math.cos(elevation * RADIANS);
      direction.setComponent((axis + 1) % 3, flat * Math.cos(azimuth * RADIANS));
      direction.setComponent((axis + 2) % 3, flat * Math.sin(azimuth * RADIANS));
      direction.setComponent(axis, Math.sin(elevation * RADIANS));
      this.camera.up.set(0, 0, 0).setComponent(axis, 1);
    }
    this.camera.position.copy(middle).addScaledVector(direction, distance);
    this.camera.zoom = zoom;
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.copy(middle);
    this.controls.enableRotate = !this.is_flat;
    this.controls.screenSpacePanning = true;
    if (this.is_flat) this.controls.mouseButtons.LEFT = this.controls.mouseButtons.RIGHT;
    this.controls.update();
    this.controls.addEventListener("change", () => this.turned());
    this.resize();
  }

  /** Turns the camera by angles in degrees, or moves it in a plane view. */
  turn(right, upwards) {
    const { camera, controls } = this;
    if (this.is_flat) {
      const shift = new Vector3(right, upwards, 0).multiplyScalar(-0.002 / camera.zoom);
      camera.position.add(shift);
      controls.target.add(shift);
    } else {
      const away = camera.position.clone().sub(controls.target);
      const side = new Vector3().crossVectors(camera.up, away).normalize();
      const lifted = away.clone().applyAxisAngle(side, -upwards * RADIANS);
      if (lifted.angleTo(camera.up) > 0.05 && lifted.angleTo(camera.up) < Math.PI - 0.05) away.copy(lifted);
      camera.position.copy(controls.target).add(away.applyAxisAngle(camera.up, right * RADIANS));
    }
    controls.update();
  }

  zoom_by(factor) {
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.turned();
  }

  /** Pictures are those of a body that turns until it has rested for a while. */
  turned() {
    this.sharpness.is_turning = true;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => {
      this.sharpness.is_turning = false;
      this.request();
    }, REST);
    this.request();
  }

  resize(width = this.canvas.clientWidth, height = this.canvas.clientHeight, ratio = Math.min(devicePixelRatio, 2)) {
    if (width === 0 || height === 0) return;
    this.ratio = ratio;
    this.size = { width, height };
    this.share = null; // the next picture makes the canvas as large as it needs
    const aspect = width / height;
    if (this.is_flat) {
      const [w, h] = this.box.sides;
      const half = 0.54 * Math.max(h, w / aspect) + this.spacing;
      Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half, near: 0, far: 20 });
    } else {
      this.camera.aspect = aspect;
      this.camera.fov = aspect > 1.1 ? 24 : 24 * Math.min(2.2, 1.1 / aspect);
    }
    this.camera.updateProjectionMatrix();
    this.request();
  }

  /** Draws with a share of the pixels along each side from now on. */
  sharpen(share) {
    this.share = share;
    const ratio = this.ratio * share;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.size.width, this.size.height, false);
    this.particles.material.uniforms.pixels.value = (this.size.height * ratio) / 2;
  }

  /** Colours from `low` to `high` of the field, whose stored numbers go from its lo to its hi. */
  colour(field, low, high) {
    const { lo, hi } = this.run.fields[field];
    const share = (value) => (hi > lo ? (value - lo) / (hi - lo) : 0.5);
    this.uniforms.colours.value?.dispose();
    this.uniforms.colours.value = colour_texture(low, high);
    this.uniforms.low.value = share(low);
    this.uniforms.high.value = share(high);
    this.request();
  }

  /** `choice`: { frame, field, cut: { axis: "x", place: 0 ... 1, flip } or null, particles, walls }. */
  show(sets, choice) {
    const cut = choice.cut && this.cut_of(choice.cut);
    const is_solid = this.surface?.is_solid && !choice.particles;
    const particles = sets[this.particles_at];
    if (this.surface) {
      this.surface.object.visible = is_solid || !this.surface.is_solid;
      this.surface.show(sets[this.surface_at], choice.field);
      this.surface.material.clippingPlanes = cut ? [cut.plane] : [];
    }
    this.face?.show(is_solid ? particles : null, choice.field, cut, this.spacing, this.box);
    this.walls.object.visible = Boolean(choice.walls);
    this.walls.show(choice.frame, cut);
    const is_filled = this.is_flat && !choice.particles;
    if (this.filling) this.filling.object.visible = is_filled;
    if (is_filled) {
      this.filling.show(particles, choice.field, this.spacing, this.box, this.surface);
    }
    this.particles.object.visible = Boolean(particles) && !is_solid && !is_filled;
    if (this.particles.object.visible) {
      const chosen = this.is_flat ? null : visible_particles(particles, 1.26 * this.spacing, cut);
      this.particles.show(particles, choice.field, chosen);
    }
    this.request();
  }

  cut_of({ axis, place, flip }) {
    const number = AXES.indexOf(axis);
    return new Cut(number, this.box.low[number] + place * this.box.sides[number], flip);
  }

  /** Draws before the next picture of the screen. */
  request() {
    this.pending ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    if (this.pending) cancelAnimationFrame(this.pending);
    this.pending = null;
    const { share, bits } = this.sharpness.level;
    if (this.share !== share) this.sharpen(share);
    this.surface?.simplify(bits);
    this.sharpness.around(() => this.renderer.render(this.scene, this.camera));
  }
}
