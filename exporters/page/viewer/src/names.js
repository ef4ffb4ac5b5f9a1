// The language that names are shown in: that of the place, or English where the map has it.
import { byId } from "./dom.js";

export class Names {
  /** @param {Function} changed Called when another language is chosen. */
  constructor(changed) {
    this.changed = changed;
    byId("names").addEventListener("change", changed);
  }

  /** "local" or "en". */
  get language() {
    return byId("names").value;
  }

  set(language) {
    if (language === this.language || !["local", "en"].includes(language)) return;
    byId("names").value = language;
    this.changed();
  }

  /** Returns the name to show of a record; undefined if it has none. */
  of({ name, tags = {} }) {
    return (this.language === "en" && (tags["name:en"] || tags.int_name)) || name;
  }
}
