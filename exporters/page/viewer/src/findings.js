// The findings of the run: a list, marks in the scene, and the way to each of them. None is shown at first.
import { BufferGeometry, Float32BufferAttribute, Points, PointsMaterial, Color } from "three";
import { byId, make, say } from "./dom.js";
import { fetchJson } from "./records.js";
import { capital, elementOf, wordsOf } from "./words.js";

const STEP = 100;
/** Dropped, mended and notes, the worst first: vermillion, orange and sky blue of Okabe and Ito. */
const COLOURS = { dropped: "#d55e00", mended: "#e69f00", note: "#56b4e9" };

export class Findings {
  /** @param {object} parts {page, frame, rays, limits}. @param {Function} fly Called with a finding to fly to. */
  constructor(scene, parts, fly, changed) {
    Object.assign(this, parts, { fly, changed, all: [], some: [], placed: [], count: STEP, code: "none" });
    this.marks = new Points(new BufferGeometry(), new PointsMaterial({ size: 9, sizeAttenuation: false, vertexColors: true, depthTest: false, toneMapped: false }));
    this.marks.frustumCulled = false;
    this.marks.renderOrder = 10;
    scene.add(this.marks);
    byId("finding-code").append(make("option", { value: "none" }, "none"));
    byId("finding-code").addEventListener("change", (event) => this.filter(event.target.value));
    byId("more-findings").addEventListener("click", () => this.showMore());
  }

  /** Loads the findings of the run once, after its tiles or when they are asked for. */
  load() {
    this.loading ??= fetchJson("findings.json").then((collection) => this.take(collection));
    return this.loading;
  }

  take(collection) {
    const worst = (finding) => Object.keys(COLOURS).indexOf(finding.properties.severity);
    this.all = collection.features.toSorted((a, b) => worst(a) - worst(b));
    const counts = new Map();
    for (const { properties } of this.all) counts.set(properties.code, (counts.get(properties.code) ?? 0) + 1);
    const rows = [...counts].sort((a, b) => b[1] - a[1]).map(([code, count]) => make("option", { value: code }, `${capital(wordsOf(code))} (${count})`));
    byId("finding-code").append(make("option", { value: "" }, `all ${this.all.length}`), ...rows);
  }

  filter(code) {
    this.code = code;
    this.count = STEP;
    byId("finding-code").value = code;
    this.some = code === "none" ? [] : this.all.filter(({ properties }) => code === "" || properties.code === code);
    this.showList();
    this.showMarks();
  }

  showMore() {
    const first = this.count;
    this.count += STEP;
    this.showList();
    byId("findings").children[first]?.querySelector("button").focus();
  }

  showList() {
    byId("findings").replaceChildren(...this.some.slice(0, this.count).map((finding) => make("li", {}, this.button(finding))));
    byId("more-findings").hidden = this.count >= this.some.length;
  }

  button(finding) {
    const { code, id, severity } = finding.properties;
    const about = id ? `, ${elementOf(id)}` : "";
    const button = make("button", { type: "button", title: this.describe(finding) }, `${capital(wordsOf(code))}${about} (${severity})`);
    button.addEventListener("click", () => this.open(finding));
    return button;
  }

  open(finding) {
    if (this.isOnMap(finding)) return this.fly(finding);
    say(`${this.describe(finding)}. ${finding.geometry ? "It is outside of the map." : "It has no place on the map."}`);
  }

  /** True if a finding has a place inside of the map. */
  isOnMap({ geometry }) {
    if (!geometry) return false;
    const { x, y } = this.frame.at(...geometry.coordinates), { west, south, east, north } = this.limits;
    return x >= west && x <= east && y >= south && y <= north;
  }

  /** Returns the place of a finding in the scene, on the ground where it is loaded. */
  place(finding) {
    const [lon_deg, lat_deg] = finding.geometry.coordinates;
    const at = this.frame.at(lon_deg, lat_deg, this.page.ground_m);
    at.z = this.rays.groundAt(at.x, at.y) ?? at.z;
    return at;
  }

  // marks stand at the mean height of the ground until the ground below is loaded
  showMarks() {
    const placed = this.some.filter((finding) => this.isOnMap(finding));
    const places = placed.flatMap((finding) => this.frame.at(...finding.geometry.coordinates, this.page.ground_m).toArray());
    const colours = placed.flatMap(({ properties }) => new Color(COLOURS[properties.severity] ?? "white").toArray());
    this.marks.geometry.dispose();
    this.marks.geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(places, 3)).setAttribute("color", new Float32BufferAttribute(colours, 3));
    this.placed = placed;
    this.changed();
  }

  /** Sets a mark on the ground. */
  settle(finding) {
    const i = this.placed.indexOf(finding);
    if (i < 0) return;
    const { position } = this.marks.geometry.attributes;
    position.setXYZ(i, ...this.place(finding).toArray());
    position.needsUpdate = true;
    this.changed();
  }

  about(id) {
    return this.all.filter(({ properties }) => properties.id === id || properties.other === id);
  }

  /** Returns one sentence about a finding. */
  describe({ properties }) {
    const about = properties.other ? `${elementOf(properties.id)} and ${elementOf(properties.other)}: ` : "";
    const tags = properties.tags ? ` (${properties.tags.replace(/\b[nwr]\d+(?=:)/g, elementOf)})` : "";
    const size = properties.size ? `, ${properties.size}` : "";
    return `${about}${this.page.codes[properties.code] ?? wordsOf(properties.code)}${tags}${size}`;
  }

  tell(finding) {
    say(this.describe(finding));
  }
}
