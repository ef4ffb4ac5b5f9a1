// The scene and the parts of the page around it. A picture is drawn only when something has changed.
import * as THREE from "three";
import { Address } from "./address.js";
import { Budget, deviceOf } from "./budget.js";
import { Colours } from "./colours.js";
import { Compass } from "./compass.js";
import { byId, say } from "./dom.js";
import { idOfHit } from "./features.js";
import { FeaturePanel } from "./feature_panel.js";
import { Findings } from "./findings.js";
import { Frame } from "./frame.js";
import { listenForHelp } from "./help.js";
import { Lamps } from "./lamps.js";
import { Layers, hiddenBy } from "./layers.js";
import { readLink, writeLink } from "./link.js";
import { Measure } from "./measure.js";
import { Moves } from "./moves.js";
import { Names } from "./names.js";
import { Outline } from "./outline.js";
import { savePicture } from "./picture.js";
import { makePlate } from "./plate.js";
import { Rays } from "./rays.js";
import { Records } from "./records.js";
import { Search } from "./search.js";
import { Shadows } from "./shadows.js";
import { Sky } from "./sky.js";
import { prepare, setVisibility, uniforms } from "./surfaces.js";
import { Tileset } from "./tileset.js";
import { Touch } from "./touch.js";
import { Walk } from "./walk.js";
import { elementOf } from "./words.js";

const FAR_M = 60000;
/** A press is a click if the pointer moves less than this; fingers tremble. */
const CLICK_PX = 4, TAP_PX = 12;
/** The near plane is this part of the camera's height, within limits. */
const NEAR = 0.03, LEAST_NEAR_M = 0.2, MOST_NEAR_M = 20;
const SHADOW_PX = { phone: 1024, computer: 2048 };
const MOST_RATIO = { phone: 1.5, computer: 2 };
const VISIBILITY_KM = 100;
/** As in style.css. */
const NARROW = "(max-width: 700px)";

/** Returns how many pixels of the scene's height are covered by sheets, which lie at the bottom of narrow screens; at most 60 %. */
function coveredPixels(height) {
  if (!window.matchMedia(NARROW).matches) return 0;
  const tops = [byId("controls"), byId("feature")].filter((element) => !element.hidden).map((element) => element.getBoundingClientRect().top);
  return Math.min(0.6 * height, Math.max(0, height - Math.min(...tops)));
}

export class Viewer {
  constructor(page, tileset, progress) {
    this.page = page;
    this.progress = progress;
    this.canvas = byId("scene");
    this.isChanged = true;
    this.stillFrames = 0;
    this.seenFrom = new THREE.Matrix4();
    this.changed = () => (this.isChanged = true);
    this.makeScene(tileset);
    this.makeParts();
    this.listen();
  }

  makeScene(tileset) {
    this.scene = new THREE.Scene();
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.camera = new THREE.PerspectiveCamera(50, 1, 1, FAR_M);
    this.camera.up.set(0, 0, 1);
    const watch = { tileLoaded: (tile) => this.takeTile(tile), tileGone: (tile) => this.lamps.forget(tile), changed: () => this.tilesChanged(), failed: (url) => say(`${url} cannot be loaded.`) };
    this.tileset = new Tileset("3dtiles/tileset.json", tileset.root.transform, this.camera, this.renderer, watch);
    this.scene.add(this.tileset.tiles.group);
    this.frame = new Frame(tileset.root.transform);
    const [west, south, east, north] = this.page.region_m;
    this.limits = { west, south, east, north, ground_m: this.page.ground_m };
    this.plate = makePlate(this.limits);
    this.scene.add(this.plate);
    setVisibility(1000 * (this.page.visibility_km ?? VISIBILITY_KM));
  }

  makeParts() {
    const { scene, page, limits, changed } = this;
    this.device = deviceOf();
    this.rays = new Rays(this.tileset, this.camera);
    this.moves = new Moves(this.canvas, this.camera, this.rays, limits, changed);
    this.touch = new Touch(this.canvas, this.moves);
    this.walk = new Walk({ tileset: this.tileset, rays: this.rays, moves: this.moves, camera: this.camera });
    this.compass = new Compass(this.moves);
    this.layers = new Layers(this.tileset, changed);
    this.colours = new Colours(this.tileset, page, changed);
    this.sky = new Sky(scene, this.renderer, page, this.progress, () => this.skyChanged());
    this.shadows = new Shadows(this.renderer, this.sky.sun, SHADOW_PX[this.device]);
    this.lamps = new Lamps(scene, this.tileset.tiles.group);
    this.budget = new Budget(this.tileset, this.renderer, this.camera);
    this.outline = new Outline(scene);
    this.records = new Records(page.feature_files);
    this.measure = new Measure(scene, changed);
    this.findings = new Findings(scene, { page, frame: this.frame, rays: this.rays, limits }, (finding) => this.flyTo(finding), changed);
    this.names = new Names(() => (this.panel.id ? this.panel.show(this.panel.id) : null, this.address.later()));
    this.panel = new FeaturePanel({ page, records: this.records, findings: this.findings, names: this.names }, () => this.pick(null));
    this.search = new Search(this.records, this.box(), { toPlace: (lon, lat) => this.goToPlace(lon, lat), toFeature: (id, record) => this.goToFeature(id, record) });
    this.address = new Address(() => this.link);
  }

