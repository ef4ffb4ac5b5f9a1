// Draws the picked feature over the scene: the triangles of its id in all shown tiles.
import { BufferGeometry, DoubleSide, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial } from "three";
import { featuresOf, rowOfId, tableOf } from "./features.js";

const material = new MeshBasicMaterial({ color: "#ff00c8", transparent: true, opacity: 0.55, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2, toneMapped: false });

function trianglesOf(mesh, row) {
  const features = featuresOf(mesh), index = mesh.geometry.index.array, own = [];
  for (let i = 0; i < index.length; i += 3)
    if (features.getX(index[i]) === row) own.push(index[i], index[i + 1], index[i + 2]);
  if (own.length === 0) return null;
  const geometry = new BufferGeometry().setAttribute("position", mesh.geometry.attributes.position);
  return new Mesh(geometry.setIndex(own), material);
}

function instancesOf(mesh, row) {
  const features = featuresOf(mesh), own = [];
  for (let i = 0; i < mesh.count; ++i) if (features.getX(i) === row) own.push(i);
  if (own.length === 0) return null;
  const copies = new InstancedMesh(mesh.geometry, material, own.length), matrix = new Matrix4();
  own.forEach((from, to) => (mesh.getMatrixAt(from, matrix), copies.setMatrixAt(to, matrix)));
  return copies;
}

export class Outline {
  constructor(scene) {
    this.group = new Group();
    this.group.matrixAutoUpdate = false;
    scene.add(this.group);
    this.id = null;
    this.turn = 0;
  }

  /** Draws a feature; null draws none. */
  async show(id, tiles) {
    this.id = id;
    const turn = ++this.turn, parts = [];
    for (const tile of id ? tiles : []) {
      const table = await tableOf(tile);
      const row = table ? rowOfId(table, id) : -1;
      if (row > 0) parts.push(...this.partsOf(tile, row));
    }
    if (turn !== this.turn) return;
    this.group.clear();
    if (parts.length > 0) this.group.add(...parts);
  }

  partsOf(tile, row) {
    const parts = [];
    for (const mesh of tile.meshes) {
      if (!featuresOf(mesh) || !mesh.geometry.index) continue;
      const part = mesh.isInstancedMesh ? instancesOf(mesh, row) : trianglesOf(mesh, row);
      if (!part) continue;
      part.matrixAutoUpdate = false;
      part.matrix.copy(mesh.matrixWorld);
      parts.push(part);
    }
    return parts;
  }
}
