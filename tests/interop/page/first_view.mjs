// first_view.mjs URL: opens the page of a run or a manifest once, and prints when its first view was whole: seconds from the request for the
// page, requests, MB on the wire, and the requests that took longest. For first_view.py; not a test.
import { chromium } from "playwright-core";

const [url, started = "0"] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 760, height: 360 } });
const session = await page.context().newCDPSession(page);
await session.send("Network.enable");
let bytes = 0, requests = 0;
session.on("Network.loadingFinished", ({ encodedDataLength }) => {
  bytes += encodedDataLength;
  ++requests;
});
const begin = performance.now();
await page.goto(`${url}#detail=20`);
await page.waitForFunction(() => window.citykiln && window.citykiln.tileset.loaded.size > 0, null, { polling: 20 });
const first_s = (performance.now() - begin) / 1000;
await page.waitForFunction(() => window.citykiln.sky.environment && window.citykiln.tileset.isWhole && window.citykiln.isStill, null, { polling: 20 });
const whole_s = (performance.now() - begin) / 1000;
const slowest = await page.evaluate(() => performance.getEntriesByType("resource").map((e) => [e.name.replace(/^.*\/\/[^/]*\//, ""), Math.round(e.duration)])
  .sort((a, b) => b[1] - a[1]).slice(0, 6));
if (process.argv[4]) await page.screenshot({ path: process.argv[4] });
console.log(JSON.stringify({ first_tile_s: first_s, whole_s, requests, mb: bytes / 1e6, slowest }));
await browser.close();
