// Goes to a latitude and longitude, an OSM id such as "w123" or "way 123", or a name.
import { byId, make, say } from "./dom.js";

const MOST = 12;

/** Returns {lat_deg, lon_deg} of "43.73, 7.42"; null for other texts. */
export function readPlace(text) {
  const found = text.match(/^\s*(-?\d+(?:\.\d+)?)\s*[,\s]\s*(-?\d+(?:\.\d+)?)\s*$/);
  if (!found) return null;
  const [lat_deg, lon_deg] = found.slice(1).map(Number);
  return Math.abs(lat_deg) <= 90 && Math.abs(lon_deg) <= 180 ? { lat_deg, lon_deg } : null;
}

/** Returns the ids that a text may mean: one for "w123", "way 123" or "way/123", three for a number; none for other texts. */
export function readIds(text) {
  const found = text.trim().toLowerCase().match(/^(?:(n|w|r|node|way|relation)[\s/]*)?(-?\d+)$/);
  if (!found) return [];
  return (found[1] ? [found[1][0]] : ["w", "r", "n"]).map((letter) => letter + found[2]);
}

export class Search {
  /** @param {object} go Functions that are called: toPlace(lon, lat) and toFeature(id, record). */
  constructor(records, go) {
    this.records = records;
    this.go = go;
    byId("go").addEventListener("submit", (event) => {
      event.preventDefault();
      this.find(byId("place").value);
    });
  }

  async find(text) {
    byId("matches").replaceChildren();
    if (text.trim() === "") return;
    const place = readPlace(text);
    if (place) return this.go.toPlace(place.lon_deg, place.lat_deg);
    for (const id of readIds(text)) {
      const record = await this.records.find(id);
      if (record) return this.go.toFeature(id, record);
    }
    if (readIds(text).length > 0) return say(`This run has no element ${text.trim()}.`);
    await this.findName(text.trim());
  }

  async findName(text) {
    const found = await this.records.named(text, MOST);
    if (found.length === 0) return say(`Nothing here is named ${text}.`);
    if (found.length === 1) return this.open(found[0][1]);
    byId("matches").replaceChildren(...found.map(([name, id]) => this.match(name, id)));
    say(`${found.length} places are named so.`);
  }

  match(name, id) {
    const button = make("button", { type: "button" }, `${name} (${id})`);
    button.addEventListener("click", () => this.open(id));
    return make("li", {}, button);
  }

  async open(id) {
    this.go.toFeature(id, await this.records.find(id));
  }
}