  /** The map's box in degrees. */
  box() {
    const { west, south, east, north, ground_m } = this.limits;
    const places = [[west, south], [west, north], [east, south], [east, north]].map(([x, y]) => this.frame.place(new THREE.Vector3(x, y, ground_m)));
    const [lons, lats] = [places.map(({ lon_deg }) => lon_deg), places.map(({ lat_deg }) => lat_deg)];
    return { west: Math.min(...lons), south: Math.min(...lats), east: Math.max(...lons), north: Math.max(...lats) };
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
    byId("fold").addEventListener("click", () => this.fold(!byId("sections").hidden));
    window.addEventListener("resize", this.changed);
    // what stands on the scene keeps clear of the sheet
    for (const [name, element] of [["--sheet", byId("controls")], ["--footer", document.querySelector("footer")]])
      new ResizeObserver(() => document.documentElement.style.setProperty(name, `${element.offsetHeight}px`)).observe(element);
    window.addEventListener("hashchange", () => this.openLink());
    listenForHelp();
  }

  start() {
    this.sky.set(Math.max(0, this.page.skies.findIndex((sky) => sky.is_of_run)));
    if (this.device === "phone") this.fold(true);
    this.goHome();
    this.moves.follow(Infinity);
    this.budget.begin();
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
    this.tileset.update(this.camera, this.moves.above_m);
    this.progress.tiles(this.tileset.waiting);
    this.lamps.update(this.camera.position, this.tileset.shown, this.sky.exposure, this.areLit);
    const isOld = this.isChanged || this.moves.isMoving || !this.camera.matrixWorld.equals(this.seenFrom);
    this.stillFrames = isOld || !this.tileset.isWhole ? 0 : this.stillFrames + 1;
    this.seenFrom.copy(this.camera.matrixWorld);
    if (isOld) this.draw();
    if (this.stillFrames === 1) this.settle();
  }

  // all that the camera sees is loaded and drawn
  settle() {
    if (this.budget.settle() || this.correctGoal()) return this.changed();
    this.address.later();
    this.findings.load().catch((error) => say(error.message));
    if (this.walk.wanted) this.walk.settle().then(this.changed);
  }

  /** True if all that the camera sees is loaded and drawn. */
  get isStill() {
    return !this.isChanged && this.stillFrames > 3 && !this.walk.wanted;
  }

  get areLit() {
    return Boolean(this.page.skies[this.sky.number]?.are_lamps_lit);
  }

  draw() {
    this.isChanged = false;
    const { camera, sky } = this;
    uniforms.eye.value.copy(camera.position);
    sky.dome.material.uniforms.above.value = Math.max(1, camera.position.z - this.limits.ground_m);
    this.shadows.isWanted = !this.tileset.isCoarse;
    this.shadows.update(camera, this.moves, sky.toLight);
    this.budget.update();
    this.compass.update();
    this.renderer.render(this.scene, camera);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const size = this.renderer.getSize(new THREE.Vector2());
    const ratio = this.tileset.isCoarse ? 0.5 : Math.min(MOST_RATIO[this.device], window.devicePixelRatio);
    const covered_px = coveredPixels(height);
    if (size.x === width && size.y === height && this.renderer.getPixelRatio() === ratio && covered_px === this.covered_px) return;
    this.covered_px = covered_px;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // the middle of the view is the middle of what sheets leave free
    this.camera.setViewOffset(width, height, 0, covered_px / 2, width, height);
    this.rays.middle = covered_px / height;
    this.changed();
  }

  setNear() {
    const near_m = Math.min(MOST_NEAR_M, Math.max(LEAST_NEAR_M, this.moves.above_m * NEAR));
    if (Math.abs(near_m - this.camera.near) < 0.1 * near_m) return;
    this.camera.near = near_m;
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  takeTile(tile) {
    this.plate.visible = false;
    tile.meshes.forEach(prepare);
    this.lamps.take(tile);
    this.layers.apply(tile);
    this.sky.apply(tile);
    this.shadows.take(tile);
    this.colours.apply(tile);
  }

  tilesChanged() {
    if (!this.address) return;
    if (this.outline.id) this.outline.show(this.outline.id, this.tileset.shown).then(this.changed);
    if (this.walk.wanted) this.walk.land();
    this.lamps.last.x = Infinity;
    this.budget.seen.x = Infinity;
    this.shadows.forget();
    this.changed();
  }

  skyChanged() {
    for (const tile of this.tileset.loaded.values()) this.sky.apply(tile);
    this.shadows.forget();
    this.changed();
  }

  click(event) {
    const isTouch = event.pointerType === "touch";
    if (isTouch && this.touch.wasMany) return;
    if (Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) > (isTouch ? TAP_PX : CLICK_PX)) return;
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
    if (id && this.device === "phone") this.fold(true);
    if (id) this.picked = { id, record: await this.panel.show(id) };
    else [this.picked, byId("feature").hidden] = [null, true];
    await drawn;
    this.address.later();
    this.changed();
  }

