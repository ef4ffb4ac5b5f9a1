// import_three.mjs JOB.json: loads .glb files with three.js in headless Chromium, writes facts about them and pictures. The form of a
// job is in readers.py.
import { createServer } from "node:http";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
const job = JSON.parse(readFileSync(process.argv[2]));
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".glb": "model/gltf-binary" };

// serves the page, three.js, and the folders of the job's files by their number
const server = createServer((request, response) => {
  const match = /^\/file\/(\d+)\/(.+)$/.exec(request.url);
  // files beside a tile that it refers to (compile --layout shared)
  const path = match ? join(dirname(job.files[Number(match[1])]), decodeURIComponent(match[2])) : join(here, request.url);
  if (!existsSync(path)) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
}).listen(0, "127.0.0.1");

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage();
page.setDefaultTimeout(0);
page.on("console", (message) => console.log(message.type(), message.text()));
page.on("pageerror", (error) => console.log("error", error.message));
await page.goto(`http://127.0.0.1:${server.address().port}/import_three.html`);
await page.waitForFunction("window.ready");

const facts = [];
for (let i = 0; i < job.files.length; ++i) facts.push(await page.evaluate((url) => window.load(url), `/file/${i}/${basename(job.files[i])}`));
for (const picture of job.pictures) {
  const url = await page.evaluate(([picture, sun]) => window.draw(picture, sun), [picture, job.sun]);
  writeFileSync(picture.out, Buffer.from(url.split(",")[1], "base64"));
}
// the draw calls and triangles of the last picture
for (const each of facts.slice(-1)) each.drawn = await page.evaluate("window.drawn()");
writeFileSync(job.facts, JSON.stringify(facts));
await browser.close();
server.close();
