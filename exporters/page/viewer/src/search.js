// Goes to a latitude and longitude of the map, an OSM id such as "way 123", or a name; suggests names while one types.
import { byId, make, say } from "./dom.js";
import { elementOf, folded, wordsOf } from "./words.js";

const MOST = 12;
/** Parts of one street are one match if each is at most this far from the next. */
const APART_M = 400;

/** Returns {lat_deg, lon_deg} of "43.73, 7.42"; null for other texts. */
export function readPlace(text) {
  const found = text.match(/^\s*(-?\d+(?:\.\d+)?)\s*[,;\s]\s*(-?\d+(?:\.\d+)?)\s*$/);
  if (!found) return null;
  const [lat_deg, lon_deg] = found.slice(1).map(Number);
  return { lat_deg, lon_deg };
}

/** Returns the ids that a text may mean: one for "w123", "way 123" or "way/123", three for a number; none for other texts. */
export function readIds(text) {
  const found = text.trim().toLowerCase().match(/^(?:(n|w|r|node|way|relation)[\s/]*)?(-?\d+)$/);
  if (!found) return [];
  return (found[1] ? [found[1][0]] : ["w", "r", "n"]).map((letter) => letter + found[2]);
}

const isIn = ({ west, south, east, north }, lon, lat) => lon >= west && lon <= east && lat >= south && lat <= north;

/** Returns why a place cannot be gone to; "" if it is in the map's box, {west, south, east, north} in degrees. */
export function refusal(box, { lat_deg, lon_deg }) {
  if (isIn(box, lon_deg, lat_deg)) return "";
  const span = `The map spans latitudes ${box.south.toFixed(4)} to ${box.north.toFixed(4)} and longitudes ${box.west.toFixed(4)} to ${box.east.toFixed(4)}.`;
  if (isIn(box, lat_deg, lon_deg)) return `Latitude comes first: ${lon_deg}, ${lat_deg} is on the map. ${span}`;
  return `${lat_deg}, ${lon_deg} is outside of the map. ${span}`;
}

/** Joins the rows of one name and class that lie beside each other: the ways of a street. A row is [name, id, class, x, y]. */
export function joined(rows) {
  const groups = [];
  for (const row of rows) {
    const isNear = ([name, , kind, x, y]) => name === row[0] && kind === row[2] && Math.hypot(x - row[3], y - row[4]) < APART_M;
    const group = groups.find((each) => each.some(isNear));
    if (group) group.push(row);
    else groups.push([row]);
  }
  return groups;
}

/** Returns the rows whose names have all words of a text in them; the whole name first, then those that begin with it. */
export function matching(names, text) {
  const wanted = folded(text).trim(), parts = wanted.split(/[\s,]+/).filter(Boolean);
  const rank = (name) => (name === wanted ? 0 : name.startsWith(wanted) ? 1 : name.includes(` ${wanted}`) ? 2 : 3);
  return names.map((row) => [folded(row[0]), row]).filter(([name]) => parts.every((part) => name.includes(part)))
    .sort(([a], [b]) => rank(a) - rank(b) || a.localeCompare(b)).map(([, row]) => row);
}

export class Search {
  /** @param {object} go Functions that are called: toPlace(lon, lat) and toFeature(id, record). @param box The map's, in degrees. */
  constructor(records, box, go) {
    Object.assign(this, { records, box, go, turn: 0 });
    byId("go").addEventListener("submit", (event) => {
      event.preventDefault();
      this.find(byId("place").value);
    });
    byId("place").addEventListener("input", () => this.suggest(byId("place").value));
    byId("go").addEventListener("keydown", (event) => this.press(event));
  }

  /** Up and down go through the matches, Escape closes them. */
  press(event) {
    const list = [byId("place"), ...byId("matches").querySelectorAll("button")], at = list.indexOf(document.activeElement);
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.code];
    if (event.code === "Escape") this.close();
    if (!step || at < 0) return;
    event.preventDefault();
    list[Math.min(list.length - 1, Math.max(0, at + step))].focus();
  }

  close() {
    ++this.turn;
    byId("matches").replaceChildren();
  }

  async suggest(text) {
    const turn = ++this.turn;
    const isName = text.trim().length > 1 && !readPlace(text) && readIds(text).length === 0;
    const groups = isName ? joined(matching(await this.records.names(), text).slice(0, 20 * MOST)) : [];
    if (turn === this.turn) this.show(groups);
  }

  async find(text) {
    this.close();
    if (text.trim() === "") return;
    const place = readPlace(text);
    if (place) return this.toPlace(place);
    for (const id of readIds(text)) {
      const record = await this.records.find(id);
      if (record) return this.go.toFeature(id, record);
    }
    if (readIds(text).length > 0) return say(`This map has no element ${text.trim()}.`);
    await this.findName(text.trim());
  }

  toPlace(place) {
    const why = refusal(this.box, place);
    return why ? say(why) : this.go.toPlace(place.lon_deg, place.lat_deg);
  }

  async findName(text) {
    const turn = this.turn, all = matching(await this.records.names(), text);
    if (turn !== this.turn) return;
    const whole = all.filter(([name]) => folded(name) === folded(text)), groups = joined(whole.length > 0 ? whole : all);
    if (groups.length === 0) return say(`Nothing on this map is named ${text}.`);
    if (groups.length === 1) return this.open(groups[0]);
    this.show(groups);
    const shown = groups.length > MOST ? ` The first ${MOST} are listed.` : "";
    say(`${groups.length} places are named so.${shown}`);
  }

  show(groups) {
    byId("matches").replaceChildren(...groups.slice(0, MOST).map((group) => this.match(group)));
  }

  match(group) {
    const [name, id, kind] = group[0];
    const parts = group.length > 1 ? `, ${group.length} parts` : "";
    const button = make("button", { type: "button" }, make("bdi", {}, name), ` ${kind ? wordsOf(kind) : elementOf(id)}${parts}`);
    button.dataset.id = id;
    button.addEventListener("click", () => this.open(group));
    return make("li", {}, button);
  }

  // the middle one of several parts
  async open(group) {
    this.close();
    const [name, id] = group[Math.floor(group.length / 2)];
    byId("place").value = name;
    const record = await this.records.find(id);
    return record ? this.go.toFeature(id, record) : say(`${name} has no place on this map.`);
  }
}
