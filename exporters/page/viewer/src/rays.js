// Rays into the shown tiles.
import { Raycaster, Vector2, Vector3 } from "three";
import { LAYERS } from "./tileset.js";

const DOWN = new Vector3(0, 0, -1);
/** Layers that one stands on. */
const FLOORS = ["ground", "roads", "water", "structures"];
const ABOVE_M = 3;
/** Layers whose steep faces stop a walker, how high above the floor, and how near. */
const WALLS = ["buildings", "structures", "props"], CHEST_M = 1, ARM_M = 0.4;
/** Faces are steep if the height of their unit normal is below this. */
const STEEP = 0.7;

const seeing = (names) => {
  const ray = new Raycaster();
  ray.layers.disableAll();
  for (const name of names) ray.layers.enable(1 + LAYERS.indexOf(name));
  return ray;
};

const isShown = (object) => {
  for (let node = object; node; node = node.parent) if (!node.visible) return false;
  return true;
};

export class Rays {
  constructor(tileset, camera) {
    this.group = tileset.tiles.group;
    this.camera = camera;
    this.eye = new Raycaster();
    /** The middle of the view, from -1 to 1 up the picture. */
    this.middle = 0;
    this.down = seeing(FLOORS);
    this.level = seeing(WALLS);
  }

  /** Returns the first hit of what is shown at a point of the picture: x and y from -1 to 1, up and right; undefined for the sky. */
  at(x, y) {
    this.eye.setFromCamera(new Vector2(x, y), this.camera);
    return this.eye.intersectObject(this.group, true).find((hit) => hit.object.userData.loaded && isShown(hit.object));
  }

  /** Returns the distance to what is first hit from a place by level heading; Infinity for nothing. */
  free(from, heading) {
    this.eye.set(from, new Vector3(Math.sin(heading), Math.cos(heading), 0));
    return this.eye.intersectObject(this.group, true).find((hit) => hit.object.userData.loaded && isShown(hit.object))?.distance ?? Infinity;
  }

  /** Returns the level normal of the shown wall that a level step from a place on the floor meets at chest height; null if it is free. */
  wallAt(floor, step) {
    const length_m = step.length();
    if (length_m === 0) return null;
    this.level.set(new Vector3(floor.x, floor.y, floor.z + CHEST_M), step.clone().divideScalar(length_m));
    this.level.far = length_m + ARM_M;
    for (const hit of this.level.intersectObject(this.group, true)) {
      // lamps and bins, which are instances, are walked through
      if (hit.object.isInstancedMesh || !hit.object.userData.loaded || !isShown(hit.object)) continue;
      const normal = hit.face.normal.clone().transformDirection(hit.object.matrixWorld);
      if (Math.abs(normal.z) < STEEP) return normal.setZ(0).normalize().multiplyScalar(-Math.sign(normal.dot(step)) || 1);
    }
    return null;
  }

  /** Returns the height of the highest floor that is not above a place by more than a storey; undefined where nothing is loaded. */
  floorBelow(place) {
    this.down.set(new Vector3(place.x, place.y, place.z + ABOVE_M), DOWN);
    return this.down.intersectObject(this.group, true).find((hit) => hit.object.userData.loaded)?.point.z;
  }

  /** Returns the height of the ground at a place from above everything; undefined where nothing is loaded. */
  groundAt(x, y) {
    return this.floorBelow(new Vector3(x, y, 9000));
  }
}
