// The page of a run: reads page.json and the tileset, and connects the parts of the page.
import { byId, say } from "./dom.js";
import { Progress } from "./progress.js";
import { fetchJson } from "./records.js";
import { Viewer } from "./viewer.js";

async function start() {
  const progress = new Progress();
  const load = (name, url) => progress.during(name, fetchJson(url));
  const [page, tileset] = await Promise.all([load("the map's facts", "page/page.json"), load("the list of tiles", "3dtiles/tileset.json")]);
  document.title = byId("title").textContent = page.title;
  byId("credit").textContent = page.attributions.join(" · ");
  const viewer = new Viewer(page, tileset, progress);
  // for tests and for the console of the browser
  window.citykiln = viewer;
  viewer.start();
}

start().catch((error) => say(`The page cannot be shown: ${error.message}`));
