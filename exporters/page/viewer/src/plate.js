// A plate as large as the map, which stands in its place until the first tile is loaded.
import { Mesh, MeshStandardMaterial, PlaneGeometry } from "three";

export function makePlate({ west, south, east, north, ground_m }) {
  const plate = new Mesh(new PlaneGeometry(east - west, north - south), new MeshStandardMaterial({ color: "#7d8768", roughness: 1 }));
  plate.position.set((west + east) / 2, (south + north) / 2, ground_m);
  return plate;
}
