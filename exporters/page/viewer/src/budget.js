// What a picture may cost: triangles and megabytes by device. Where the tiles that the camera sees have more triangles, coarser ones are shown
// farther away, and small or far instances such as bins, cars and trees are left out.
import { Box3, Matrix4, Sphere, Vector3 } from "three";

/** Triangles of a picture, and megabytes of tiles that are kept. */
const BUDGETS = { phone: { triangles: 1.2e6, megabytes: 160 }, computer: { triangles: 3e6, megabytes: 500 } };
/** Where a walker stands, levels are chosen as if errors were this much larger: at eye height far tiles are seen flat. */
const STEP = 1.3, MOST = 8;
/** Pictures that must stay over, or far under, the budget before the level changes. */
const PATIENCE = 20;
/** Instances smaller than this in the picture are left out. */
const LEAST_PX = 3;
/** Instances are chosen anew when the camera has moved this far. */
const MOVED_M = 8;

/** "phone" for devices whose pointer is a finger, "computer" for others. */
export const deviceOf = () => (window.matchMedia("(pointer: coarse)").matches ? "phone" : "computer");

export class Budget {
  constructor(tileset, renderer, camera) {
    Object.assign(this, { tileset, renderer, camera, factor: 1, count: 0, over: 0, under: 0, seen: new Vector3(Infinity) });
    this.device = deviceOf();
    Object.assign(this, BUDGETS[this.device]);
    const cache = tileset.tiles.lruCache;
    cache.minBytesSize = this.megabytes * 0.7e6;
    cache.maxBytesSize = this.megabytes * 1e6;
  }

  /** Chooses levels and instances for the next picture. */
  update() {
    const { render } = this.renderer.info;
    this.over = render.triangles > this.triangles ? this.over + 1 : 0;
    this.under = render.triangles < this.triangles / 3 && this.factor > 1 ? this.under + 1 : 0;
    if (this.over > PATIENCE && this.tileset.isWhole) this.turn(Math.min(MOST, this.factor * STEP));
    if (this.under > 4 * PATIENCE && this.tileset.isWhole) this.turn(Math.max(1, this.factor / STEP));
    if (this.camera.position.distanceTo(this.seen) > MOVED_M) this.choose();
  }

  turn(factor) {
    this.factor = factor;
    this.over = this.under = 0;
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

/** Moves the instances that are large enough in the picture to the front, and draws these alone. */
function chooseInstances(mesh, eye, pixels) {
  const own = (mesh.userData.originals ??= originalsOf(mesh)), most_m = (own.size_m * pixels) / LEAST_PX;
  const isNear = (i) => Math.hypot(own.places[3 * i] - eye.x, own.places[3 * i + 1] - eye.y, own.places[3 * i + 2] - eye.z) < most_m;
  let count = 0;
  for (let i = 0; i < own.count; ++i) {
    if (!isNear(i)) continue;
    for (const { attribute, array } of own.attributes) {
      const { itemSize } = attribute;
      for (let k = 0; k < itemSize; ++k) attribute.array[count * itemSize + k] = array[i * itemSize + k];
    }
    ++count;
  }
  if (count === own.shown && count === own.count) return;
  own.shown = mesh.count = count;
  for (const { attribute } of own.attributes) attribute.needsUpdate = true;
}
