// Ten tasks of a new reader with a phone: taps on what is in sight, without a manual. PAGE_SHOTS is a folder for a screenshot of each.
import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { OpenPage, axeFaults, changedShare, distance, isSerious, luminance, meanLuminance, openForTests, shareOf } from "./open_page.mjs";

const open = await openForTests({ isPhone: true, timeout_ms: 60_000 }), { page } = open;
const shots = process.env.PAGE_SHOTS;
let number = 0;
afterEach(async () => shots && (await page.screenshot({ path: `${shots}/${++number}.png` })));

/** Unfolds or folds the sheet of controls. */
const sheet = async (isOpen) => (await page.isVisible("#layers")) !== isOpen && (await page.tap("#fold"));
const choose = async (id, wanted) => {
  const labels = await page.locator(`#${id} option`).allInnerTexts();
  await page.selectOption(`#${id}`, { label: labels.find((label) => wanted.test(label)) });
};
const type = async (text) => {
  await page.tap("#place");
  await page.fill("#place", "");
  await page.locator("#place").pressSequentially(text);
  await page.waitForSelector("#matches button");
};
/** The middle of what is seen of the scene above the sheet. */
const middle = () => page.evaluate(() => [window.innerWidth / 2, document.getElementById("controls").getBoundingClientRect().top / 2]);

/** Taps points of the scene, from its middle on, until something is so. */
async function tapUntil(isDone) {
  const [x, y] = await middle();
  for (const [dx, dy] of [[0, 0], [0, 30], [0, 60], [40, 30], [-40, 30], [60, 60], [-60, 60], [0, 100]]) {
    await page.touchscreen.tap(x + dx, y + dy);
    await page.waitForTimeout(600);
    if (await isDone()) return;
  }
  assert.fail("no tap does it");
}

test("1: find a street and walk it", async () => {
  await type("bahnhofst");
  await page.tap("#matches button");
  await open.still();
  assert.equal(await open.text("#feature-title"), "Bahnhofstraße");
  await page.tap("#walk");
  await open.still();
  const { at, mode } = await open.camera(), box = await page.locator("#pad-ahead").boundingBox();
  assert.equal(mode, "walk");
  const session = await page.context().newCDPSession(page);
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x: box.x + 20, y: box.y + 20 }] });
  await page.waitForFunction(([x, y]) => Math.hypot(window.citykiln.camera.position.x - x, window.citykiln.camera.position.y - y) > 4, at);
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await open.still();
});

test("2: see it at night", async () => {
  await sheet(true);
  await choose("time", /^00:00/);
  await sheet(false);
  const picture = await open.picture(1), mean = meanLuminance(picture);
  assert.ok(mean > 3 && mean < 60, `mean luminance ${mean}`);
  assert.ok(shareOf(picture, (pixel) => luminance(pixel) > 90 && pixel[0] > pixel[2] + 25) > 0.0005, "neither windows nor lamps are lit");
});

test("3: send a friend the view", async () => {
  await sheet(true);
  await page.tap("#link");
  await page.waitForFunction(() => /link|address/.test(document.getElementById("linked").textContent));
  await sheet(false);
  const picture = await open.picture(), { at, heading, mode } = await open.camera();
  const friend = await OpenPage.open(page.url(), { isPhone: true });
  const seen = await friend.camera(), share = changedShare(picture, await friend.picture());
  await friend.close();
  assert.ok(distance(seen.at, at) < 0.1 && Math.abs(seen.heading - heading) < 0.01, `${seen.at} for ${at}`);
  assert.equal(seen.mode, mode);
  assert.ok(share < 0.1, `${share} of the picture differ`);
});

