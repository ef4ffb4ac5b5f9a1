// Looks up the OSM element of a triangle: the feature ids of meshes are rows of the tile's property table (EXT_structural_metadata).

const LETTERS = ["", "n", "w", "r"];

/** Returns the views of a tile's property table that this page reads; null if it has none. */
async function readTable({ gltf }) {
  const table = gltf.parser.json.extensions?.EXT_structural_metadata?.propertyTables?.[0];
  if (!table) return null;
  const view = (name) => gltf.parser.getDependency("bufferView", table.properties[name].values);
  const [ids, types] = await Promise.all([view("id"), view("type")]);
  const assumed = table.properties.assumed ? new Uint16Array(await view("assumed")) : null;
  const classes = table.properties.class ? classNames(gltf, new Uint16Array(await view("class"))) : [];
  return { ids: new BigInt64Array(ids), types: new Uint8Array(types), assumed, classes };
}

/** Returns the name of the class of each row. */
function classNames({ parser }, values) {
  const names = new Map(parser.json.extensions.EXT_structural_metadata.schema.enums.class.values.map(({ name, value }) => [value, name]));
  return Array.from(values, (value) => names.get(value) ?? "");
}

/** Returns the table of a tile, which is read once. */
export function tableOf(tile) {
  tile.table ??= readTable(tile);
  return tile.table;
}

/** Returns the attribute that holds the feature of each vertex or, of instanced meshes, of each instance. */
export function featuresOf(mesh) {
  const { attributes } = mesh.geometry;
  return mesh.isInstancedMesh ? attributes._FEATURE_ID_0 ?? attributes._feature_id_0 : attributes._feature_id_0;
}

/** Returns the id in a row, such as "w123"; null for no element. */
export function idOfRow(table, row) {
  const letter = LETTERS[table.types[row]];
  return letter ? letter + table.ids[row] : null;
}

/** Returns the row of an id such as "w123", or -1. */
export function rowOfId(table, id) {
  const type = LETTERS.indexOf(id[0]);
  const number = BigInt(id.slice(1));
  return table.ids.findIndex((each, row) => each === number && table.types[row] === type);
}

/** Returns the id of what a ray hit. */
export async function idOfHit(hit) {
  const table = await tableOf(hit.object.userData.loaded);
  const features = featuresOf(hit.object);
  if (!table || !features) return null;
  return idOfRow(table, features.getX(hit.object.isInstancedMesh ? hit.instanceId : hit.face.a));
}
