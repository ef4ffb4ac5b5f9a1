// A run of citykiln in Babylon.js as a game needs it: levels by distance within a budget of draw calls and triangles, ground and walls that
// stop a walker, day and night. Coordinates are those of glTF: x east, y up, z south, metres from the run's origin.

// A small GPU draws this in 1/60 s.
const MOST_CALLS = 300, MOST_TRIANGLES = 3e6;
// A level is shown where its error is at most this, for 1080 rows and 75 degrees; more if the budget is short.
const PIXELS = 2, PIXELS_A_RADIAN = 1080 / (2 * Math.tan(75 / 2 * Math.PI / 180));
// Copies of a mesh with more triangles than this in all stay copies; fewer are written out and joined with the rest of their tile.
const COPIED_TRIANGLES = 2000;
const COLLIDING = new Set(["ground", "roads", "water", "buildings", "structures"]);
const GROUND = new Set(["ground", "roads", "water"]);
const COLLISION_REACH_M = 60;
// A walker: the height of its eyes, how far it keeps from walls, how high it steps up and how far down.
const EYE_M = 1.7, CHEST_M = 1.2, RADIUS_M = 0.3, STEP_M = 0.5, DROP_M = 2;
const LAMPS = 4;

/** The sun's direction (east, up, south) at an hour of the day in UTC; NOAA's formula of low precision, within 0.1 degrees. */
function sunAt(day, hour, { lat_deg, lon_deg }) {
  const rad = Math.PI / 180, n = (Date.parse(day) / 86400000) + hour / 24 - 10957.5;
  const mean = (357.528 + 0.9856003 * n) * rad, along = (280.46 + 0.9856474 * n + 1.915 * Math.sin(mean) + 0.02 * Math.sin(2 * mean)) * rad;
  const tilt = 23.439 * rad, declination = Math.asin(Math.sin(tilt) * Math.sin(along));
  const right = Math.atan2(Math.cos(tilt) * Math.sin(along), Math.cos(along));
  const turn = (280.46061837 + 360.98564736629 * n + lon_deg) * rad - right, lat = lat_deg * rad;
  return new BABYLON.Vector3(-Math.cos(declination) * Math.sin(turn),
    Math.sin(lat) * Math.sin(declination) + Math.cos(lat) * Math.cos(declination) * Math.cos(turn),
    -(Math.cos(lat) * Math.sin(declination) - Math.sin(lat) * Math.cos(declination) * Math.cos(turn)));
}

const layerOf = (mesh) => {
  let node = mesh;
  while (node.parent && !/^tile_/.test(node.parent.name)) node = node.parent;
  return node.name;
};

/** The matrices of all copies of a mesh, to the world. */
const copiesOf = (mesh) => {
  const world = mesh.computeWorldMatrix(true);
  return mesh.thinInstanceCount ? mesh.thinInstanceGetWorldMatrices().map((copy) => copy.multiply(world)) : [world];
};

const trianglesOf = (mesh) => mesh.getTotalIndices() / 3 * Math.max(1, mesh.thinInstanceCount);

/** Meshes of one material without pictures look alike when its colour is that of their vertices. */
const groupOf = ({ material }) => material.albedoTexture || material.emissiveTexture || material.bumpTexture ? material.uniqueId
  : `plain ${material.emissiveColor.toHexString()} ${material.alpha < 1 ? material.uniqueId : ""} ${material.metallic > 0.5} ${material.backFaceCulling}`;

/** The data itself, or without normals each triangle with corners of its own and the normal of its plane, as glTF demands. */
function withNormals(data) {
  if (data.normals) return data;
  const flat = new BABYLON.VertexData(), count = data.positions.length / 3;
  for (const name of ["positions", "colors", "uvs"]) {
    const width = data[name]?.length / count;
    if (width) flat[name] = Array.from(data.indices).flatMap((v) => Array.from(data[name].slice(v * width, (v + 1) * width)));
  }
  flat.indices = Array.from(data.indices, (_, i) => i);
  BABYLON.VertexData.ComputeNormals(flat.positions, flat.indices, flat.normals = [], { useRightHandedSystem: true });
  return flat;
}

