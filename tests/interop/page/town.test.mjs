// The page of the example town: every function by clicks and keys. Each test asserts what changed in the scene or in its picture.
// PAGE_URL is the server of `citykiln view`, PAGE_STATIC a static server of the same folder; see page_test.py.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { OpenPage, changedShare, distance, isPicked, luminance, meanLuminance, shareOf, openForTests } from "./open_page.mjs";

const url = process.env.PAGE_URL;
const open = await openForTests(), { page } = open;

/** A name of the program, such as "TertiaryRoad", as the page writes it, but for capitals. */
const inWords = (name) => name.replace(/([a-z\d])(?=[A-Z])/g, "$1 ").replaceAll("_", " ").toLowerCase();

/** A view over the old town, with houses in the middle of the picture. */
const overTown = () => open.put(0, -160, 70, 0, -0.45);
const middle = async () => {
  const box = await page.locator("#scene").boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

test("the town is loaded within 25 requests and 7 MB", async () => {
  const fresh = await OpenPage.open(url);
  const { requests, bytes } = await fresh.loaded();
  const shown = await fresh.page.evaluate(() => window.citykiln.tileset.shown.length);
  console.log(`# town: ${requests} requests, ${(bytes / 1e6).toFixed(2)} MB, ${shown} tiles shown`);
  assert.ok(requests <= 25 && bytes <= 7e6, `${requests} requests, ${bytes} bytes`);
  const picture = await fresh.picture();
  assert.ok(shareOf(picture, ([r, g, b]) => g > b + 12 && g > r - 5) > 0.05, "no grass in the picture");
  assert.deepEqual(fresh.errors, []);
  await fresh.close();
});

test("W flies ahead, K looks down", async () => {
  await overTown();
  const before = await open.camera(), picture = await open.picture();
  await page.focus("#scene");
  await page.keyboard.down("w");
  await page.waitForFunction((y) => window.citykiln.camera.position.y > y + 5, before.at[1]);
  await page.keyboard.up("w");
  const flown = await open.camera();
  // ahead is north and down, in the direction of the view
  assert.ok(flown.at[2] < before.at[2] - 1);
  assert.ok(Math.abs(flown.at[0] - before.at[0]) < 0.5);
  await page.keyboard.down("k");
  await page.waitForFunction((pitch) => window.citykiln.moves.pitch < pitch - 0.1, flown.pitch);
  await page.keyboard.up("k");
  assert.ok(changedShare(picture, await open.picture()) > 0.3);
});

test("a mouse drag turns, the wheel moves along the view", async () => {
  await overTown();
  const before = await open.camera(), [x, y] = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
  await page.mouse.up();
  const turned = await open.camera();
  assert.ok(turned.heading < before.heading - 0.05, "dragged to the right, the view turns to the left");
  assert.equal(await page.isVisible("#feature"), false, "a drag picks nothing");
  await page.mouse.wheel(0, -100);
  await open.still();
  assert.ok(distance((await open.camera()).at, turned.at) > 1);
});

test("a walker's eyes stay 1.7 m above the floor", async () => {
  await overTown();
  await page.click("#walk");
  await open.still();
  const above = () => page.evaluate(() => {
    const { camera, rays } = window.citykiln;
    return camera.position.z - rays.floorBelow(camera.position);
  });
  assert.ok(Math.abs((await above()) - 1.7) < 0.01);
  const before = (await open.camera()).at;
  await page.focus("#scene");
  await page.keyboard.down("w");
  await page.waitForFunction(([x, y]) => Math.hypot(window.citykiln.camera.position.x - x, window.citykiln.camera.position.y - y) > 3, before);
  await page.keyboard.up("w");
  assert.ok(Math.abs((await above()) - 1.7) < 0.01);
  await page.click("#fly");
});

test("goes to a latitude and longitude", async () => {
  await page.fill("#place", "48.7000, 12.3000");
  await page.keyboard.press("Enter");
  await open.still();
  // the origin of the town's plane is at 48.70, 12.30
  const { at } = await open.camera();
  assert.ok(Math.hypot(at[0], at[1]) < 130, String(at));
});

test("goes to an OSM id, and shows its class and tags", async () => {
  const { id, record } = await aBuilding();
  await page.fill("#place", `way ${id.slice(1)}`);
  await page.click("#go button");
  await page.waitForSelector("#feature:not([hidden])");
  await open.still();
  const { at } = await open.camera();
  assert.ok(Math.hypot(at[0] - record.at[0], at[1] - record.at[1]) < 2 * record.size_m + 80);
  assert.ok(shareOf(await open.picture(1), isPicked) > 0.002, "the building is not marked in the picture");
  const text = await open.text("#feature-text");
  for (const word of [record.class, "building", record.recipe.style, record.recipe.roof]) assert.ok(text.toLowerCase().includes(inWords(word)), `${word} is not in: ${text}`);
});

test("goes to a name", async () => {
  const [name, id] = await page.evaluate(() => window.citykiln.records.names().then((names) => names.find(([name, id]) => id[0] === "w" && names.filter((row) => row[0].includes(name)).length === 1)));
  await page.fill("#place", name);
  await page.click("#go button");
  await page.waitForFunction((id) => window.citykiln.panel.id === id && !document.getElementById("feature").hidden, id);
  assert.equal(await open.text("#feature-title"), name);
});

test("says so if the run has no such element", async () => {
  await page.fill("#place", "w999999999");
  await page.click("#go button");
  await page.waitForFunction(() => document.getElementById("status").textContent.includes("no element w999999999"));
});

/** A building with a recipe, from the records. */
async function aBuilding() {
  return page.evaluate(async () => {
    const { page, records } = window.citykiln;
    for (let file = 0; file < page.feature_files; ++file) {
      const all = await records.fetchOnce(`page/features/${file}.json`);
      const found = Object.entries(all).find(([id, record]) => id[0] === "w" && record.recipe?.storeys >= 2 && record.recipe.corners === 4 && record.assumed && record.size_m > 12);
      if (found) return { id: found[0], record: found[1] };
    }
    throw new Error("no building");
  });
}

test("a click picks what is there: tags, recipe, what is assumed", async () => {
  const { record } = await aBuilding();
  await open.put(record.at[0], record.at[1] - 0.1, 60, 0, -1.5);
  const [x, y] = await middle();
  await page.mouse.click(x, y);
  await page.waitForSelector("#feature:not([hidden])");
  await open.still();
  const text = await open.text("#feature-text");
  for (const word of [record.class, "Tags", "building", "Recipe", "storeys", "Assumed", record.assumed[0], "Findings"])
    assert.ok(text.toLowerCase().includes(inWords(word)), `${word} is not in: ${text}`);
  assert.ok(shareOf(await open.picture(1), isPicked) > 0.005);
  await page.click("#close-feature");
  assert.equal(shareOf(await open.picture(1), isPicked), 0);
});

test("a layer goes and comes back", async () => {
  await overTown();
  const before = await open.picture();
  for (const layer of ["buildings", "plants", "ground"]) {
    await page.uncheck(`#layer-${layer}`);
    const without = await open.picture();
    const share = changedShare(before, without);
    console.log(`# without ${layer}: ${(share * 100).toFixed(1)} % of the picture differ`);
    assert.ok(share > 0.02, `${layer}: ${share}`);
    assert.ok(await page.evaluate((layer) => window.citykiln.tileset.shown.every((tile) => tile.meshes.every((mesh) => mesh.visible === (mesh.userData.layer !== layer))), layer));
    await page.check(`#layer-${layer}`);
    assert.equal(changedShare(before, await open.picture()), 0);
  }
});

const near = (hex) => {
  const own = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
  // shading changes the lightness, so directions of colours are compared
  const unit = (c) => c.map((v) => v / (Math.hypot(...c) || 1));
  return (pixel) => luminance(pixel) > 12 && distance(unit(pixel), unit(own)) < 0.12;
};

for (const mode of ["level", "error", "source"])
  test(`colours by ${mode} are those of the legend`, async () => {
    await overTown();
    const before = await open.picture();
    await page.selectOption("#colours", mode);
    const picture = await open.picture();
    const rows = await page.evaluate(() => window.citykiln.colours.rows());
    assert.equal(await page.locator("#legend li").count(), rows.length);
    const used = rows.filter(([hex]) => shareOf(picture, near(hex)) > 0.01).map(([, text]) => text);
    console.log(`# ${mode}: ${used.join("; ")}`);
    assert.ok(changedShare(before, picture) > 0.5);
    assert.ok(used.length >= (mode === "source" ? 2 : 1), used.join());
    if (mode === "source") assert.deepEqual(used.slice(0, 2), ["mapped", "something is assumed"]);
    await page.selectOption("#colours", "none");
    assert.equal(changedShare(before, await open.picture()), 0, "the materials come back");
  });

test("legends keep apart for the colour-blind", async () => {
  // Viénot, Brettel and Mollon 1999, on linear light
  const blind = { deuteranopia: [[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]], protanopia: [[0.11238, 0.88762, 0], [0.11238, 0.88762, 0], [0.00401, -0.00401, 1]] };
  const linear = (hex) => [1, 3, 5].map((i) => (parseInt(hex.slice(i, i + 2), 16) / 255) ** 2.2);
  const lightness = (rgb) => 116 * Math.cbrt(Math.max(luminance(rgb), 0)) - 16;
  for (const mode of ["level", "error", "source"]) {
    await page.selectOption("#colours", mode);
    const hexes = (await page.evaluate(() => window.citykiln.colours.rows())).map(([hex]) => hex);
    for (const matrix of Object.values(blind)) {
      const seen = hexes.map(linear).map((c) => lightness(matrix.map((row) => row.reduce((sum, m, i) => sum + m * c[i], 0)))).sort((a, b) => a - b);
      const steps = seen.slice(1).map((value, i) => value - seen[i]);
      assert.ok(Math.min(...steps) > 5, `${mode}: lightness ${seen.map((v) => v.toFixed(0))}`);
    }
  }
  await page.selectOption("#colours", "none");
});

test("a finding is flown to, marked and explained", async () => {
  const finding = await page.evaluate(() => window.citykiln.findings.all.find(({ geometry, properties }) => geometry && properties.id));
  await page.selectOption("#finding-code", finding.properties.code);
  await page.click("#findings li button");
  await open.still();
  const [target, at] = await page.evaluate(() => {
    const { findings, camera } = window.citykiln;
    return [findings.place(findings.some[0]).toArray(), camera.position.toArray()];
  });
  assert.ok(distance(target, at) < 70, `${distance(target, at)} m away`);
  const mark = await page.evaluate(() => {
    const { findings, camera } = window.citykiln;
    return findings.place(findings.some[0]).project(camera).toArray();
  });
  assert.ok(Math.abs(mark[0]) < 0.3 && Math.abs(mark[1]) < 0.3, "the finding is in the middle of the picture");
  await page.selectOption("#finding-code", "none");
  const without = await open.picture(1);
  await page.selectOption("#finding-code", finding.properties.code);
  assert.ok(changedShare(without, await open.picture(1)) > 0, "no mark in the picture");
  await page.selectOption("#finding-code", "");
});

test("midnight is dark, noon is bright, and the page says how to get lit windows", async () => {
  await overTown();
  const options = await page.locator("#time option").allInnerTexts();
  const byLabel = (label) => page.selectOption("#time", { label: options.find((text) => text.startsWith(label)) });
  await byLabel("12:00");
  const noon = await open.picture();
  await byLabel("00:00");
  const midnight = await open.picture();
  console.log(`# mean luminance at noon ${meanLuminance(noon).toFixed(0)}, at midnight ${meanLuminance(midnight).toFixed(0)} of 255`);
  assert.ok(meanLuminance(noon) > 70 && meanLuminance(midnight) < 40);
  assert.match(await open.text("#time-note"), /--time/);
  await page.selectOption("#time", { label: options.find((text) => text.includes("the run's time")) });
});

test("measures a distance and a height", async () => {
  const { record } = await aBuilding();
  await open.put(record.at[0], record.at[1] - record.size_m / 2 - 40, 50, 0, -0.8);
  await page.click("#measure");
  const before = await open.picture(1), [x, y] = await middle();
  const places = [];
  for (const [dx, dy] of [[-60, 60], [40, -10]]) {
    places.push(await page.evaluate(([px, py]) => {
      const canvas = document.getElementById("scene");
      return window.citykiln.rays.at((px / canvas.clientWidth) * 2 - 1, 1 - (py / canvas.clientHeight) * 2).point.toArray();
    }, [x + dx, y + dy]));
    await page.mouse.click(x + dx, y + dy);
    await page.waitForFunction((n) => window.citykiln.measure.points.length === n, places.length);
  }
  const text = await open.text("#measured");
  const [far, flat, height] = text.match(/-?[\d.]+(?= m)/g).map(Number);
  assert.ok(Math.abs(far - distance(...places)) < 0.06, text);
  assert.ok(Math.abs(height - (places[1][2] - places[0][2])) < 0.06, text);
  assert.ok(Math.abs(Math.hypot(flat, height) - far) < 0.1, text);
  assert.ok(changedShare(before, await open.picture(1)) > 0.0003, "no line in the picture");
  await page.click("#measure");
  assert.equal(changedShare(before, await open.picture(1)), 0, "the line goes");
});

test("saves the picture that is seen", async () => {
  await overTown();
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#picture")]);
  const bytes = await readFile(await download.path());
  const size = await page.evaluate(() => [document.getElementById("scene").width, document.getElementById("scene").height]);
  assert.equal(bytes.toString("latin1", 1, 4), "PNG");
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], size);
  assert.ok(bytes.length > 30_000, `${bytes.length} bytes`);
});

