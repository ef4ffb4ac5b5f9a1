// Shows and hides layers.
import { byId, make } from "./dom.js";
import { LAYERS } from "./tileset.js";

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
    return make("label", { htmlFor: input.id }, input, name);
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