/** One mesh of all copies of some, which share a group. Colours of plain materials go to the vertices. */
function joined(meshes, scene) {
  const all = { positions: [], normals: [], colors: [], uvs: [], indices: [] };
  const isPlain = !meshes.some(({ material }) => material.albedoTexture || material.emissiveTexture || material.bumpTexture);
  for (const mesh of meshes) {
    const data = withNormals(BABYLON.VertexData.ExtractFromMesh(mesh, true, true));
    const count = data.positions.length / 3, base = isPlain ? mesh.material.albedoColor : BABYLON.Color3.White();
    const width = data.colors ? data.colors.length / count : 0;
    for (const matrix of copiesOf(mesh)) {
      const copy = new BABYLON.VertexData();
      Object.assign(copy, { positions: [...data.positions], normals: [...data.normals], indices: [...data.indices] });
      copy.transform(matrix);
      const first = all.positions.length / 3;
      for (const value of copy.positions) all.positions.push(value);
      for (const value of copy.normals) all.normals.push(value);
      for (const index of copy.indices) all.indices.push(index + first);
      for (let v = 0; v < count; ++v) {
        const tint = width ? [0, 1, 2].map((c) => data.colors[v * width + c]) : [1, 1, 1];
        all.colors.push(base.r * tint[0], base.g * tint[1], base.b * tint[2], 1);
        all.uvs.push(data.uvs ? data.uvs[2 * v] : 0, data.uvs ? data.uvs[2 * v + 1] : 0);
      }
    }
  }
  const mesh = new BABYLON.Mesh("joined", scene), data = new BABYLON.VertexData();
  if (isPlain) delete all.uvs;
  Object.assign(data, all);
  data.applyToMesh(mesh);
  // which side of a face is its front differs with the handedness of the scene
  mesh.sideOrientation = meshes[0].sideOrientation;
  mesh.material = isPlain ? meshes[0].material.clone("plain") : meshes[0].material;
  if (isPlain) mesh.material.albedoColor = BABYLON.Color3.White();
  return mesh;
}

/** A level of a tile in the scene: few meshes, and copies of those that have many. */
class Level {
  constructor(container, scene) {
    this.meshes = [];
    this.solid = [];
    this.lamps = [];
    const groups = new Map();
    container.addAllToScene();
    for (const mesh of container.meshes.filter((each) => each.getTotalIndices?.() > 0)) {
      if (COLLIDING.has(layerOf(mesh))) this.solid.push(mesh);
      if (/Lamp(_primitive\d+)?$/.test(mesh.name) || /Lamp$/.test(mesh.parent?.name ?? "")) for (const copy of copiesOf(mesh)) this.lamps.push(copy.getTranslation());
      const isCopied = mesh.thinInstanceCount > 1 && trianglesOf(mesh) > COPIED_TRIANGLES;
      const group = isCopied ? mesh.uniqueId : groupOf(mesh);
      groups.set(group, [...(groups.get(group) ?? []), mesh]);
    }
    for (const meshes of groups.values()) {
      const isCopied = meshes.length === 1 && meshes[0].thinInstanceCount > 1 && trianglesOf(meshes[0]) > COPIED_TRIANGLES;
      this.meshes.push(isCopied ? meshes[0] : joined(meshes, scene));
    }
    for (const mesh of container.meshes) if (!this.meshes.includes(mesh)) mesh.setEnabled(mesh.getTotalIndices?.() === 0 || !mesh.getTotalIndices);
    for (const mesh of this.meshes) mesh.freezeWorldMatrix(), mesh.doNotSyncBoundingInfo = true;
    this.collision = null;
    this.show(false);
  }

  get calls() { return this.meshes.length; }
  get triangles() { return this.meshes.reduce((sum, mesh) => sum + trianglesOf(mesh), 0); }

