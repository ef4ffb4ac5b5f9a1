// Loads the tiles that the camera sees, by 3DTilesRendererJS, and lists the meshes of each: the layer, the tile's level and error.
import { Matrix4 } from "three";
import { DRACOLoader } from "three/addons/loaders/DRACOLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { MeshoptDecoder } from "three/addons/libs/meshopt_decoder.module.js";
import { TilesRenderer } from "3d-tiles-renderer/three";
import { byId } from "./dom.js";
import { bytesOf } from "./memory.js";

/** The layers, in the order of compiler/bake/layer.h. Meshes outside of them are of the land around. */
export const LAYERS = ["ground", "roads", "water", "buildings", "structures", "props", "plants"];

const COARSE_PX = 20;

/**
 * Nearer tiles count as if they were this far away, and half as far as the floor is below: else the tile around the camera, whose box
 * reaches from its lowest to its highest point, is always the finest, whatever error is allowed.
 */
const NEAREST_M = 15, NEAREST = 0.5;

/** The tiles, whose errors on the picture are finite. */
class Tiles extends TilesRenderer {
  bytes = new WeakMap();
  nearest_m = NEAREST_M;

  // the library's own number counts the clones of a texture, which share one picture, as often as there are materials
  calculateBytesUsed(_, scene) {
    if (!scene) return null;
    if (!this.bytes.has(scene)) this.bytes.set(scene, bytesOf(scene));
    return this.bytes.get(scene);
  }

  // tiles without content are refined however small they are: nothing would be shown in their place
  calculateTileViewError(tile, target) {
    super.calculateTileViewError(tile, target);
    const [{ sseDenominator }] = this.cameraInfo;
    target.error = tile.content ? Math.min(target.error, tile.geometricError / (this.nearest_m * sseDenominator)) : Number.MAX_VALUE;
  }
}

/** Returns the layer that a mesh belongs to: that of the node above it. */
function layerOf(object) {
  for (let node = object; node; node = node.parent) {
    const name = node.name.replace(/_\d+$/, "");
    if (LAYERS.includes(name)) return name;
  }
  return "ground";
}

/** A loaded tile. */
class LoadedTile {
  constructor(scene, gltf, url) {
    this.scene = scene;
    this.gltf = gltf;
    this.url = url;
    const extras = gltf.parser.json.nodes[0].extras ?? {};
    this.tolerance_m = extras.tolerance_m ?? 0;
    this.error_m = extras.error_m ?? 0;
    this.meshes = [];
    scene.traverse((object) => {
      if (!object.isMesh) return;
      const layer = layerOf(object);
      object.userData.loaded = this;
      object.userData.layer = layer;
      // rays choose meshes by layer; the camera sees all that have bit 0
      object.layers.enable(1 + LAYERS.indexOf(layer));
      this.meshes.push(object);
    });
  }
}

/** The tileset, turned into the frame of its root. */
export class Tileset {
  /** @param {object} watch Functions that are called: tileLoaded(tile), tileGone(tile), changed(). */
  constructor(url, transform, camera, renderer, watch) {
    this.loaded = new Map();
    this.factor = 1;
    this.watch = watch;
    this.renderer = renderer;
    this.tiles = new Tiles(url);
    this.setDetail(Number(byId("detail").value));
    byId("detail").addEventListener("change", (event) => this.setDetail(Number(event.target.value)));
    this.addLoaders();
    this.tiles.setCamera(camera);
    this.tiles.setResolutionFromRenderer(camera, renderer);
    this.tiles.group.applyMatrix4(new Matrix4().fromArray(transform).invert());
    this.tiles.group.updateMatrixWorld(true);
    this.tiles.addEventListener("load-model", ({ scene, tile, url }) => this.take(scene, tile, url));
    this.tiles.addEventListener("dispose-model", ({ tile }) => this.forget(tile));
    this.tiles.addEventListener("tile-visibility-change", () => this.watch.changed());
    this.tiles.addEventListener("load-error", ({ url, error }) => this.watch.failed(url, error));
  }

  /** Sets the largest error on the picture, in pixels, of a coarse tile that stands for finer ones. */
  setDetail(error_px) {
    const isOffered = [...byId("detail").options].some((option) => Number(option.value) === error_px);
    if (!isOffered) return;
    this.detail_px = error_px;
    this.tiles.errorTarget = error_px * this.factor;
    byId("detail").value = String(error_px);
    this.watch.changed();
  }

  /** Allows errors that are larger than the chosen detail by a factor. */
  setFactor(factor) {
    this.factor = factor;
    this.setDetail(this.detail_px);
  }

  /** True for slow machines, which draw at half the resolution. */
  get isCoarse() {
    return this.detail_px >= COARSE_PX;
  }

  addLoaders() {
    const draco = new DRACOLoader(this.tiles.manager).setDecoderPath("page/");
    const loader = new GLTFLoader(this.tiles.manager).setDRACOLoader(draco).setMeshoptDecoder(MeshoptDecoder);
    this.tiles.manager.addHandler(/\.glb$/, loader);
  }

  take(scene, tile, url) {
    const loaded = new LoadedTile(scene, tile.engineData.metadata, url);
    this.loaded.set(tile, loaded);
    this.watch.tileLoaded(loaded);
  }

  forget(tile) {
    const loaded = this.loaded.get(tile);
    if (!loaded) return;
    this.loaded.delete(tile);
    this.watch.tileGone(loaded);
  }

  /** The tiles that are shown now. */
  get shown() {
    return [...this.tiles.visibleTiles].map((tile) => this.loaded.get(tile)).filter(Boolean);
  }

  /** The numbers of tiles that are not there yet. Tiles for which the budget has no room are not waited for. */
  get waiting() {
    const { queued, downloading, parsing } = this.tiles.stats;
    return { queued: this.tiles.lruCache.isFull() ? 0 : queued, downloading, parsing };
  }

  /** True if tiles that the camera sees are missing for want of memory. */
  get isFull() {
    return this.tiles.lruCache.isFull() && this.tiles.stats.refused > 0;
  }

  /** True if nothing is loading. */
  get isWhole() {
    const { queued, downloading, parsing } = this.waiting;
    return queued + downloading + parsing === 0 && this.loaded.size > 0;
  }

  /** @param {number} above_m The camera's height above the floor. */
  update(camera, above_m) {
    this.tiles.nearest_m = Math.max(NEAREST_M, NEAREST * above_m);
    this.tiles.setResolutionFromRenderer(camera, this.renderer);
    this.tiles.update();
  }
}
