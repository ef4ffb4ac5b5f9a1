// The page on a phone, with touch emulated: fingers turn, slide, spread and close, buttons walk, the controls are a sheet at the bottom.
import assert from "node:assert/strict";
import { test } from "node:test";
import { distance, openForTests } from "./open_page.mjs";

const open = await openForTests({ isPhone: true }), { page } = open;
const session = await page.context().newCDPSession(page);

const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });

/** Moves fingers from some points to as many others, in steps. */
async function slide(from, to, steps = 6) {
  await touch("touchStart", from);
  for (let i = 1; i <= steps; ++i) await touch("touchMove", from.map(([x, y], k) => [x + ((to[k][0] - x) * i) / steps, y + ((to[k][1] - y) * i) / steps]));
  await touch("touchEnd", []);
}

test("the controls are a sheet at the bottom that leaves half of the scene free", async () => {
  const [box, all] = await page.evaluate(() => [document.getElementById("controls").getBoundingClientRect().toJSON(), window.innerHeight]);
  assert.ok(box.top > all / 2, `${box.top} of ${all}`);
  assert.ok(box.bottom > all - 60 && box.width > 300);
  await page.click("#fold");
  assert.ok(await page.isVisible("#layers"));
  await page.click("#fold");
  assert.ok(await page.isHidden("#layers"));
});

test("everything that is tapped is at least 44 pixels wide and high", async () => {
  await page.click("#fold");
  const small = await page.evaluate(() => [...document.querySelectorAll("button, select, input[type=text], #layers label, a:not(.skip)")].filter((element) => element.checkVisibility())
    .map((element) => [element.id || element.textContent, element.getBoundingClientRect()]).filter(([, { width, height }]) => width < 44 || height < 44).map(([name, { width, height }]) => `${name} ${width} by ${height}`));
  await page.click("#fold");
  assert.deepEqual(small, []);
});

test("one finger turns the view and moves nothing", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  const before = await open.camera();
  await slide([[150, 250]], [[230, 250]]);
  const turned = await open.camera();
  assert.ok(turned.heading < before.heading - 0.05, "dragged to the right, the view turns to the left");
  assert.deepEqual(turned.at, before.at);
  assert.equal(await page.isVisible("#feature"), false, "a drag picks nothing");
});

test("two fingers apart move nearer, together farther", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  const before = (await open.camera()).at;
  await slide([[180, 250], [220, 250]], [[120, 250], [280, 250]]);
  const near = (await open.camera()).at;
  assert.ok(near[1] > before[1] + 10 && near[2] < before[2] - 3, `${before} to ${near}`);
  await slide([[120, 250], [280, 250]], [[180, 250], [220, 250]]);
  const far = (await open.camera()).at;
  assert.ok(far[1] < near[1] - 10 && far[2] > near[2], `${near} to ${far}`);
  assert.equal(await page.isVisible("#feature"), false, "two fingers pick nothing");
});

test("two fingers together slide the view", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  const before = await open.camera();
  await slide([[150, 250], [210, 250]], [[230, 250], [290, 250]]);
  const { at, heading } = await open.camera();
  assert.ok(at[0] < before.at[0] - 5, "dragged to the right, the camera goes to the left");
  assert.ok(Math.abs(at[1] - before.at[1]) < 1 && Math.abs(heading - before.heading) < 1e-6);
});

test("a tap picks what is there", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  for (let y = 260; y < 420 && !(await page.isVisible("#feature")); y += 25) {
    await page.touchscreen.tap(190, y);
    await page.waitForTimeout(500);
  }
  assert.ok(await page.isVisible("#feature"));
  await page.tap("#close-feature");
  assert.ok(await page.isHidden("#feature"));
});

test("on foot, the button moves ahead while it is held", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  await page.tap("#walk");
  await open.still();
  const before = await open.camera();
  assert.equal(before.mode, "walk");
  const box = await page.locator("#pad-ahead").boundingBox();
  await touch("touchStart", [[box.x + 20, box.y + 20]]);
  await page.waitForFunction(([x, y]) => Math.hypot(window.citykiln.camera.position.x - x, window.citykiln.camera.position.y - y) > 2, before.at);
  await touch("touchEnd", []);
  const walked = await open.camera();
  const ahead = (walked.at[0] - before.at[0]) * Math.sin(before.heading) + (walked.at[1] - before.at[1]) * Math.cos(before.heading);
  assert.ok(ahead > 2 && ahead > 0.95 * Math.hypot(walked.at[0] - before.at[0], walked.at[1] - before.at[1]));
  await page.waitForTimeout(300);
  const rested = (await open.camera()).at;
  await page.waitForTimeout(300);
  assert.ok(distance((await open.camera()).at, rested) < 1e-9, "the walker stops when the finger is lifted");
});

test("the page throws no errors", () => assert.deepEqual(open.errors, []));
