// Colours the scene by level, error or source. The colours differ in lightness and keep apart for the colour-blind: cividis for numbers
// (Nuñez, Anderton and Renslow 2018), Okabe and Ito's blue and orange for sources.
import { Color, BufferAttribute, InstancedBufferAttribute, MeshBasicMaterial } from "three";
import { byId, make } from "./dom.js";
import { featuresOf, tableOf } from "./features.js";

const CIVIDIS = ["#00224e", "#35456c", "#666970", "#948e77", "#c8b866", "#fee838"];
const MAPPED = new Color("#0072b2"), ASSUMED = new Color("#e69f00"), NONE = new Color("#333333");
/** The least error of each class, in metres. */
const ERRORS_M = [0, 0.1, 0.5, 1.5, 5, 20];

/** Returns the place of a tolerance among the run's levels; inner tiles, which are coarser, share the last class. */
const classOfLevel = (tile, levels_m) => {
  const found = levels_m.findIndex((level) => tile.tolerance_m <= level * 1.001);
  return found < 0 ? levels_m.length : found;
};
const classOfError = (tile) => ERRORS_M.findLastIndex((least) => tile.error_m >= least);

const shade = (index, count) => CIVIDIS[count < 2 ? 0 : Math.round((index * (CIVIDIS.length - 1)) / (count - 1))];

export class Colours {
  /** @param {object} page page.json; @param {Function} changed Called when colours have changed. */
  constructor(tileset, page, changed) {
    this.tileset = tileset;
    this.levels_m = page.levels_m;
    this.changed = changed;
    this.mode = "none";
    byId("colours").addEventListener("change", (event) => this.set(event.target.value));
  }

  async set(mode) {
    this.mode = mode;
    byId("colours").value = mode;
    this.showLegend();
    await Promise.all([...this.tileset.loaded.values()].map((tile) => this.apply(tile)));
    this.changed();
  }

  async apply(tile) {
    const mode = this.mode;
    const table = mode === "source" ? await tableOf(tile) : null;
    if (mode !== this.mode) return;
    for (const mesh of tile.meshes) {
      mesh.userData.own ??= mesh.material;
      this.restore(mesh);
      if (mode === "level") paint(mesh, new Color(shade(classOfLevel(tile, this.levels_m), this.levels_m.length + 1)));
      if (mode === "error") paint(mesh, new Color(shade(classOfError(tile), ERRORS_M.length)));
      if (mode === "source") paintSource(mesh, table);
    }
    this.changed();
  }

  restore(mesh) {
    if (mesh.material === mesh.userData.own) return;
    mesh.material.dispose();
    mesh.material = mesh.userData.own;
    if (mesh.isInstancedMesh) mesh.instanceColor = null;
    else if (mesh.userData.ownColour !== undefined) setColour(mesh, mesh.userData.ownColour);
    delete mesh.userData.ownColour;
  }

  /** The rows of the legend: [colour, text]. */
  rows() {
    const levels = this.levels_m.length + 1;
    if (this.mode === "level")
      return [...this.levels_m.map((level, i) => [shade(i, levels), `level ${i}: ${level} m`]), [shade(levels - 1, levels), "coarser, far away"]];
    if (this.mode === "error")
      return ERRORS_M.map((least, i) => [shade(i, ERRORS_M.length), ERRORS_M[i + 1] ? `${least} to ${ERRORS_M[i + 1]} m` : `${least} m or more`]);
    if (this.mode === "source")
      return [[MAPPED, "mapped"], [ASSUMED, "something is assumed"], [NONE, "no element of the map"]].map(([c, text]) => [`#${c.getHexString()}`, text]);
    return [];
  }

  showLegend() {
    byId("legend").replaceChildren(...this.rows().map(([colour, text]) => make("li", {}, swatch(colour), text)));
  }
}

// a canvas, because the page's policy allows no style attributes
function swatch(colour) {
  const canvas = make("canvas", { width: 1, height: 1 });
  const context = canvas.getContext("2d");
  context.fillStyle = colour;
  context.fillRect(0, 0, 1, 1);
  canvas.setAttribute("aria-hidden", "true");
  return canvas;
}

/** Returns a material of one colour, without light, so that it is the legend's; it keeps the cutouts of the mesh's own. */
function plain(mesh, colour, hasColours = false) {
  const { alphaTest, side, map } = mesh.userData.own;
  const material = new MeshBasicMaterial({ color: colour, side, vertexColors: hasColours, toneMapped: false });
  if (alphaTest > 0 && map) Object.assign(material, { alphaTest, map }).onBeforeCompile = keepAlphaAlone;
  return material;
}

function keepAlphaAlone(shader) {
  shader.fragmentShader = shader.fragmentShader.replace("#include <map_fragment>", "diffuseColor.a *= texture2D(map, vMapUv).a;");
}

function setColour(mesh, attribute) {
  if (attribute) mesh.geometry.setAttribute("color", attribute);
  else mesh.geometry.deleteAttribute("color");
}

function paint(mesh, colour) {
  mesh.material = plain(mesh, colour);
}

const sourceOf = (table, row) => (row === 0 ? NONE : table.assumed?.[row] ? ASSUMED : MAPPED);

function paintSource(mesh, table) {
  const features = featuresOf(mesh);
  if (!table || !features) return paint(mesh, NONE);
  if (mesh.isInstancedMesh) return paintInstances(mesh, table, features);
  const colours = new Float32Array(features.count * 3);
  for (let i = 0; i < features.count; ++i) sourceOf(table, features.getX(i)).toArray(colours, i * 3);
  mesh.userData.ownColour = mesh.geometry.attributes.color ?? null;
  setColour(mesh, new BufferAttribute(colours, 3));
  mesh.material = plain(mesh, "white", true);
}

function paintInstances(mesh, table, features) {
  const colours = new Float32Array(mesh.count * 3);
  for (let i = 0; i < mesh.count; ++i) sourceOf(table, features.getX(i)).toArray(colours, i * 3);
  mesh.instanceColor = new InstancedBufferAttribute(colours, 3);
  mesh.material = plain(mesh, "white");
}
