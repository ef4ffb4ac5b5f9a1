// Tags and names of strangers with markup in them stay text, in the panel, in the list of names and in findings.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openForTests } from "./open_page.mjs";

const MARKUP = process.env.PAGE_MARKUP;
const open = await openForTests(), { page } = open;

/** Elements of the page that its own code does not make, and what markup of tags would have set. */
const injected = () => page.evaluate(() => [window.hacked ?? null, document.querySelectorAll("img, iframe, object, svg, form:not(#go), script:not([src])").length]);

test("a tag with markup is shown as text", async () => {
  await page.fill("#place", process.env.PAGE_ID);
  await page.click("#go button");
  await page.waitForSelector("#feature:not([hidden])");
  await page.waitForFunction(() => document.querySelectorAll("#feature-text dd").length > 2);
  assert.ok((await open.text("#feature-text")).includes(MARKUP), await open.text("#feature-text"));
  assert.equal(await open.text("#feature-title"), MARKUP);
  assert.deepEqual(await injected(), [null, 0]);
});

test("a name with markup is found, and shown as text", async () => {
  await page.fill("#place", "<img");
  await page.click("#go button");
  await page.waitForFunction((text) => document.getElementById("matches").innerText.includes(text) || document.getElementById("feature-title").innerText === text, MARKUP);
  assert.deepEqual(await injected(), [null, 0]);
});
