// Finds a place to stand on: the middle of the street nearest to a point, and the direction of the street there.
import { Vector3 } from "three";
import { featuresOf, tableOf } from "./features.js";

const IS_STREET = /(Road|Street|Path|Track|Steps|Square|Bridge)$/, IS_NARROW = /(Path|Track|Steps|ServiceRoad)$/;
/** A path is chosen only where it is nearer than a road by this factor. */
const NARROW = 2;
/** The part of a street by which its direction is found. */
const NEAR_M = 15;

const corners = [new Vector3(), new Vector3(), new Vector3()];

/** Calls a function with the middle, the area on the map and the row of every triangle of streets in a mesh. */
function forEachTriangle(mesh, isWanted, use) {
  const features = featuresOf(mesh), { position } = mesh.geometry.attributes, index = mesh.geometry.index?.array;
  if (!features || !index || mesh.isInstancedMesh) return;
  mesh.updateWorldMatrix(true, false);
  for (let i = 0; i < index.length; i += 3) {
    const row = features.getX(index[i]);
    if (!isWanted(row)) continue;
    corners.forEach((corner, k) => corner.fromBufferAttribute(position, index[i + k]).applyMatrix4(mesh.matrixWorld));
    const [a, b, c] = corners;
    const area_m2 = Math.abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
    if (area_m2 > 0) use({ x: (a.x + b.x + c.x) / 3, y: (a.y + b.y + c.y) / 3, z: (a.z + b.z + c.z) / 3, area_m2, row });
  }
}

const roadsOf = (tile) => tile.meshes.filter(({ userData }) => ["roads", "structures"].includes(userData.layer));

/** Returns the triangle of a street that is nearest to a point, with its tile; null if none is shown. */
async function nearest(tiles, point, row) {
  let best = null;
  for (const tile of tiles) {
    const table = await tableOf(tile);
    if (!table) continue;
    const own = row(table), isWanted = (each) => (own === null ? IS_STREET.test(table.classes[each] ?? "") : each === own);
    for (const mesh of roadsOf(tile))
      forEachTriangle(mesh, isWanted, (each) => {
        const far_m = Math.hypot(each.x - point.x, each.y - point.y) * (IS_NARROW.test(table.classes[each.row] ?? "") ? NARROW : 1);
        if (!best || far_m < best.far_m) best = { ...each, far_m, tile };
      });
  }
  return best;
}

/** Returns the mean of triangles by area, and the axis along which they lie: principal components. */
function axisOf(parts) {
  const sum = parts.reduce((s, p) => s + p.area_m2, 0), mean = (f) => parts.reduce((s, p) => s + f(p) * p.area_m2, 0) / sum;
  const x = mean((p) => p.x), y = mean((p) => p.y);
  const xx = mean((p) => (p.x - x) ** 2), yy = mean((p) => (p.y - y) ** 2), xy = mean((p) => (p.x - x) * (p.y - y));
  const turn = Math.atan2(2 * xy, xx - yy) / 2;
  return { x, y, east: Math.cos(turn), north: Math.sin(turn) };
}

/**
 * Returns the place in the middle of the street that is nearest to a point, and the heading along it; null if no street is shown.
 *
 * @param tiles  The shown tiles. @param row Returns the row of the only street that is wanted in a table, -1 if it is not there, or null for
 *   any street.
 */
export async function streetAt(tiles, point, row = () => null) {
  const best = await nearest(tiles, point, row);
  if (!best) return null;
  const parts = [];
  for (const mesh of roadsOf(best.tile))
    forEachTriangle(mesh, (each) => each === best.row, (each) => Math.hypot(each.x - best.x, each.y - best.y) < NEAR_M && parts.push(each));
  const axis = axisOf(parts.length > 0 ? parts : [best]);
  const along = (best.x - axis.x) * axis.east + (best.y - axis.y) * axis.north;
  return { at: new Vector3(axis.x + along * axis.east, axis.y + along * axis.north, best.z), heading: Math.atan2(axis.east, axis.north) };
}
