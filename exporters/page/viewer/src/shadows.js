// Shadows of the sun or the moon around the camera: one map, drawn again when the camera, the light or the tiles have changed.
import { Vector3 } from "three";

/** Half of the side of the square with shadows: this many heights of the camera, within limits. */
export const LEAST_SHADOW_M = 90;
const HEIGHTS = 1.5, MOST_M = 1500;
/** The square moves with the camera in steps of this share of its half side. */
const STEP = 0.2;
const CASTING = ["buildings", "structures", "props", "plants"];
/** Lower lights throw none. */
const LOWEST = 0.03;
const TALL_M = 400;

/** Draws the near instances of a mesh alone, which come first (budget.js). */
const drawNear = {
  onBeforeShadow() {
    this.userData.all = this.count;
    this.count = Math.min(this.count, this.userData.near ?? this.count);
  },
  onAfterShadow() {
    this.count = this.userData.all;
  },
};

export class Shadows {
  constructor(renderer, sun, size_px) {
    Object.assign(this, { renderer, sun, isWanted: true, isOld: true, half_m: 0, at: new Vector3(Infinity) });
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.autoUpdate = false;
    sun.shadow.mapSize.set(size_px, size_px);
  }

  take(tile) {
    for (const mesh of tile.meshes) {
      mesh.receiveShadow = true;
      // the ground is lit by its slope
      mesh.castShadow = CASTING.includes(mesh.userData.layer);
      if (mesh.isInstancedMesh) Object.assign(mesh, drawNear);
    }
    this.isOld = true;
  }

  /** Draws the map again before the next picture. */
  forget() {
    this.isOld = true;
  }

  update(camera, moves, toSun) {
    const isOn = this.isWanted && toSun.z > LOWEST;
    if (this.sun.castShadow !== isOn) (this.sun.castShadow = isOn), (this.isOld = true);
    if (!isOn) return;
    const half_m = 2 ** Math.round(Math.log2(Math.min(MOST_M, Math.max(LEAST_SHADOW_M, moves.above_m * HEIGHTS))));
    const middle = this.middle(camera, moves, half_m);
    if (middle.distanceTo(this.at) > STEP * half_m || half_m !== this.half_m) this.move(middle, half_m);
    // the light's direction may have changed with the sky
    this.sun.target.position.copy(this.at);
    this.sun.position.copy(this.at).addScaledVector(toSun, this.half_m + TALL_M / Math.max(toSun.z, 0.1));
    this.sun.target.updateMatrixWorld();
    if (this.isOld) this.renderer.shadowMap.needsUpdate = true;
    this.isOld = false;
  }

  // on the ground, ahead of the camera
  middle(camera, { heading, above_m }, half_m) {
    const { x, y, z } = camera.position;
    return new Vector3(x + Math.sin(heading) * half_m * 0.6, y + Math.cos(heading) * half_m * 0.6, z - above_m);
  }

  move(middle, half_m) {
    this.at.copy(middle);
    this.half_m = half_m;
    const { camera, mapSize } = this.sun.shadow;
    Object.assign(camera, { left: -half_m, right: half_m, bottom: -half_m, top: half_m, near: 1, far: 2 * half_m + 2 * TALL_M / 0.1 });
    camera.updateProjectionMatrix();
    // by the size of a texel
    this.sun.shadow.normalBias = (3 * half_m) / mapSize.x;
    this.sun.shadow.bias = -0.0004;
    this.isOld = true;
  }
}