  show(isShown) {
    for (const mesh of this.meshes) mesh.setEnabled(isShown);
  }

  /** Lets a walker stand on the level and stop at its walls, or not. The meshes that do so are not drawn. */
  collide(isSolid, scene) {
    if (isSolid && !this.collision) this.collision = [true, false].map((isGround) => this.solidMesh(isGround, scene)).filter(Boolean);
    for (const mesh of this.collision ?? []) mesh.isSolid = isSolid;
  }

  /** One mesh of ground, roads and water, or of what stands on it, with a search tree. */
  solidMesh(isGround, scene) {
    const parts = this.solid.filter((mesh) => GROUND.has(layerOf(mesh)) === isGround);
    if (!parts.length) return null;
    const mesh = joined(parts, scene);
    Object.assign(mesh, { isVisible: false, isGround });
    mesh.subdivide(200);
    mesh.createOrUpdateSubmeshesOctree(64, 4);
    return mesh;
  }
}

/** A tile: a square with levels, the finest first. */
class Tile {
  constructor(levels, tile_m, ground_m) {
    const { x, y } = levels[0];
    Object.assign(this, { levels, ground_m, box: [x * tile_m, y * tile_m, (x + 1) * tile_m, (y + 1) * tile_m], loaded: [], shown: -1 });
  }

  /** The distance from a vector of the scene to the tile's square at the height of its ground. */
  distance({ x, y, z }) {
    const [west, south, east, north] = this.box;
    return Math.hypot(Math.max(west - x, 0, x - east), Math.max(south + z, 0, -z - north), Math.max(y - this.ground_m - 60, 0));
  }

  /** The coarsest level whose error is small enough from there. */
  wanted(eye, pixels) {
    const most_m = Math.max(this.distance(eye), 1) * pixels / PIXELS_A_RADIAN;
    for (let level = this.levels.length - 1; level > 0; --level) if (this.levels[level].error_m <= most_m) return level;
    return 0;
  }
}

export class City {
  /** Opens a run of `compile --target three`. Nothing is loaded before update(). */
  static async open(scene, run) {
    const report = await (await fetch(`${run}/report.json`)).json();
    return new City(scene, run, report);
  }

  constructor(scene, run, report) {
    scene.useRightHandedSystem = true;
    scene.skipPointerMovePicking = true;
    const tiles = new Map();
    for (const tile of report.tiles) tiles.set(`${tile.x}_${tile.y}`, [...(tiles.get(`${tile.x}_${tile.y}`) ?? []), tile]);
    Object.assign(this, { scene, run, report, loading: 0, counts: { calls: 0, triangles: 0 } });
    this.tiles = [...tiles.values()].map((levels) => new Tile(levels.sort((a, b) => a.level - b.level), report.tile_m, report.sky.ground_m));
    this.sun = new BABYLON.DirectionalLight("sun", BABYLON.Vector3.Down(), scene);
    this.sky = new BABYLON.HemisphericLight("sky", BABYLON.Vector3.Up(), scene);
    this.lamps = Array.from({ length: LAMPS }, (_, i) => new BABYLON.PointLight(`lamp ${i}`, BABYLON.Vector3.Zero(), scene));
    for (const lamp of this.lamps) Object.assign(lamp, { range: 25, diffuse: new BABYLON.Color3(1, 0.8, 0.55) });
    scene.imageProcessingConfiguration.toneMappingEnabled = true;
    scene.imageProcessingConfiguration.toneMappingType = BABYLON.ImageProcessingConfiguration.TONEMAPPING_ACES;
    this.setHour(Number(report.sky.time.slice(11, 13)) + Number(report.sky.time.slice(14, 16)) / 60);
  }

