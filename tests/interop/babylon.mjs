// babylon.mjs FOLDER JOB.json: serves a folder with babylon.html, opens it in headless Chromium, and prints facts as JSON: what is drawn from
// places, how far a walker gets, levels, light. The job: { run, eyes: [[x, y, z]...], looks, walks: [[x, y, turn]...], start, pictures }.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";

const [folder, jobPath] = process.argv.slice(2), job = JSON.parse(readFileSync(jobPath));
const types = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json" };
const server = createServer((request, response) => {
  const path = join(folder, decodeURIComponent(request.url.split("?")[0]));
  if (!existsSync(path)) return response.writeHead(404).end();
  return response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
}).listen(0, "127.0.0.1");
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 480, height: 270 } });
page.setDefaultTimeout(0);
page.on("pageerror", (error) => console.error(error.message));
await page.goto(`http://127.0.0.1:${server.address().port}/babylon.html?run=${job.run}`);
await page.waitForFunction("window.ready");
// frames are drawn when they are asked for: Chromium draws in software here
await page.evaluate(() => {
  scene.getEngine().stopRenderLoop();
  window.instruments = new BABYLON.SceneInstrumentation(scene);
  window.settle = async () => {
    city.update();
    while (!city.isSettled) await new Promise((resolve) => setTimeout(resolve, 20)), city.update();
  };
});

const facts = { views: [], walks: [] };
await page.evaluate((hour) => window.city.setHour(hour), job.hour ?? 11);
for (const [i, eye] of job.eyes.entries()) {
  facts.views.push(await page.evaluate(async ([eye, look]) => {
    const camera = scene.activeCamera;
    camera.position.set(eye[0], eye[2] + city.report.sky.ground_m, -eye[1]);
    camera.setTarget(new BABYLON.Vector3(look[0], look[2] + city.report.sky.ground_m, -look[1]));
    camera.computeWorldMatrix(true);
    await settle();
    await scene.whenReadyAsync();
    scene.render();
    scene.render();
    const levels = city.tiles.map((tile) => [tile.distance(camera.position), tile.shown]);
    return { counts: city.counts, drawn: instruments.drawCallsCounter.current, levels };
  }, [eye, job.looks[i]]));
  if (job.pictures[i]) await page.screenshot({ path: job.pictures[i] });
}
for (const [x, y, turn] of job.walks) {
  facts.walks.push(await page.evaluate(async ([x, y, turn]) => {
    const eyes = walker.camera.position;
    eyes.set(x, city.report.sky.ground_m, -y);
    walker.camera.rotation.set(0, turn, 0);
    walker.camera.computeWorldMatrix(true);
    walker.stands = false;
    await settle();
    while (city.groundAt(eyes) === undefined) await new Promise((resolve) => setTimeout(resolve, 20)), city.update();
    walker.land();
    const from = eyes.clone(), direction = new BABYLON.Vector3(Math.sin(turn), 0, Math.cos(turn));
    const chest = () => eyes.add(new BABYLON.Vector3(0, -0.5, 0));
    let least_m = Infinity, highest_m = 0, crossed = 0;
    for (let i = 0; i < 400; ++i) {
      const before = chest();
      walker.step(0.1, 0);
      const step = chest().subtract(before);
      if (step.length() > 1e-3 && city.hit(before, step.normalizeToNew(), step.length())) ++crossed;
      least_m = Math.min(least_m, city.hit(chest(), direction, 5)?.distance ?? 5);
      highest_m = Math.max(highest_m, Math.abs(eyes.y - 1.7 - city.groundAt(eyes)));
    }
    return { went: Math.hypot(eyes.x - from.x, eyes.z - from.z), least_m, highest_m, crossed };
  }, [x, y, turn]));
}
facts.light = await page.evaluate(() => [11, 23].map((hour) => {
  city.setHour(hour);
  city.update();
  const shining = scene.materials.filter((material) => material.emissiveTexture || material.emissiveColor?.toLuminance() > 0);
  return { night: city.isNight, sun: city.sun.isEnabled() ? city.sun.intensity : 0, shining: shining.length, emission: Math.max(0, ...shining.map((m) => m.emissiveIntensity)),
    lamps: city.lamps.filter((lamp) => lamp.isEnabled()).length };
}));
console.log(JSON.stringify(facts));
await browser.close();
server.close();
