// draw_page.mjs JOB.json: opens a page of exporters/gltf/howto in headless Chromium, looks from the job's camera, waits until
// all is loaded, and writes a picture. A job: `folder` (the root of the server), `page`, `eye`, `look` (metres east, north and
// up of the origin), `fov_deg` (vertical), `size`, `out`. Pages have `ready` and `lookFrom(eye, look, fov_deg)`, which returns
// when the view is drawn.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const job = JSON.parse(readFileSync(process.argv[2]));
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm" };
const server = createServer((request, response) => {
  const path = join(job.folder, normalize(decodeURIComponent(request.url.split("?")[0])));
  if (!existsSync(path)) response.writeHead(404).end();
  else response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
}).listen(0, "127.0.0.1");

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: job.size[0], height: job.size[1] } });
page.setDefaultTimeout(0);
page.on("console", (message) => { if (message.type() === "error") console.error(message.text()); });
page.on("pageerror", (error) => { console.error(error.message); process.exit(1); });
await page.goto(`http://127.0.0.1:${server.address().port}/${job.page}`);
await page.waitForFunction("window.ready");
await page.evaluate((job) => window.lookFrom(job.eye, job.look, job.fov_deg), job);
await page.screenshot({ path: job.out });
await browser.close();
server.close();