test("4: go back to the whole", async () => {
  await page.tap("#home");
  await sheet(true);
  await choose("time", /run's time/);
  await sheet(false);
  await open.still();
  const [place, middle] = await page.evaluate(() => {
    const { camera, limits, rays } = window.citykiln, { west, east, south, north } = limits;
    return [rays.at(0, rays.middle).point.toArray(), [(west + east) / 2, (south + north) / 2, camera.position.z - limits.ground_m]];
  });
  assert.ok(Math.hypot(place[0] - middle[0], place[1] - middle[1]) < 100 && middle[2] > 150);
});

test("5: look up a name by a part of a word, without accents", async () => {
  await type("arberg");
  assert.deepEqual(await page.locator("#matches bdi").allInnerTexts(), ["Färbergasse"]);
  await page.tap("#matches button");
  await page.waitForSelector("#feature:not([hidden])");
  assert.equal(await open.text("#feature-title"), "Färbergasse");
  await open.still();
});

test("6: measure a square", async () => {
  await type("markt");
  await page.tap("#matches button");
  await page.waitForSelector("#feature:not([hidden])");
  await open.still();
  await page.tap("#close-feature");
  await sheet(true);
  await page.tap("#measure");
  await sheet(false);
  const [x, y] = await middle();
  for (const dx of [-50, 50]) {
    await page.touchscreen.tap(x + dx, y + 40);
    await page.waitForTimeout(700);
  }
  assert.ok(await page.isVisible("#status"));
  const [metres] = (await open.text("#status")).match(/(?<=^distance )[\d.]+/).map(Number);
  assert.ok(metres > 3 && metres < 200, `${metres} m`);
});

test("7: find out who made up a thing, and what is assumed of it", async () => {
  if ((await page.getAttribute("#measure", "aria-pressed")) === "true") await page.evaluate(() => window.citykiln.measure.turn(false));
  await tapUntil(() => page.isVisible("#feature"));
  const text = await open.text("#feature-text");
  assert.match(text, /OpenStreetMap: (way|relation|node) \d+/);
  assert.match(text, /Assumed/);
  assert.match(await page.getAttribute("#feature-text a", "href"), /^https:\/\/www\.openstreetmap\.org\/(way|relation|node)\/\d+$/);
});

test("8: see the worst finding", async () => {
  await sheet(true);
  await choose("finding-code", /^all/);
  const first = page.locator("#findings li button").first();
  assert.doesNotMatch(await first.innerText(), /\(note\)/);
  await first.tap();
  await open.still();
  await sheet(false);
  assert.ok((await open.text("#status")).length > 20);
  const [place, free] = await page.evaluate(() => {
    const { findings, camera, canvas } = window.citykiln, { x, y } = findings.place(findings.some[0]).project(camera);
    const sheets = ["controls", "feature"].map((id) => document.getElementById(id)).filter((element) => !element.hidden);
    return [[(x + 1) / 2 * canvas.clientWidth, (1 - y) / 2 * canvas.clientHeight], Math.min(...sheets.map((element) => element.getBoundingClientRect().top))];
  });
  assert.ok(place[0] > 0 && place[0] < 393 && place[1] > 0 && place[1] < free, `${place}; the scene is free down to ${free}`);
});

test("9: turn a layer off", async () => {
  const before = await open.picture();
  await sheet(true);
  await page.tap("label[for=layer-buildings]");
  await sheet(false);
  assert.ok(changedShare(before, await open.picture()) > 0.02);
});

test("10: read the help", async () => {
  await page.tap("#open-help");
  const { top, bottom, left, right } = await page.evaluate(() => document.getElementById("help").getBoundingClientRect().toJSON());
  const { width, height } = page.viewportSize();
  assert.ok(top >= 0 && bottom <= height && left >= 0 && right <= width);
  assert.match(await open.text("#help"), /pinch/);
  assert.ok(await page.isVisible("#close-help"));
});

test("axe finds no serious fault on a phone", async () => {
  const isOpen = await page.evaluate(() => document.getElementById("help").open);
  if (isOpen) await page.tap("#close-help");
  await sheet(true);
  assert.deepEqual((await axeFaults(open)).filter(isSerious), []);
  assert.deepEqual(open.errors, []);
});
