// Shows and hides layers.
import { byId, make } from "./dom.js";
import { LAYERS } from "./tileset.js";

/** The name of a layer for readers, which is that of the setting --layers. */
const nameOf = (layer) => (layer === "props" ? "things" : layer);

/**
 * Returns the layers that a list hides, in the form of --layers: "ground,roads" keeps these alone, "-plants" hides one.
 * Unknown names do nothing; a list without known names hides nothing.
 */
export function hiddenBy(list) {
  const names = list.split(",").map((name) => name.trim());
  const isNamed = (layer, sign) => names.includes(sign + nameOf(layer)) || names.includes(sign + layer);
  const kept = LAYERS.filter((layer) => isNamed(layer, ""));
  return LAYERS.filter((layer) => isNamed(layer, "-") || (kept.length > 0 && !kept.includes(layer)));
}

export class Layers {
  constructor(tileset, changed) {
    this.tileset = tileset;
    this.hidden = new Set();
    this.changed = changed;
    for (const name of LAYERS) byId("layers").append(this.box(name));
  }

  box(name) {
    const input = make("input", { type: "checkbox", checked: true, id: `layer-${name}` });
    input.addEventListener("change", () => this.set(name, input.checked));
    return make("label", { htmlFor: input.id }, input, nameOf(name));
  }

  set(name, isShown) {
    byId(`layer-${name}`).checked = isShown;
    if (isShown) this.hidden.delete(name);
    else this.hidden.add(name);
    for (const tile of this.tileset.loaded.values()) this.apply(tile);
    this.changed();
  }

  apply(tile) {
    for (const mesh of tile.meshes) mesh.visible = !this.hidden.has(mesh.userData.layer);
  }
}
