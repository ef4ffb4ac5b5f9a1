// Street lamps of the tiles that throw light (--lights). Only the nearest ones are lit, since each light is paid in every pixel.
import { Matrix4, PointLight, Vector3 } from "three";
import { CANDELA } from "./sky.js";

const LIT = 8;
/** Lamps move to other places only when the camera has moved this far. */
const STEP_M = 4;

export class Lamps {
  /** @param {Object3D} group The group that tiles are added to, turned into the frame of the scene. */
  constructor(scene, group) {
    this.group = group;
    this.places = new Map();
    this.pool = Array.from({ length: LIT }, () => new PointLight("white", 0));
    this.scene = scene;
    this.last = new Vector3(Infinity, 0, 0);
  }

  /** Takes the lights out of a tile, which is loaded before it is added to the group. */
  take(tile) {
    const lights = [];
    tile.scene.updateMatrixWorld(true);
    const toScene = tile.scene.parent ? new Matrix4() : this.group.matrixWorld;
    tile.scene.traverse((object) => object.isLight && lights.push(object));
    this.places.set(tile, lights.map((light) => ({ at: light.getWorldPosition(new Vector3()).applyMatrix4(toScene), light })));
    for (const light of lights) light.removeFromParent();
    if (lights.length > 0 && !this.pool[0].parent) this.scene.add(...this.pool);
    this.last.x = Infinity;
  }

  forget(tile) {
    this.places.delete(tile);
  }

  /** Moves the lit lamps to those nearest to the camera. */
  update(eye, shown, exposure, areLit) {
    if (eye.distanceTo(this.last) < STEP_M && this.exposure === exposure && this.areLit === areLit) return;
    this.last.copy(eye);
    [this.exposure, this.areLit] = [exposure, areLit];
    const near = shown.flatMap((tile) => this.places.get(tile) ?? []);
    near.sort((a, b) => a.at.distanceToSquared(eye) - b.at.distanceToSquared(eye));
    this.pool.forEach((light, i) => this.put(light, areLit ? near[i] : undefined));
  }

  put(pooled, lamp) {
    pooled.intensity = lamp ? lamp.light.intensity * CANDELA * this.exposure : 0;
    if (!lamp) return;
    pooled.position.copy(lamp.at);
    pooled.color.copy(lamp.light.color);
    pooled.distance = lamp.light.distance;
  }
}
