// Fingers on the scene: one turns the view, two slide it, a pinch moves along it. Buttons on the scene move while they are held.
import { byId } from "./dom.js";

/** The buttons of the pad, and the way that each moves. */
const PAD = { "pad-ahead": ["ahead", 1], "pad-back": ["ahead", -1], "pad-left": ["aside", -1], "pad-right": ["aside", 1] };
/** The seconds that a press by the keyboard or by a screen reader moves. */
const PRESS_S = 0.5;

const middleOf = ([a, b]) => [(a.x + b.x) / 2, (a.y + b.y) / 2];
const spanOf = ([a, b]) => Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));

export class Touch {
  constructor(canvas, moves) {
    this.canvas = canvas;
    this.moves = moves;
    this.fingers = new Map();
    /** True from the second finger of a gesture until the last one is lifted, so that a pinch picks nothing. */
    this.wasMany = false;
    canvas.addEventListener("pointerdown", (event) => event.pointerType === "touch" && this.begin(event));
    canvas.addEventListener("pointermove", (event) => this.fingers.has(event.pointerId) && this.drag(event));
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => this.end(event));
    for (const [id, way] of Object.entries(PAD)) this.listen(id, way);
  }

  begin(event) {
    this.apply();
    if (this.fingers.size === 0) this.wasMany = false;
    const at = { x: event.clientX, y: event.clientY };
    this.fingers.set(event.pointerId, { ...at, from: at });
    if (this.fingers.size > 1) this.wasMany = true;
  }

  end(event) {
    this.apply();
    this.fingers.delete(event.pointerId);
  }

  // fingers report one after the other; what they do together is seen in the next picture
  drag(event) {
    Object.assign(this.fingers.get(event.pointerId), { x: event.clientX, y: event.clientY });
    this.frame ||= requestAnimationFrame(() => this.apply());
  }

  /** Moves the view by what the fingers have moved since the last time. */
  apply() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const now = [...this.fingers.values()], before = now.map(({ from }) => from), radians = this.moves.radiansPerPixel;
    if (now.every(({ x, y, from }) => x === from.x && y === from.y)) return;
    for (const finger of now) finger.from = { x: finger.x, y: finger.y };
    this.moves.interrupt();
    if (now.length === 1) this.moves.turn(-(now[0].x - before[0].x) * radians, (now[0].y - before[0].y) * radians);
    if (now.length === 2) this.slide(before, now, radians);
  }

  // the ground under two fingers stays under them
  slide(before, now, radians) {
    const far_m = Math.max(this.moves.above_m, 5), [from, to] = [middleOf(before), middleOf(now)];
    const ahead = far_m * Math.log(spanOf(now) / spanOf(before));
    this.moves.step({ ahead, aside: -(to[0] - from[0]) * radians * far_m, up: (to[1] - from[1]) * radians * far_m });
  }

  listen(id, way) {
    const button = byId(id);
    button.addEventListener("pointerdown", (event) => (button.setPointerCapture(event.pointerId), this.moves.hold(id, way)));
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(name, () => this.moves.release(id));
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    // a click without a pointer
    button.addEventListener("click", (event) => event.detail === 0 && (this.moves.hold(id, way), setTimeout(() => this.moves.release(id), 1000 * PRESS_S)));
  }
}