test("a link leads to the same view", async () => {
  await overTown();
  await page.uncheck("#layer-plants");
  await page.selectOption("#colours", "level");
  const picture = await open.picture(), camera = await open.camera();
  await page.click("#link");
  const other = await OpenPage.open(page.url());
  const found = await other.camera();
  assert.ok(distance(found.at, camera.at) < 0.02);
  const share = changedShare(picture, await other.picture());
  assert.ok(share < 0.02, `${share} of the picture differ`);
  await other.close();
  await page.check("#layer-plants");
  await page.selectOption("#colours", "none");
});

test("the credit is in sight", async () => {
  const seen = await page.evaluate(() => {
    const credit = document.getElementById("credit"), box = credit.getBoundingClientRect();
    return [credit.textContent, document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2) === credit];
  });
  assert.match(seen[0], /© OpenStreetMap contributors/);
  assert.ok(seen[1], "something covers the credit");
});

test("a static server shows the same picture", async () => {
  await page.evaluate(() => window.citykiln.goHome());
  const own = await open.picture();
  const other = await OpenPage.open(process.env.PAGE_STATIC);
  await other.page.evaluate(() => window.citykiln.goHome());
  const share = changedShare(own, await other.picture());
  assert.ok(share < 0.02, `${share} of the picture differ`);
  assert.deepEqual(other.errors, []);
  await other.close();
});

test("the page throws no errors", () => assert.deepEqual(open.errors, []));
