// What a picture may cost: triangles and megabytes by device. Where the tiles that the camera sees have more triangles, coarser ones are shown
// farther away, and small or far instances such as bins, cars and trees are left out.
import { Matrix4, Vector3 } from "three";
import { LEAST_SHADOW_M } from "./shadows.js";

/** Triangles of a picture, and megabytes of tiles that are kept. */
const BUDGETS = { phone: { triangles: 1.2e6, megabytes: 160 }, computer: { triangles: 3e6, megabytes: 500 } };
/** Errors that are allowed grow by such factors while pictures cost too much, by more where they cost far too much; up to MOST. */
const STEP = 1.3, MOST_STEP = 2, MOST = 12;
/** The first picture allows errors that are larger by this factor: it is there with a third of the bytes. */
const FIRST = 2;
/** So many pictures and so long must a picture be over the budget before the level changes, also while tiles are loading. */
const PATIENCE = 2, PATIENCE_MS = 500;
/** The level becomes finer again when the camera is this far from where a picture cost too much. */
const AWAY_M = 60;
/** Pictures with more than this share of the budget do not become finer. */
const NEARLY = 0.6;
/** Instances smaller than this in the picture are left out. */
const LEAST_PX = 3;
/** Instances are chosen anew when the camera has moved this far. */
const MOVED_M = 8;

/** "phone" for devices whose pointer is a finger, "computer" for others. */
export const deviceOf = () => (window.matchMedia("(pointer: coarse)").matches ? "phone" : "computer");

export class Budget {
  constructor(tileset, renderer, camera) {
    Object.assign(this, { tileset, renderer, camera, factor: 1, over: 0, seen: new Vector3(Infinity), costly: new Vector3(Infinity) });
    this.device = deviceOf();
    Object.assign(this, BUDGETS[this.device]);
    const cache = tileset.tiles.lruCache;
    cache.minBytesSize = this.megabytes * 0.7e6;
    cache.maxBytesSize = this.megabytes * 1e6;
    this.turn(FIRST);
  }

  /** Keeps the level of the first picture until the camera leaves its place. */
  begin() {
    this.costly.copy(this.camera.position);
  }

  get isOver() {
    return this.renderer.info.render.triangles > this.triangles || this.tileset.isFull;
  }

  /** Chooses levels and instances for the next picture. */
  update() {
    const now_ms = performance.now();
    this.over = this.isOver ? this.over + 1 : 0;
    if (this.over <= 1) this.overSince_ms = now_ms;
    if (this.over > PATIENCE && now_ms - this.overSince_ms > PATIENCE_MS && this.factor < MOST) this.coarser();
    if (this.camera.position.distanceTo(this.seen) > MOVED_M) this.choose();
  }

  /** Chooses the level where the camera stands still. Returns true if it has changed. */
  settle() {
    if (this.isOver && this.factor < MOST) return this.coarser(), true;
    const isFar = this.camera.position.distanceTo(this.costly) > AWAY_M;
    if (this.factor === 1 || !isFar || this.renderer.info.render.triangles > NEARLY * this.triangles) return false;
    return this.turn(Math.max(1, this.factor / STEP)), true;
  }

  coarser() {
    this.costly.copy(this.camera.position);
    const over = this.renderer.info.render.triangles / this.triangles;
    this.turn(Math.min(MOST, this.factor * Math.min(MOST_STEP, Math.max(STEP, over))));
  }

  turn(factor) {
    this.factor = factor;
    this.over = 0;
    this.tileset.setFactor(factor);
  }

  /** Chooses the instances of all tiles. */
  choose() {
    this.seen.copy(this.camera.position);
    for (const tile of this.tileset.shown) this.apply(tile);
  }

  apply(tile) {
    const pixels = this.renderer.domElement.clientHeight / 2 / Math.tan((this.camera.fov * Math.PI) / 360);
    for (const mesh of tile.meshes) if (mesh.isInstancedMesh) chooseInstances(mesh, this.camera.position, pixels);
  }
}

/** What stays of a mesh while its instances change places: matrices, attributes of instances, and their places in the scene. */
function originalsOf(mesh) {
  const { geometry } = mesh, places = new Float32Array(3 * mesh.count), at = new Vector3(), matrix = new Matrix4();
  geometry.computeBoundingSphere();
  mesh.updateWorldMatrix(true, false);
  let scale = 0;
  for (let i = 0; i < mesh.count; ++i) {
    mesh.getMatrixAt(i, matrix);
    matrix.premultiply(mesh.matrixWorld);
    at.setFromMatrixPosition(matrix).toArray(places, 3 * i);
    scale = Math.max(scale, matrix.getMaxScaleOnAxis());
  }
  const instanced = Object.values(geometry.attributes).filter((attribute) => attribute.isInstancedBufferAttribute);
  const attributes = [mesh.instanceMatrix, ...instanced].map((attribute) => ({ attribute, array: attribute.array.slice() }));
  return { places, attributes, count: mesh.count, size_m: 2 * geometry.boundingSphere.radius * scale, shown: mesh.count };
}

/** Moves the instances that are large enough in the picture to the front, those near the camera first, and draws these alone. */
function chooseInstances(mesh, eye, pixels) {
  const own = (mesh.userData.originals ??= originalsOf(mesh)), most_m = (own.size_m * pixels) / LEAST_PX;
  const near = [], far = [];
  for (let i = 0; i < own.count; ++i) {
    const far_m = Math.hypot(own.places[3 * i] - eye.x, own.places[3 * i + 1] - eye.y, own.places[3 * i + 2] - eye.z);
    if (far_m < most_m) (far_m < 2 * LEAST_SHADOW_M ? near : far).push(i);
  }
  mesh.userData.near = near.length;
  const chosen = near.concat(far);
  if (chosen.length === own.shown && chosen.length === own.count && own.near === near.length) return;
  Object.assign(own, { shown: chosen.length, near: near.length });
  mesh.count = chosen.length;
  for (const { attribute, array } of own.attributes) reorder(attribute, array, chosen);
  mesh.boundingSphere = null;
}

function reorder(attribute, from, chosen) {
  const { array: to, itemSize } = attribute;
  chosen.forEach((i, place) => {
    for (let k = 0; k < itemSize; ++k) to[place * itemSize + k] = from[i * itemSize + k];
  });
  attribute.needsUpdate = true;
}
