// Moves the camera: flying, or walking with the eyes 1.7 m above the floor. Heading 0 looks north and grows clockwise; pitch is up.
import { Vector3 } from "three";

export const EYE_M = 1.7;
/** The camera stays within this many lengths of the map's diagonal around it, and below as many. */
const MOST_AWAY = 1.5;
const WALK_M_S = 1.5, RUN = 4, TURN_S = 1.2;
/** Flying is faster the higher the camera is. */
const FLY_PER_M_S = 0.8, LEAST_FLY_M_S = 6, MOST_FLY_M_S = 3000;
const MOST_PITCH = 1.55;
const TRAVEL_S = 1.2;

const KEYS = {
  KeyW: ["ahead", 1], ArrowUp: ["ahead", 1], KeyS: ["ahead", -1], ArrowDown: ["ahead", -1],
  KeyD: ["aside", 1], ArrowRight: ["aside", 1], KeyA: ["aside", -1], ArrowLeft: ["aside", -1],
  KeyE: ["up", 1], KeyQ: ["up", -1],
  KeyL: ["turn", 1], KeyJ: ["turn", -1], KeyI: ["tilt", 1], KeyK: ["tilt", -1],
};

const ease = (t) => t * t * (3 - 2 * t);

export class Moves {
  /** @param {object} limits The box that walkers stay in and flyers stay near: {west, south, east, north, ground_m}. */
  constructor(canvas, camera, rays, limits, changed) {
    this.canvas = canvas;
    this.limits = limits;
    this.camera = camera;
    this.rays = rays;
    this.changed = changed;
    this.heading = this.pitch = 0;
    this.mode = "fly";
    this.held = new Map();
    this.isFast = false;
    this.above_m = 100;
    this.travel = null;
    /** Called when the reader moves: what was to happen on the way no longer does. */
    this.interrupted = () => {};
    this.listen();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener("keydown", (event) => this.press(event));
    canvas.addEventListener("keyup", (event) => (this.held.delete(event.code), (this.isFast = event.shiftKey)));
    canvas.addEventListener("blur", () => this.held.clear());
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => event.buttons && event.pointerType !== "touch" && this.drag(event));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    this.isFast = event.shiftKey;
    const key = KEYS[event.code];
    if (!key) return;
    event.preventDefault();
    this.hold(event.code, key);
  }

  /** Moves one way until release(name). */
  hold(name, way) {
    this.interrupt();
    this.held.set(name, way);
    this.changed();
  }

  release(name) {
    this.held.delete(name);
  }

  interrupt() {
    this.travel = null;
    this.interrupted();
  }

  /** The angle of a pixel in the middle of the picture. */
  get radiansPerPixel() {
    return (this.camera.fov * Math.PI) / 180 / this.canvas.clientHeight;
  }

  drag(event) {
    this.interrupt();
    const radians = this.radiansPerPixel;
    if (event.buttons & 1) {
      this.turn(-event.movementX * radians, event.movementY * radians);
    } else {
      const step_m = Math.max(this.above_m, 5) * radians;
      this.step({ aside: -event.movementX * step_m, up: event.movementY * step_m, ahead: 0 });
    }
  }

  wheel(event) {
    event.preventDefault();
    this.interrupt();
    this.step({ ahead: -Math.sign(event.deltaY) * Math.max(this.above_m * 0.15, 1), aside: 0, up: 0 });
  }

  turn(heading, pitch) {
    this.look(this.heading + heading, this.pitch + pitch);
  }

  /** Sets where the camera looks. */
  look(heading, pitch) {
    this.heading = heading;
    this.pitch = Math.min(MOST_PITCH, Math.max(-MOST_PITCH, pitch));
    this.camera.lookAt(this.camera.position.clone().add(this.direction()));
    this.changed();
  }

  direction() {
    const { heading: h, pitch: p } = this;
    return new Vector3(Math.sin(h) * Math.cos(p), Math.cos(h) * Math.cos(p), Math.sin(p));
  }

  /** Moves by metres along the view, to its right and up. On foot, along the floor and as far as walls allow. */
  step({ ahead, aside, up }) {
    const { heading, camera } = this, isWalk = this.mode === "walk";
    const along = isWalk ? new Vector3(Math.sin(heading), Math.cos(heading), 0) : this.direction();
    const step = along.multiplyScalar(ahead).addScaledVector(new Vector3(Math.cos(heading), -Math.sin(heading), 0), aside);
    camera.position.add(isWalk ? this.allowed(step) : step.setZ(step.z + up));
    this.stayNear();
    this.stand();
    this.changed();
  }

  /** Returns the part of a walker's step that walls allow: all of it, its part along a wall, or nothing in a corner. */
  allowed(step) {
    const { x, y, z } = this.camera.position, feet = new Vector3(x, y, z - EYE_M), wall = this.rays.wallAt(feet, step);
    if (!wall) return step;
    const along = step.addScaledVector(wall, -step.dot(wall));
    return this.rays.wallAt(feet, along) ? new Vector3() : along;
  }

  /** Keeps walkers on the map, and flyers near it. */
  stayNear() {
    const { west, south, east, north, ground_m } = this.limits, { position } = this.camera;
    const away_m = this.mode === "walk" ? -1 : MOST_AWAY * Math.hypot(east - west, north - south);
    position.x = Math.min(east + away_m, Math.max(west - away_m, position.x));
    position.y = Math.min(north + away_m, Math.max(south - away_m, position.y));
    if (this.mode === "fly") position.z = Math.min(position.z, ground_m + 2 * away_m + 500);
  }

  /** Keeps a walker on the floor, and a flyer above it. */
  stand() {
    const { position } = this.camera;
    const floor = this.rays.floorBelow(position);
    // nothing is loaded there, or there is nothing
    this.above_m = Math.max(position.z - (floor ?? this.limits.ground_m), 0.5);
    if (floor === undefined) return;
    if (this.mode === "walk") position.z = floor + EYE_M;
    else if (this.above_m < EYE_M) position.z = Math.max(position.z, floor + 0.5);
    this.above_m = Math.max(position.z - floor, 0.5);
  }

  /** "fly" or "walk". */
  setMode(mode) {
    this.mode = mode;
    if (mode === "fly") this.stand();
    this.changed();
  }

  /** Puts a walker's feet on a place. */
  walkAt(at, heading) {
    this.travel = null;
    this.mode = "walk";
    this.camera.position.set(at.x, at.y, at.z + EYE_M);
    this.stand();
    this.look(heading, 0);
  }

  /** Flies to a place and looks there from a distance. */
  goTo(target, distance_m, pitch = -0.5) {
    const back = new Vector3(Math.sin(this.heading) * Math.cos(pitch), Math.cos(this.heading) * Math.cos(pitch), Math.sin(pitch));
    const to = target.clone().addScaledVector(back, -distance_m);
    this.travel = { from: this.camera.position.clone(), to, pitch: [this.pitch, pitch], passed_s: 0 };
    this.changed();
  }

  get isMoving() {
    return this.travel !== null || this.held.size > 0;
  }

  update(seconds) {
    if (this.travel) this.follow(seconds);
    if (this.held.size === 0) return;
    const sum = { ahead: 0, aside: 0, up: 0, turn: 0, tilt: 0 };
    for (const [way, sign] of this.held.values()) sum[way] += sign;
    if (sum.turn || sum.tilt) this.turn(sum.turn * TURN_S * seconds, sum.tilt * TURN_S * seconds);
    const step_m = this.speed() * seconds;
    if (sum.ahead || sum.aside || sum.up) this.step({ ahead: sum.ahead * step_m, aside: sum.aside * step_m, up: sum.up * step_m });
  }

  speed() {
    const walk = this.mode === "walk";
    const usual = walk ? WALK_M_S : Math.min(MOST_FLY_M_S, Math.max(LEAST_FLY_M_S, this.above_m * FLY_PER_M_S));
    return this.isFast ? usual * RUN : usual;
  }

  follow(seconds) {
    const { travel } = this;
    travel.passed_s += seconds;
    const t = ease(Math.min(1, travel.passed_s / TRAVEL_S));
    this.camera.position.lerpVectors(travel.from, travel.to, t);
    this.above_m = Math.max(this.camera.position.z - this.limits.ground_m, EYE_M);
    this.look(this.heading, travel.pitch[0] + (travel.pitch[1] - travel.pitch[0]) * t);
    if (t < 1) return;
    this.travel = null;
    this.stand();
    this.changed();
  }
}
