// Places: the frame of the scene is that of the tileset's root, x east, y north, z up in metres at the run's origin.
import { Matrix4, Vector3 } from "three";
import { WGS84_ELLIPSOID } from "3d-tiles-renderer/three";

const degrees = 180 / Math.PI;

/** Converts between the scene's frame and longitude, latitude and height on the ellipsoid. */
export class Frame {
  /** @param {number[]} transform The root's transform: from the scene's frame to earth-centred coordinates. */
  constructor(transform) {
    this.toEarth = new Matrix4().fromArray(transform);
    this.fromEarth = this.toEarth.clone().invert();
  }

  /** Returns the point of the scene at a place. */
  at(lon_deg, lat_deg, height_m = 0) {
    const earth = WGS84_ELLIPSOID.getCartographicToPosition(lat_deg / degrees, lon_deg / degrees, height_m, new Vector3());
    return earth.applyMatrix4(this.fromEarth);
  }

  /** Returns {lon_deg, lat_deg, height_m} of a point of the scene. */
  place(point) {
    const found = WGS84_ELLIPSOID.getPositionToCartographic(point.clone().applyMatrix4(this.toEarth), {});
    return { lon_deg: found.lon * degrees, lat_deg: found.lat * degrees, height_m: found.height };
  }
}
