// The page of a run: reads page.json, the tileset and the findings, and connects the parts of the page.
import { byId, say } from "./dom.js";
import { fetchJson } from "./records.js";
import { Viewer } from "./viewer.js";

async function start() {
  say("Loading");
  const [page, tileset, findings] = await Promise.all(["page/page.json", "3dtiles/tileset.json", "findings.json"].map(fetchJson));
  document.title = byId("title").textContent = page.title;
  byId("credit").textContent = page.attributions.join(" · ");
  const viewer = new Viewer(page, tileset, findings);
  // for tests and for the console of the browser
  window.citykiln = viewer;
  viewer.start();
}

start().catch((error) => say(`The page cannot be shown: ${error.message}`));
