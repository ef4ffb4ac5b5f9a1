// Opens the page of a run in headless Chromium, and looks at what it draws. Functions run in the page as they are written here, under the
// page's own policy of what may run.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { after, beforeEach } from "node:test";
import { chromium, devices } from "playwright-core";

const SIZE = { width: 760, height: 360 };

/** Answers with the page's own files from the folder PAGE_FILES, if it is given, instead of those that the program holds. */
export async function serveFiles(page) {
  const folder = process.env.PAGE_FILES;
  if (!folder) return;
  const fulfill = (name) => (route) => route.fulfill({ path: `${folder}/${name}` });
  await page.route(/^[^?#]*:\d+\/([?#].*)?$/, fulfill("index.html"));
  for (const name of ["viewer.js", "style.css"]) await page.route(`**/page/${name}`, fulfill(name));
}

/** What a page needs for tests: Playwright's page, the requests it made, and its errors. */
export class OpenPage {
  /** Starts a browser without a page in it. A browser draws the page in front alone, so each page has its own. */
  static async start(options = {}) {
    const browser = await chromium.launch({
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
    const device = options.isPhone ? { ...devices["Pixel 5"], deviceScaleFactor: 1 } : { viewport: options.size ?? SIZE };
    const context = await browser.newContext({ ...device, acceptDownloads: true });
    const page = await context.newPage();
    await serveFiles(page);
    const opened = new OpenPage(browser, page);
    page.setDefaultTimeout(options.timeout_ms ?? 240_000);
    return opened;
  }

  static async open(url, options) {
    const opened = await OpenPage.start(options), { page } = opened;
    // few pixels and few triangles: there is no graphics card
    await page.goto(url.includes("#") ? url : `${url}#detail=20`);
    await page.waitForFunction(() => window.citykiln);
    await opened.still();
    return opened;
  }

  constructor(browser, page) {
    Object.assign(this, { browser, page, requests: [], errors: [] });
    page.on("response", (response) => this.requests.push(response));
    page.on("pageerror", (error) => this.errors.push(error.message));
    page.on("console", (message) => message.type() === "error" && this.errors.push(message.text()));
  }

  close() {
    return this.browser.close();
  }

  /** Waits until all that the camera sees is loaded and drawn. */
  async still() {
    await this.page.evaluate(() => window.citykiln.changed());
    await this.page.waitForFunction(() => window.citykiln.isStill, null, { polling: 100 });
  }

  /** The sum of the bytes of all answers, and their number. */
  async loaded() {
    const sizes = await Promise.all(this.requests.map((response) => response.body().then((body) => body.length, () => 0)));
    return { requests: sizes.length, bytes: sizes.reduce((a, b) => a + b, 0) };
  }

  /** Where the camera is and looks. */
  camera() {
    return this.page.evaluate(() => {
      const { camera, moves } = window.citykiln;
      return { at: camera.position.toArray(), heading: moves.heading, pitch: moves.pitch, mode: moves.mode };
    });
  }

  /** Puts the camera above the ground of a place, whose tile is loaded when it is near. */
  async put(x, y, above_m, heading, pitch) {
    for (let i = 0; i < 2; ++i) {
      await this.page.evaluate(([x, y, above_m, heading, pitch]) => {
        const { camera, moves, page, rays } = window.citykiln;
        camera.position.set(x, y, (rays.groundAt(x, y) ?? page.ground_m) + above_m);
        moves.look(heading, pitch);
        moves.stand();
      }, [x, y, above_m, heading, pitch]);
      await this.still();
    }
  }

  /** The picture of the scene: rows of [r, g, b], 0 to 255, every `step`-th pixel. */
  async picture(step = 2) {
    await this.still();
    return this.page.evaluate((step) => {
      const from = document.getElementById("scene");
      const to = Object.assign(document.createElement("canvas"), { width: from.width, height: from.height });
      const context = to.getContext("2d", { willReadFrequently: true });
      context.drawImage(from, 0, 0);
      const { data } = context.getImageData(0, 0, to.width, to.height);
      const pixels = [];
      for (let y = 0; y < to.height; y += step)
        for (let x = 0; x < to.width; x += step) pixels.push([...data.subarray(4 * (y * to.width + x), 4 * (y * to.width + x) + 3)]);
      return pixels;
    }, step);
  }

  text(selector) {
    return this.page.locator(selector).innerText();
  }
}

/** Opens the page PAGE_URL for the tests of a file, each of which begins with nothing picked, and closes it after them. */
export async function openForTests(options) {
  const open = await OpenPage.open(process.env.PAGE_URL, options);
  beforeEach(async () => {
    await open.page.keyboard.press("Escape");
    if (await open.page.isVisible("#close-feature")) await open.page.click("#close-feature");
  });
  after(() => open.close());
  return open;
}

/** The faults that axe finds in what the page shows: [impact, rule, number of elements, the first of them]. */
export async function axeFaults({ page }) {
  const source = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const session = await page.context().newCDPSession(page);
  // the page's policy keeps other scripts out; the debugger's do not count
  await session.send("Runtime.evaluate", { expression: source });
  const expression = "axe.run().then(({ violations }) => JSON.stringify(violations.map(({ id, impact, nodes }) => [impact, id, nodes.length, nodes[0].html.slice(0, 90)])))";
  const { result } = await session.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
  const found = JSON.parse(result.value);
  console.log(`# axe: ${found.map((each) => each.slice(0, 3).join(" ")).join("; ") || "nothing"}`);
  return found;
}

export const isSerious = ([impact]) => impact === "serious" || impact === "critical";

/** The share of pixels that differ between two pictures by more than a few steps of 255. */
export function changedShare(before, after) {
  const differs = (a, b) => Math.max(...a.map((c, i) => Math.abs(c - b[i]))) > 8;
  return before.filter((pixel, i) => differs(pixel, after[i])).length / before.length;
}

/** The share of pixels for which a function is true. */
export const shareOf = (picture, is) => picture.filter(is).length / picture.length;

export const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
export const meanLuminance = (picture) => picture.reduce((sum, pixel) => sum + luminance(pixel), 0) / picture.length;

/** True for pixels of the picked feature, which is drawn in magenta over its own colour. */
export const isPicked = ([r, g, b]) => r > g + 60 && b > g + 40;

export const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
