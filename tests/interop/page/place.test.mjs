// The page of a real place: it streams, and its features are picked.
import assert from "node:assert/strict";
import { test } from "node:test";
import { changedShare, isPicked, shareOf, openForTests } from "./open_page.mjs";

const open = await openForTests(), { page } = open;

test("the first view loads a small part of the run", async () => {
  const { requests, bytes } = await open.loaded();
  const all = Number(process.env.PAGE_BYTES);
  console.log(`# ${requests} requests, ${(bytes / 1e6).toFixed(1)} of ${(all / 1e6).toFixed(1)} MB`);
  assert.ok(bytes < all * 0.25, `${bytes} of ${all} bytes`);
  assert.ok(requests < 120);
});

test("a named building is gone to and marked", async () => {
  const [name, id] = await page.evaluate(async () => {
    const { records } = window.citykiln;
    for (const [name, id] of await records.names()) if (id[0] === "w" && (await records.find(id)).recipe?.storeys > 2) return [name, id];
    return [];
  });
  const before = await open.picture();
  await page.fill("#place", id);
  await page.click("#go button");
  await page.waitForFunction((id) => window.citykiln.panel.id === id, id);
  const picture = await open.picture(1);
  console.log(`# ${name} (${id}): ${(shareOf(picture, isPicked) * 100).toFixed(1)} % of the picture`);
  assert.ok(shareOf(picture, isPicked) > 0.002);
  assert.ok(changedShare(before, await open.picture()) > 0.3);
});

test("walks in a street", async () => {
  await page.click("#walk");
  await open.still();
  const above = await page.evaluate(() => window.citykiln.camera.position.z - window.citykiln.rays.floorBelow(window.citykiln.camera.position));
  assert.ok(Math.abs(above - 1.7) < 0.01, String(above));
});

test("findings are listed in parts", async () => {
  await page.selectOption("#finding-code", "");
  const [all, listed] = await page.evaluate(() => [window.citykiln.findings.all.length, document.querySelectorAll("#findings li").length]);
  console.log(`# ${all} findings`);
  assert.equal(listed, Math.min(all, 100));
  if (all <= 100) return;
  await page.click("#more-findings");
  assert.equal(await page.locator("#findings li").count(), Math.min(all, 200));
});

test("no errors", () => assert.deepEqual(open.errors, []));
