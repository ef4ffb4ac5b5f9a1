// The bar that says what is loading: parts of the page's data by name, then tiles by number.
import { byId } from "./dom.js";

export class Progress {
  constructor() {
    this.steps = new Set();
    this.most = 0;
    this.shown = "";
  }

  /** Shows a step's name until a promise ends, and returns the promise. */
  async during(name, promise) {
    this.steps.add(name);
    this.show();
    try {
      return await promise;
    } finally {
      this.steps.delete(name);
      this.show();
    }
  }

  /** Counts the tiles that are not there yet; the bar grows until none is left. */
  tiles({ queued, downloading, parsing }) {
    const left = queued + downloading + parsing;
    this.most = left === 0 ? 0 : Math.max(this.most, left);
    this.left = left;
    this.show();
  }

  text() {
    if (this.most > 0) return `Loading tiles: ${this.most - this.left} of ${this.most}`;
    return this.steps.size > 0 ? `Loading ${[...this.steps].join(", ")}` : "";
  }

  show() {
    const text = this.text();
    if (text === this.shown) return;
    this.shown = text;
    byId("loading").hidden = text === "";
    byId("loading-text").textContent = text;
    const bar = byId("loading-bar");
    if (this.most > 0) bar.value = (this.most - this.left) / this.most;
    else bar.removeAttribute("value");
  }
}