  showMode(mode) {
    for (const name of ["fly", "walk"]) byId(name).setAttribute("aria-pressed", String(mode === name));
  }

  /** "walk" sets a walker down on the street that is picked or looked at. */
  setMode(mode) {
    this.showMode(mode);
    this.moves.travel = null;
    if (mode === "fly") return this.moves.setMode("fly");
    const { id, record } = this.picked ?? {};
    // the mark of what is picked would cover the street, and on a phone its panel the view
    this.outline.show(null, []);
    if (this.device === "phone") this.panel.hide();
    return this.walk.begin(record ? { id, at: new THREE.Vector3(...record.at) } : null);
  }

  goHome() {
    const { west, south, east, north, ground_m } = this.limits;
    this.setMode("fly");
    this.moves.goTo(new THREE.Vector3((west + east) / 2, (south + north) / 2, ground_m), 0.9 * Math.hypot(east - west, north - south), -0.6);
  }

  goToPlace(lon_deg, lat_deg) {
    const at = this.frame.at(lon_deg, lat_deg, this.page.ground_m);
    at.z = this.rays.groundAt(at.x, at.y) ?? at.z;
    this.goToGround(at, 120);
    say(`At ${lat_deg}, ${lon_deg}`);
  }

  goToFeature(id, record) {
    this.setMode("fly");
    this.moves.goTo(new THREE.Vector3(...record.at), Math.min(600, Math.max(40, 2 * (record.size_m ?? 30))));
    return this.pick(id);
  }

  /** Flies to a place on the ground, whose height may only be known when its tile is there. */
  goToGround(at, distance_m, finding) {
    this.setMode("fly");
    this.moves.goTo(at, distance_m);
    this.goal = { at, eye: this.moves.travel.to, finding };
  }

  /** Raises or lowers the camera with the ground that it flew to. Returns true if it has moved. */
  correctGoal() {
    const { goal, camera } = this;
    if (!goal || camera.position.distanceTo(goal.eye) > 0.5) return false;
    const higher_m = (this.rays.groundAt(goal.at.x, goal.at.y) ?? goal.at.z) - goal.at.z;
    if (Math.abs(higher_m) < 1) return (this.goal = null), false;
    for (const place of [camera.position, goal.at, goal.eye]) place.z += higher_m;
    if (goal.finding) this.findings.settle(goal.finding);
    return true;
  }

  flyTo(finding) {
    this.goToGround(this.findings.place(finding), 60, finding);
    this.findings.settle(finding);
    this.findings.tell(finding);
    const { id } = finding.properties;
    if (id) this.pick(id).then(() => this.findings.tell(finding));
  }

  get link() {
    const { position } = this.camera, { heading, pitch, mode } = this.moves;
    return writeLink({ position, heading, pitch, mode, hidden: this.layers.hidden, colours: this.colours.mode, time: this.sky.number, detail_px: this.tileset.detail_px, names: this.names.language, id: this.panel.id });
  }

  async copyLink() {
    this.address.now();
    const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    byId("linked").textContent = isCopied ? "The link to this view is copied." : "The address of this page leads to this view.";
  }

  openLink() {
    for (const name of hiddenBy(new URLSearchParams(location.search).get("layers") ?? "")) this.layers.set(name, false);
    const state = readLink(location.hash.slice(1));
    this.tileset.setDetail(state.detail_px);
    for (const name of state.hidden) if (byId(`layer-${name}`)) this.layers.set(name, false);
    if (["none", "level", "error", "source"].includes(state.colours)) this.colours.set(state.colours);
    if (state.time !== undefined) this.sky.set(state.time);
    this.names.set(state.names);
    if (state.position) this.openView(state);
    if (state.id) this.openPicked(state);
  }

  openView({ position: [x, y, z], heading, pitch, mode }) {
    const { west, south, east, north } = this.limits, away_m = 2 * Math.hypot(east - west, north - south);
    if (x < west - away_m || x > east + away_m || y < south - away_m || y > north + away_m) return say("This link leads outside of the map.");
    this.moves.travel = null;
    this.camera.position.set(x, y, z);
    this.moves.mode = mode;
    this.moves.stand();
    this.moves.look(heading, pitch);
    this.showMode(mode);
  }

  async openPicked({ id, position }) {
    const record = await this.records.find(id);
    if (!record) return say(`This link leads to ${elementOf(id)}, which is not on this map.`);
    return position ? this.pick(id) : this.goToFeature(id, record);
  }

  fold(isFolded) {
    byId("sections").hidden = isFolded;
    byId("fold").textContent = isFolded ? "More" : "Less";
    byId("fold").setAttribute("aria-expanded", String(!isFolded));
  }
}
