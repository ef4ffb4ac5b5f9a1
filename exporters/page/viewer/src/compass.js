// The compass, which turns the view to the north, and the bar of the scale in the middle of the picture.
import { byId } from "./dom.js";

const MOST_PX = 120;
/** Lengths of the bar, in metres, are these times a power of ten. */
const STEPS = [5, 2, 1];
/** A view flatter than this has no scale. */
const LEAST_PITCH = -0.1;

/** Returns the longest round length that is not longer than a given one. */
export function roundLength(most_m) {
  const power = 10 ** Math.floor(Math.log10(most_m));
  return power * STEPS.find((step) => step * power <= most_m);
}

const textOf = (length_m) => (length_m >= 1000 ? `${length_m / 1000} km` : `${length_m} m`);

export class Compass {
  constructor(moves) {
    this.moves = moves;
    byId("compass").addEventListener("click", () => moves.look(0, moves.pitch));
  }

  update() {
    const { heading, pitch, above_m, radiansPerPixel } = this.moves;
    byId("needle").style.transform = `rotate(${(-heading).toFixed(3)}rad)`;
    const isFlat = pitch > LEAST_PITCH;
    byId("scale").hidden = isFlat;
    if (isFlat) return;
    const length_m = roundLength((above_m / -Math.sin(pitch)) * radiansPerPixel * MOST_PX);
    byId("scale-bar").style.width = `${(length_m / ((above_m / -Math.sin(pitch)) * radiansPerPixel)).toFixed(1)}px`;
    byId("scale-text").textContent = textOf(length_m);
  }
}
