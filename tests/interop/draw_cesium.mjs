// draw_cesium.mjs FOLDER PAGE OUT.png: opens a page of a folder in headless Chromium, waits until CesiumJS has loaded all tiles of the view,
// and writes a picture of 960 by 540 pixels.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const [folder, name, out] = process.argv.slice(2);
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm" };
const server = createServer((request, response) => {
  const path = join(folder, normalize(decodeURIComponent(request.url.split("?")[0])));
  if (!existsSync(path)) response.writeHead(404).end();
  else response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
}).listen(0, "127.0.0.1");

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 960, height: 540 } });
page.setDefaultTimeout(0);
page.on("console", (message) => { if (message.type() === "error") console.error(message.text()); });
await page.goto(`http://127.0.0.1:${server.address().port}/${name}`);
await page.waitForFunction("window.ready");
await page.evaluate(async () => {
  const { primitives } = window.viewer.scene;
  const is_loaded = () => [...Array(primitives.length).keys()].every((i) => primitives.get(i).tilesLoaded !== false);
  for (let still = 0; still < 10; still = is_loaded() ? still + 1 : 0) await new Promise((done) => setTimeout(done, 500));
});
await page.screenshot({ path: out });
await browser.close();
server.close();
