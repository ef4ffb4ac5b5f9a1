// first_view.mjs URL PICTURE: opens the page of a run or a manifest once, then walks in the named street nearest to the map's middle, and prints of
// both views, when they were whole: seconds, requests, MB on the wire, draw calls and triangles of the picture. For first_view.py; not a test.
import { chromium } from "playwright-core";
import { serveFiles } from "./open_page.mjs";

const [url, picture] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 760, height: 360 } });
await serveFiles(page);
const session = await page.context().newCDPSession(page);
await session.send("Network.enable");
let bytes = 0, requests = 0;
session.on("Network.loadingFinished", ({ encodedDataLength }) => {
  bytes += encodedDataLength;
  ++requests;
});

const costs = async () => ({ requests, mb: bytes / 1e6, ...(await page.evaluate(() => (({ calls, triangles }) => ({ calls, triangles }))(window.citykiln.renderer.info.render))) });
const isStill = () => page.waitForFunction(() => window.citykiln.sky.environment && window.citykiln.isStill, null, { polling: 20, timeout: 600_000 });

const begin = performance.now();
await page.goto(`${url}#detail=20`);
await page.waitForFunction(() => window.citykiln && window.citykiln.tileset.loaded.size > 0, null, { polling: 20 });
const first_tile_s = (performance.now() - begin) / 1000;
await isStill();
const first = { first_tile_s, whole_s: (performance.now() - begin) / 1000, ...(await costs()) };
await page.screenshot({ path: `${picture}.png` });

const street = await page.evaluate(async () => {
  const { limits: { west, east, south, north }, records } = window.citykiln;
  const far = ([, , , x, y]) => Math.hypot(x - (west + east) / 2, y - (south + north) / 2);
  return (await records.names()).filter(([, , kind]) => /(Road|Street)$/.test(kind)).sort((a, b) => far(a) - far(b))[0];
});
const asked = performance.now();
await page.evaluate(async ([, id]) => {
  const { records } = window.citykiln;
  await window.citykiln.goToFeature(id, await records.find(id));
  window.citykiln.setMode("walk");
}, street);
await isStill();
const second = { street: street[0], whole_s: (performance.now() - asked) / 1000, ...(await costs()) };
await page.screenshot({ path: `${picture}_street.png` });
console.log(JSON.stringify({ first, street: second }));
await browser.close();
