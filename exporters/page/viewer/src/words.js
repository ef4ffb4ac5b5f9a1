// Words for people: names of the program, such as "TertiaryRoad", "w123" and "s|dd|s -|v^|-", as text.

const KINDS = { n: "node", w: "way", r: "relation" };

/** Returns a name of several words, such as "TertiaryRoad" or "flat_roof", as text: "tertiary road". */
export function wordsOf(name) {
  return name.replace(/([a-z\d])(?=[A-Z])/g, "$1 ").replaceAll("_", " ").toLowerCase();
}

/** Returns a text whose first letter is a capital. */
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** Returns an id such as "w123" as "way 123". */
export const elementOf = (id) => `${KINDS[id[0]]} ${id.slice(1)}`;

/** Returns the address of an element at openstreetmap.org. */
export const addressOf = (id) => `https://www.openstreetmap.org/${KINDS[id[0]]}/${id.slice(1)}`;

/** The letters of lanes, in the notation of compiler/map/cross_section.h. */
const LANES = { d: "traffic lane", b: "bus lane", t: "turning lane", c: "cycle lane", p: "parking lane", S: "hard shoulder", "/": "buffer", s: "pavement", f: "footway", r: "railway track", g: "grass verge" };
const COUNTED = "dbtcpS/sfrg";

const plural = (count, word) => (count === 1 ? `1 ${word}` : `${count} ${word}s`);

// "one way" and "one each way" are of traffic lanes alone
function directionOf(kinds, ways) {
  const own = [...kinds].map((kind, i) => (kind === "d" ? ways[i] : "")).join("");
  const [ahead, back] = ["^", "v"].map((sign) => own.split(sign).length - 1);
  if (ahead + back === 0) return "";
  if (ahead === 0 || back === 0) return " (one way)";
  return ahead === back ? ` (${ahead} each way)` : ` (${ahead} and ${back} by direction)`;
}

/** Returns lanes such as "s|dd|s -|v^|-" as text: "2 traffic lanes (1 each way), 2 pavements"; other texts as they are. */
export function lanesOf(text) {
  const [kinds, ways] = text.split(" ");
  if (ways === undefined || kinds.length !== ways.length) return text;
  const count = (letter) => kinds.split(letter).length - 1;
  return [...COUNTED].filter((letter) => count(letter) > 0)
    .map((letter) => plural(count(letter), LANES[letter]) + (letter === "d" ? directionOf(kinds, ways) : "")).join(", ");
}

/** Properties of recipes whose value is a name of the program. */
const NAMES = ["surface", "style", "roof", "wall", "roof_material", "species", "kind"];

/** Returns the value of a recipe's property as text, with the unit that ends its name. */
export function valueOf(name, value) {
  if (name === "lanes") return lanesOf(String(value));
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (NAMES.includes(name)) return wordsOf(String(value).replace(/\.rules$/, "").replace(/^.*\//, ""));
  const unit = Object.entries({ _m2: "\u00a0m²", _m: "\u00a0m", _deg: "°" }).find(([end]) => name.endsWith(end))?.[1] ?? "";
  return `${value}${unit}`;
}

/** Returns the name of a recipe's property as text, without its unit. */
export const propertyOf = (name) => name.replace(/_(m2?|deg)$/, "").replaceAll("_", " ");

/** Returns a text in lower case without accents, by which names are compared: "Straße" and "strasse" are equal. */
export function folded(text) {
  return text.toLowerCase().normalize("NFKD").replace(/\p{M}/gu, "")
    .replace(/[ßæœøłđðþıħ]/g, (c) => ({ ß: "ss", æ: "ae", œ: "oe", ø: "o", ł: "l", đ: "d", ð: "d", þ: "th", ı: "i", ħ: "h" })[c]);
}