  /** Sets the hour of the run's day in UTC: the sun, the sky, lamps and windows follow. */
  setHour(hour) {
    this.hour = hour;
    const toSun = sunAt(this.report.sky.time.slice(0, 10), hour, this.report.origin), day = Math.min(Math.max((toSun.y + 0.1) / 0.3, 0), 1);
    this.isNight = toSun.y < -0.05;
    this.sun.direction = toSun.scale(-1);
    this.sun.intensity = 4 * Math.min(Math.max(toSun.y / 0.2, 0), 1);
    this.sky.intensity = 0.06 + 0.9 * day;
    this.scene.clearColor = BABYLON.Color4.Lerp(new BABYLON.Color4(0.01, 0.015, 0.03, 1), new BABYLON.Color4(0.5, 0.66, 0.85, 1), day);
    this.light();
  }

  /** Lamps and windows of loaded tiles shine by night alone. */
  light() {
    for (const material of this.scene.materials) {
      material.maxSimultaneousLights = 1 + LAMPS;
      if (material.emissiveIntensity !== undefined) material.emissiveIntensity = this.isNight ? 1 : 0;
    }
    this.sun.setEnabled(!this.isNight);
    for (const lamp of this.lamps) lamp.setEnabled(this.isNight);
  }

  /** Shows the levels that fit the active camera's place, loads what lacks, and keeps within the budget. Call it each frame. */
  update() {
    const eye = this.scene.activeCamera.globalPosition;
    const chosen = this.choose(eye);
    for (const [tile, level] of chosen) this.show(tile, level, eye);
    this.counts = this.shownCounts();
    if (this.isNight) this.placeLamps(eye);
  }

  /** [tile, level] of all tiles, the nearest first: coarser ones while the budget is exceeded. */
  choose(eye) {
    const tiles = [...this.tiles].sort((a, b) => a.distance(eye) - b.distance(eye));
    for (let pixels = PIXELS; ; pixels *= 1.25) {
      const chosen = tiles.map((tile) => [tile, tile.wanted(eye, pixels)]);
      let calls = 0, triangles = 0;
      for (const [tile, level] of chosen) calls += tile.loaded[level]?.calls ?? 0, triangles += tile.loaded[level]?.triangles ?? tile.levels[level].triangles;
      if ((calls <= MOST_CALLS && triangles <= MOST_TRIANGLES) || pixels > 1000) return chosen;
    }
  }

  show(tile, level, eye) {
    const ready = tile.loaded[level], isNear = tile.distance(eye) < COLLISION_REACH_M;
    if (ready === undefined) this.load(tile, level);
    // a walker needs the finest ground and walls, whatever is drawn
    if (isNear && tile.loaded[0] === undefined) this.load(tile, 0);
    tile.loaded[0]?.collide(isNear, this.scene);
    if (!ready || tile.shown === level) return;
    tile.loaded[tile.shown]?.show(false);
    ready.show(true);
    tile.shown = level;
  }

  async load(tile, level) {
    if (this.loading >= 4) return;
    ++this.loading;
    tile.loaded[level] = null;
    try {
      const container = await BABYLON.LoadAssetContainerAsync(`${this.run}/${tile.levels[level].file}`, this.scene);
      tile.loaded[level] = new Level(container, this.scene);
      this.light();
    } finally {
      --this.loading;
    }
  }

  shownCounts() {
    const shown = this.tiles.map((tile) => tile.loaded[tile.shown]).filter(Boolean);
    return { calls: shown.reduce((sum, each) => sum + each.calls, 0), triangles: shown.reduce((sum, each) => sum + each.triangles, 0) };
  }

  /** True when all that is wanted from the camera's place is shown. */
  get isSettled() {
    const eye = this.scene.activeCamera.globalPosition;
    return this.loading === 0 && this.choose(eye).every(([tile, level]) => tile.shown === level);
  }

  /** The nearest lamps are lights; the others shine by their glass alone. */
  placeLamps(eye) {
    const places = this.tiles.flatMap((tile) => tile.loaded[tile.shown]?.lamps ?? []);
    places.sort((a, b) => BABYLON.Vector3.DistanceSquared(a, eye) - BABYLON.Vector3.DistanceSquared(b, eye));
    this.lamps.forEach((lamp, i) => {
      lamp.setEnabled(i < places.length);
      if (places[i]) lamp.position.copyFrom(places[i]).addInPlaceFromFloats(0, 4, 0), lamp.intensity = 60;
    });
  }

