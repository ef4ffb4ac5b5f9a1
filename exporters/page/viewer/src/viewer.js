// The scene and the parts of the page around it. A picture is drawn only when something has changed.
import * as THREE from "three";
import { Colours } from "./colours.js";
import { byId, say } from "./dom.js";
import { idOfHit } from "./features.js";
import { FeaturePanel } from "./feature_panel.js";
import { Findings } from "./findings.js";
import { Frame } from "./frame.js";
import { Lamps } from "./lamps.js";
import { Layers, hiddenBy } from "./layers.js";
import { readLink, writeLink } from "./link.js";
import { Measure } from "./measure.js";
import { Moves } from "./moves.js";
import { Outline } from "./outline.js";
import { savePicture } from "./picture.js";
import { Rays } from "./rays.js";
import { Records } from "./records.js";
import { Search } from "./search.js";
import { Sky } from "./sky.js";
import { Tileset } from "./tileset.js";

const FAR_M = 60000;
/** A press is a click if the pointer moves less than this. */
const CLICK_PX = 4;

export class Viewer {
  constructor(page, tileset, findings) {
    this.page = page;
    this.canvas = byId("scene");
    this.isChanged = true;
    this.stillFrames = 0;
    this.seenFrom = new THREE.Matrix4();
    const changed = (this.changed = () => (this.isChanged = true));
    this.scene = new THREE.Scene();
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.camera = new THREE.PerspectiveCamera(50, 1, 1, FAR_M);
    this.camera.up.set(0, 0, 1);
    const watch = { tileLoaded: (tile) => this.takeTile(tile), tileGone: (tile) => this.lamps.forget(tile), changed: () => this.tilesChanged(), failed: (url) => say(`${url} cannot be loaded.`) };
    this.tileset = new Tileset("3dtiles/tileset.json", tileset.root.transform, this.camera, this.renderer, watch);
    this.scene.add(this.tileset.tiles.group);
    this.frame = new Frame(tileset.root.transform);
    this.rays = new Rays(this.tileset, this.camera);
    this.moves = new Moves(this.canvas, this.camera, this.rays, changed);
    this.layers = new Layers(this.tileset, changed);
    this.colours = new Colours(this.tileset, page, changed);
    this.sky = new Sky(this.scene, this.renderer, page, () => this.skyChanged());
    this.lamps = new Lamps(this.scene, this.tileset.tiles.group);
    this.outline = new Outline(this.scene);
    this.records = new Records(page.feature_files);
    this.measure = new Measure(this.scene, changed);
    this.findings = new Findings(this.scene, page, findings, this.frame, this.rays, (finding) => this.flyTo(finding), changed);
    this.panel = new FeaturePanel(page, this.records, this.findings, () => this.pick(null));
    this.search = new Search(this.records, { toPlace: (lon, lat) => this.goToPlace(lon, lat), toFeature: (id, record) => this.goToFeature(id, record) });
    this.listen();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => (this.pressed = [event.clientX, event.clientY]));
    canvas.addEventListener("pointerup", (event) => event.button === 0 && this.click(event));
    canvas.addEventListener("keydown", (event) => this.press(event));
    byId("fly").addEventListener("click", () => this.setMode("fly"));
    byId("walk").addEventListener("click", () => this.setMode("walk"));
    byId("home").addEventListener("click", () => this.goHome());
    byId("picture").addEventListener("click", () => savePicture(canvas, () => this.draw(), this.page.title.replace(/[^\w-]+/g, "_")));
    byId("link").addEventListener("click", () => this.copyLink());
    byId("fold").addEventListener("click", () => this.fold());
    window.addEventListener("resize", this.changed);
    window.addEventListener("hashchange", () => this.openLink());
  }

  start() {
    this.sky.set(Math.max(0, this.page.skies.findIndex((sky) => sky.is_of_run)));
    this.goHome();
    this.moves.follow(Infinity);
    this.openLink();
    this.last_ms = performance.now();
    this.renderer.setAnimationLoop((now_ms) => this.frameAt(now_ms));
    say("Ready");
  }

  frameAt(now_ms) {
    this.moves.update(Math.min(0.2, (now_ms - this.last_ms) / 1000));
    this.last_ms = now_ms;
    this.resize();
    this.setNear();
    this.camera.updateMatrixWorld();
    this.tileset.update(this.camera);
    this.lamps.update(this.camera.position, this.tileset.shown, this.sky.exposure, this.areLit);
    const isBusy = this.isChanged || this.moves.isMoving || !this.tileset.isWhole || !this.camera.matrixWorld.equals(this.seenFrom);
    this.stillFrames = isBusy ? 0 : this.stillFrames + 1;
    this.seenFrom.copy(this.camera.matrixWorld);
    if (isBusy) this.draw();
  }

  /** True if all that the camera sees is loaded and drawn. */
  get isStill() {
    return !this.isChanged && this.stillFrames > 3;
  }

  get areLit() {
    return Boolean(this.page.skies[this.sky.number]?.are_lamps_lit);
  }

  draw() {
    this.isChanged = false;
    this.renderer.render(this.scene, this.camera);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const size = this.renderer.getSize(new THREE.Vector2());
    const ratio = this.tileset.isCoarse ? 0.5 : Math.min(2, window.devicePixelRatio);
    if (size.x === width && size.y === height && this.renderer.getPixelRatio() === ratio) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  setNear() {
    const near_m = Math.min(20, Math.max(0.3, this.moves.above_m * 0.05));
    if (Math.abs(near_m - this.camera.near) < 0.1 * near_m) return;
    this.camera.near = near_m;
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  takeTile(tile) {
    this.lamps.take(tile);
    this.layers.apply(tile);
    this.sky.apply(tile);
    this.colours.apply(tile);
  }

  tilesChanged() {
    if (!this.outline) return;
    if (this.outline.id) this.outline.show(this.outline.id, this.tileset.shown).then(this.changed);
    this.lamps.last.x = Infinity;
    this.changed();
  }

  skyChanged() {
    for (const tile of this.tileset.loaded.values()) this.sky.apply(tile);
    this.changed();
  }

  click(event) {
    if (Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) > CLICK_PX) return;
    const box = this.canvas.getBoundingClientRect();
    this.use(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  }

  press(event) {
    if (event.code === "Enter") this.use(0, 0);
    if (event.code === "Escape") this.measure.isOn ? this.measure.turn(false) : byId("feature").hidden || this.panel.close();
  }

  /** Picks, or measures, at a point of the picture. */
  async use(x, y) {
    const hit = this.rays.at(x, y);
    if (this.measure.isOn) return hit ? this.measure.add(hit.point) : say("There is only sky.");
    const id = hit ? await idOfHit(hit) : null;
    if (!id) say(hit ? "This belongs to no element of the map, or is too far away." : "There is only sky.");
    await this.pick(id);
  }

  /** Picks a feature by its id; null picks none. */
  async pick(id) {
    const drawn = this.outline.show(id, this.tileset.shown);
    if (id) await this.panel.show(id);
    else byId("feature").hidden = true;
    await drawn;
    this.changed();
  }

  setMode(mode) {
    byId("fly").setAttribute("aria-pressed", String(mode === "fly"));
    byId("walk").setAttribute("aria-pressed", String(mode === "walk"));
    this.moves.setMode(mode);
  }

  goHome() {
    const [west, south, east, north] = this.page.region_m;
    const middle = new THREE.Vector3((west + east) / 2, (south + north) / 2, this.page.ground_m);
    this.setMode("fly");
    this.moves.goTo(middle, 0.9 * Math.hypot(east - west, north - south), -0.6);
  }

  goToPlace(lon_deg, lat_deg) {
    const at = this.frame.at(lon_deg, lat_deg, this.page.ground_m);
    at.z = this.rays.groundAt(at.x, at.y) ?? at.z;
    this.setMode("fly");
    this.moves.goTo(at, 120);
    say(`At ${lat_deg}, ${lon_deg}`);
  }

  goToFeature(id, record) {
    this.setMode("fly");
    this.moves.goTo(new THREE.Vector3(...record.at), Math.max(40, 2 * (record.size_m ?? 30)));
    return this.pick(id);
  }

  flyTo(finding) {
    this.setMode("fly");
    this.moves.goTo(this.findings.place(finding), 60);
    this.findings.settle(finding);
    this.findings.tell(finding);
    const { id } = finding.properties;
    if (id) this.pick(id).then(() => this.findings.tell(finding));
  }

  get link() {
    const { position } = this.camera, { heading, pitch, mode } = this.moves;
    return writeLink({ position, heading, pitch, mode, hidden: this.layers.hidden, colours: this.colours.mode, time: this.sky.number, detail_px: this.tileset.tiles.errorTarget, id: this.panel.id });
  }

  async copyLink() {
    history.replaceState(null, "", `#${this.link}`);
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    byId("linked").textContent = "The address of this page now leads to this view.";
  }

  openLink() {
    for (const name of hiddenBy(new URLSearchParams(location.search).get("layers") ?? "")) this.layers.set(name, false);
    const state = readLink(location.hash.slice(1));
    this.tileset.setDetail(state.detail_px);
    if (!state.position) return;
    this.moves.travel = null;
    this.camera.position.fromArray(state.position);
    this.moves.look(state.heading, state.pitch);
    byId(state.mode).setAttribute("aria-pressed", "true");
    byId(state.mode === "fly" ? "walk" : "fly").setAttribute("aria-pressed", "false");
    this.moves.mode = state.mode;
    for (const name of state.hidden) if (byId(`layer-${name}`)) this.layers.set(name, false);
    if (["none", "level", "error", "source"].includes(state.colours)) this.colours.set(state.colours);
    if (state.time !== undefined) this.sky.set(state.time);
    if (state.id) this.pick(state.id);
  }

  fold() {
    const isOpen = byId("sections").hidden;
    byId("sections").hidden = !isOpen;
    byId("fold").textContent = isOpen ? "Hide" : "Show";
    byId("fold").setAttribute("aria-expanded", String(isOpen));
  }
}
