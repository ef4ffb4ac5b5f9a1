// The page by the keyboard alone: the order of focus, names of controls, contrast, and every function without a mouse.
import assert from "node:assert/strict";
import { test } from "node:test";
import { changedShare, distance, isPicked, shareOf, openForTests } from "./open_page.mjs";

const open = await openForTests(), { page } = open;

const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim().slice(0, 30));

/** Presses Tab until an element has the focus. */
async function tabTo(id, back = false) {
  for (let i = 0; i < 200; ++i) {
    if ((await focused()) === id) return;
    await page.keyboard.press(back ? "Shift+Tab" : "Tab");
  }
  assert.fail(`Tab does not reach ${id}`);
}

test("Tab reaches every control, in the order of the page", async () => {
  await page.evaluate(() => document.activeElement.blur());
  const expected = await page.evaluate(() => [...document.querySelectorAll("a[href], button, input, select, canvas[tabindex]")]
    .filter((element) => element.checkVisibility() && !element.disabled).map((element) => element.id || element.textContent.trim().slice(0, 30)));
  const reached = [];
  for (let i = 0; i < expected.length; ++i) {
    await page.keyboard.press("Tab");
    reached.push(await focused());
  }
  assert.deepEqual(reached, expected);
  console.log(`# ${expected.length} controls`);
});

test("every control has a name, and says its state", async () => {
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas[tabindex]")].filter((element) =>
    !(element.getAttribute("aria-label") || element.labels?.[0]?.textContent.trim() || element.textContent.trim())).map((element) => element.outerHTML));
  assert.deepEqual(nameless, []);
  assert.equal(await page.getAttribute("#fly", "aria-pressed"), "true");
});

test("text has a contrast of at least 7", async () => {
  const low = await page.evaluate(() => {
    const linear = (c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const luminance = (css) => css.match(/[\d.]+/g).slice(0, 3).map((v, i) => [0.2126, 0.7152, 0.0722][i] * linear(v / 255)).reduce((a, b) => a + b);
    const behind = (element) => {
      for (let node = element; node; node = node.parentElement) {
        const { backgroundColor } = getComputedStyle(node);
        if (!/, 0\)$/.test(backgroundColor)) return backgroundColor;
      }
      return "rgb(255, 255, 255)";
    };
    return [...document.querySelectorAll("aside *, footer *")].filter((element) => element.checkVisibility() && [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim()))
      .map((element) => [luminance(getComputedStyle(element).color), luminance(behind(element)), element.outerHTML.slice(0, 60)])
      .map(([a, b, html]) => [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), html]).filter(([ratio]) => ratio < 7);
  });
  assert.deepEqual(low, []);
});

test("walks, flies, picks and closes", async () => {
  await tabTo("walk");
  await page.keyboard.press("Space");
  assert.equal((await open.camera()).mode, "walk");
  await tabTo("fly", true);
  await page.keyboard.press("Enter");
  assert.equal((await open.camera()).mode, "fly");
  await open.put(0, -160, 70, 0, -0.45);
  await tabTo("scene", true);
  const before = (await open.camera()).at;
  await page.keyboard.down("ArrowUp");
  await page.waitForFunction((y) => window.citykiln.camera.position.y > y + 2, before[1]);
  await page.keyboard.up("ArrowUp");
  await open.still();
  for (let i = 0; i < 20 && !(await page.isVisible("#feature")); ++i) {
    await page.keyboard.press("Enter");
    await page.waitForTimeout(300);
    await page.keyboard.press("KeyK", { delay: 100 });
  }
  await page.keyboard.press("Enter");
  await page.waitForSelector("#feature:not([hidden])");
  assert.ok(shareOf(await open.picture(1), isPicked) > 0, "what was picked is not marked");
  await page.keyboard.press("Escape");
  assert.equal(await page.isVisible("#feature"), false);
  assert.equal(await focused(), "scene");
});

test("switches a layer, colours, and the time", async () => {
  const before = await open.picture();
  await tabTo("layer-buildings");
  await page.keyboard.press("Space");
  assert.ok(changedShare(before, await open.picture()) > 0.02);
  await page.keyboard.press("Space");
  // colours are without light, so the time comes first
  for (const [id, key] of [["time", "Home"], ["colours", "l"]]) {
    const own = await open.picture(), value = await page.inputValue(`#${id}`);
    await tabTo(id);
    await page.keyboard.press(key);
    assert.notEqual(await page.inputValue(`#${id}`), value);
    assert.ok(changedShare(own, await open.picture()) > 0.05, id);
  }
});

test("goes to a place and to a finding", async () => {
  await tabTo("place", true);
  await page.keyboard.type("48.7010 12.3010");
  await page.keyboard.press("Enter");
  await open.still();
  const there = (await open.camera()).at;
  await tabTo("finding-code");
  await page.keyboard.press("a");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await open.still();
  assert.ok(distance((await open.camera()).at, there) > 1);
});

test("measures at the cross", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  await tabTo("measure");
  await page.keyboard.press("Enter");
  await tabTo("scene", true);
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.citykiln.measure.points.length === 1);
  const { heading } = await open.camera();
  await page.keyboard.down("l");
  await page.waitForFunction((heading) => Math.abs(window.citykiln.moves.heading - heading) > 0.1, heading);
  await page.keyboard.up("l");
  await open.still();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.citykiln.measure.points.length === 2);
  assert.match(await open.text("#measured"), /^distance [1-9]/);
  await page.keyboard.press("Escape");
  assert.equal(await page.getAttribute("#measure", "aria-pressed"), "false");
});