  /** A walker at a place (metres east and north) and the camera of its eyes. It stands on the ground once that is loaded. */
  addWalker([east, north]) {
    const camera = new BABYLON.FreeCamera("eyes", new BABYLON.Vector3(east, this.report.sky.ground_m, -north), this.scene);
    camera.inputs.removeByType("FreeCameraKeyboardMoveInput");
    Object.assign(camera, { minZ: 0.1, maxZ: 6000, fov: 75 * Math.PI / 180 });
    return { walker: new Walker(this, camera), camera };
  }

  /** What a ray meets of solid meshes first: { distance, pickedPoint, getNormal() }, or nothing. */
  hit(from, direction, length_m) {
    const met = this.scene.pickWithRay(new BABYLON.Ray(from, direction, length_m), (mesh) => mesh.isSolid);
    return met?.hit ? met : undefined;
  }

  /** The height of the ground at a place of the scene, below roofs and bridges; nothing before it is loaded. */
  groundAt({ x, z }) {
    const down = new BABYLON.Ray(new BABYLON.Vector3(x, 1e4, z), BABYLON.Vector3.Down(), 2e4);
    const hits = this.scene.multiPickWithRay(down, (mesh) => mesh.isSolid);
    return hits.length ? Math.max(...hits.filter((hit) => hit.pickedMesh.isGround).map((hit) => hit.pickedPoint.y)) : undefined;
  }
}

/** Someone who walks where ground and walls let them: rays at knees and chest find walls, one down finds the ground. */
class Walker {
  constructor(city, camera) {
    Object.assign(this, { city, camera, stands: false });
  }

  get feet_m() { return this.camera.position.y - EYE_M; }

  /** Moves by metres ahead and to the right, along a wall where one is in the way. Nothing moves before there is ground. */
  step(ahead, aside) {
    if (!this.stands) return this.land();
    const turn = this.camera.rotation.y;
    const along = new BABYLON.Vector3(Math.sin(turn) * ahead - Math.cos(turn) * aside, 0, Math.cos(turn) * ahead + Math.sin(turn) * aside);
    if (along.lengthSquared() > 0) this.move(along, 2);
  }

  move(along, tries) {
    const direction = along.normalizeToNew(), wall = this.wallAhead(direction, along.length() + RADIUS_M);
    if (wall) {
      const across = wall.getNormal(true, false);
      across.y = 0;
      across.normalize();
      const rest = along.subtract(across.scale(BABYLON.Vector3.Dot(along, across)));
      if (tries > 1 && rest.length() > 1e-3) this.move(rest, tries - 1);
      return;
    }
    const next = this.camera.position.add(along);
    const ground = this.city.hit(new BABYLON.Vector3(next.x, this.feet_m + STEP_M, next.z), BABYLON.Vector3.Down(), STEP_M + DROP_M);
    // there is no ground at the end of what is loaded, nor below a quay
    if (ground) this.camera.position.set(next.x, ground.pickedPoint.y + EYE_M, next.z);
  }

  /** What is in the way: any face at the chest, and at the knees one too steep to walk up. */
  wallAhead(direction, length_m) {
    const met = (height_m) => this.city.hit(this.camera.position.add(new BABYLON.Vector3(0, height_m - EYE_M, 0)), direction, length_m);
    const low = met(STEP_M);
    return met(CHEST_M) ?? (low && Math.abs(low.getNormal(true, false).y) < 0.5 ? low : undefined);
  }

  land() {
    const ground_m = this.city.groundAt(this.camera.position);
    if (ground_m === undefined) return;
    this.camera.position.y = ground_m + EYE_M;
    this.stands = true;
  }
}
