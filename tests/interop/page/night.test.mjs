// The page of a run by night with lights: windows glow, and lamps light the ground below them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { changedShare, luminance, meanLuminance, shareOf, openForTests } from "./open_page.mjs";

const open = await openForTests(), { page } = open;

test("windows are lit at the run's time", async () => {
  await open.put(0, -160, 40, 0, -0.3);
  const picture = await open.picture(1);
  const isWindow = (pixel) => luminance(pixel) > 110 && pixel[0] > pixel[2] + 25;
  console.log(`# mean luminance ${meanLuminance(picture).toFixed(0)}, ${(shareOf(picture, isWindow) * 100).toFixed(2)} % of the picture are lit windows`);
  assert.ok(meanLuminance(picture) < 60);
  assert.ok(shareOf(picture, isWindow) > 0.0005);
});

test("the nearest lamps throw light, and none by day", async () => {
  const lit = () => page.evaluate(() => window.citykiln.lamps.pool.filter((light) => light.intensity > 0).map((light) => light.position.toArray()));
  const lamps = await lit();
  assert.ok(lamps.length > 0, "no lamp is lit");
  const [x, y, z] = lamps[0];
  await open.put(x, y - 12, 8, 0, -0.5);
  const before = await open.picture(1);
  await page.evaluate(() => window.citykiln.lamps.pool.forEach((light) => (light.intensity = 0)));
  const without = await open.picture(1);
  assert.ok(changedShare(before, without) > 0.01, "the lamps change nothing in the picture");
  assert.ok(meanLuminance(before) > meanLuminance(without));
  const noon = (await page.locator("#time option").allInnerTexts()).find((text) => text.startsWith("12:00"));
  await page.selectOption("#time", { label: noon });
  await open.still();
  assert.deepEqual(await lit(), []);
  assert.ok(z > 0);
});
