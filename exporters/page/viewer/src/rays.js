// Rays into the shown tiles.
import { Raycaster, Vector2, Vector3 } from "three";
import { LAYERS } from "./tileset.js";

const DOWN = new Vector3(0, 0, -1);
/** Layers that one stands on. */
const FLOORS = ["ground", "roads", "water", "structures"];
const ABOVE_M = 3;

const isShown = (object) => {
  for (let node = object; node; node = node.parent) if (!node.visible) return false;
  return true;
};

export class Rays {
  constructor(tileset, camera) {
    this.group = tileset.tiles.group;
    this.camera = camera;
    this.eye = new Raycaster();
    this.down = new Raycaster();
    this.down.layers.disableAll();
    for (const name of FLOORS) this.down.layers.enable(1 + LAYERS.indexOf(name));
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
