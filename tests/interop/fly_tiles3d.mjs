// fly_tiles3d.mjs JOB.json: loads a tileset with CesiumJS or 3DTilesRendererJS in headless Chromium, from each view of a job in turn, and
// writes a picture of it and what was loaded. A job: {"page": "fly_three.html", "folder": the folder of tileset.json, "size": [width,
// height], "error_px": largest error on the picture, "views": [{"eye": [x, y, z], "look": [x, y, z], "out": file.png}], "facts": file.json}.
// Places are metres in the frame of the tileset's root.
import { createServer } from "node:http";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
const job = JSON.parse(readFileSync(process.argv[2]));
const types = {
  ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".css": "text/css",
  ".json": "application/json", ".glb": "model/gltf-binary",
};

let bytes = 0;
const server = createServer((request, response) => {
  const url = normalize(decodeURIComponent(request.url.split("?")[0]));
  const path = url.startsWith("/tiles/") ? join(job.folder, url.slice(7)) : join(here, url);
  if (!existsSync(path)) {
    response.writeHead(404).end();
    return;
  }
  const body = readFileSync(path);
  if (url.startsWith("/tiles/")) bytes += body.length;
  response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(body);
}).listen(0, "127.0.0.1");

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: job.size[0], height: job.size[1] } });
page.setDefaultTimeout(0);
const errors = [];
page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
page.on("pageerror", (error) => errors.push(error.message));
await page.goto(`http://127.0.0.1:${server.address().port}/${job.page}`);
await page.waitForFunction("window.ready");
await page.evaluate(([url, transform, px]) => window.open_tileset(url, transform, px),
  ["/tiles/tileset.json", JSON.parse(readFileSync(join(job.folder, "tileset.json"))).root.transform, job.error_px]);

const facts = { views: [], errors };
for (const view of job.views) {
  const { url, ...loaded } = await page.evaluate((v) => window.show(v), view);
  writeFileSync(view.out, Buffer.from(url.split(",")[1], "base64"));
  facts.views.push({ ...loaded, bytes });
}
writeFileSync(job.facts, JSON.stringify(facts));
await browser.close();
server.close();
