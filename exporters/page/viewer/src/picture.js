// Saves the picture of the scene as a PNG file.
import { make, say } from "./dom.js";

/** @param {Function} draw Draws the scene; the picture is read before the browser clears it. */
export function savePicture(canvas, draw, name) {
  draw();
  canvas.toBlob((blob) => {
    const link = make("a", { href: URL.createObjectURL(blob), download: `${name}.png` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    say(`Saved ${link.download}, ${canvas.width} by ${canvas.height} pixels.`);
  }, "image/png");
}
