// Measures between two points of the scene: the distance, the distance on the map, and the height.
import { BufferGeometry, Line, LineBasicMaterial, Points, PointsMaterial } from "three";
import { byId, say } from "./dom.js";

const metres = (value) => `${value.toFixed(value < 100 ? 2 : 1)} m`;

export class Measure {
  constructor(scene, changed) {
    this.isOn = false;
    this.points = [];
    this.changed = changed;
    this.line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: "#ffbf00", depthTest: false, toneMapped: false }));
    this.ends = new Points(this.line.geometry, new PointsMaterial({ color: "#ffbf00", size: 9, sizeAttenuation: false, depthTest: false, toneMapped: false }));
    for (const object of [this.line, this.ends]) Object.assign(object, { frustumCulled: false, renderOrder: 11, visible: false });
    scene.add(this.line, this.ends);
    byId("measure").addEventListener("click", () => this.turn(!this.isOn));
  }

  turn(isOn) {
    this.isOn = isOn;
    byId("measure").setAttribute("aria-pressed", String(isOn));
    byId("scene").classList.toggle("measures", isOn);
    this.points = [];
    this.draw();
    byId("measured").textContent = "";
    if (isOn) say("Tap or click two points, or put the cross on them and press Enter.");
  }

  add(point) {
    if (this.points.length === 2) this.points = [];
    this.points.push(point.clone());
    this.draw();
    byId("measured").textContent = this.text();
    say(this.text());
  }

  text() {
    if (this.points.length < 2) return "First point is set.";
    const [from, to] = this.points;
    const flat_m = Math.hypot(to.x - from.x, to.y - from.y);
    return `distance ${metres(from.distanceTo(to))}, on the map ${metres(flat_m)}, height ${metres(to.z - from.z)}`;
  }

  draw() {
    this.line.geometry.dispose();
    this.line.geometry = this.ends.geometry = new BufferGeometry().setFromPoints(this.points);
    this.ends.visible = this.points.length > 0;
    this.line.visible = this.points.length > 1;
    this.changed();
  }
}
