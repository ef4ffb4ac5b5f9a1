// The panel about the picked feature: class, tags, recipe, what is assumed, and the findings about it. All of it is text.
import { byId, make, makeList, say } from "./dom.js";
import { addressOf, capital, elementOf, propertyOf, valueOf, wordsOf } from "./words.js";

const heading = (text) => make("h3", {}, text);
const note = (text) => make("p", { className: "note" }, text);

/** Returns the rows of a recipe, in words. */
const rowsOf = (recipe) => Object.entries(recipe).map(([name, value]) => [propertyOf(name), valueOf(name, value)]);

/** Returns the class of a record in words: "Tertiary road". */
const classOf = (record) => (record?.class ? capital(wordsOf(record.class)) : "Unknown");

export class FeaturePanel {
  /** @param {object} parts {page, records, findings, names}. @param {Function} closed Called when the panel closes. */
  constructor(parts, closed) {
    Object.assign(this, parts, { closed, id: null });
    byId("close-feature").addEventListener("click", () => this.close());
  }

  hide() {
    byId("feature").hidden = true;
    this.id = null;
  }

  close() {
    this.hide();
    this.closed();
    byId("scene").focus();
  }

  /** Shows a feature and returns its record; undefined if the run has none. */
  async show(id) {
    this.id = id;
    const [record] = await Promise.all([this.records.find(id), this.findings.load()]);
    if (this.id !== id) return undefined;
    const title = byId("feature-title"), name = this.names.of(record ?? {});
    title.textContent = name || (record?.class ? classOf(record) : capital(elementOf(id)));
    title.dir = "auto";
    byId("feature-text").replaceChildren(...this.parts(id, record ?? {}));
    byId("feature").hidden = false;
    say(`${name ? `\u2068${name}\u2069, ` : ""}${record?.class ? wordsOf(record.class) : elementOf(id)}`);
    return record;
  }

  parts(id, record) {
    const link = make("a", { href: addressOf(id), target: "_blank", rel: "noopener noreferrer" }, `OpenStreetMap: ${elementOf(id)}`);
    return [
      make("p", {}, link),
      makeList([["class", classOf(record)], ...(record.height_m ? [["height", `${record.height_m}\u00a0m`]] : [])]),
      heading("Tags"), this.tags(record),
      heading("Recipe"), record.recipe ? makeList(rowsOf(record.recipe)) : note("No recipe of its own."),
      heading("Assumed"), this.assumed(record),
      heading("Findings"), this.found(id),
    ];
  }

  tags(record) {
    if (record.tags) return makeList(Object.entries(record.tags));
    if (this.page.has_tags) return note("None.");
    return note("This run keeps no tags. Compile with --tags to see them.");
  }

  assumed(record) {
    const texts = (record.assumed ?? []).map((name) => [name, this.page.assumptions[name] ?? ""]);
    return texts.length > 0 ? makeList(texts) : note("Nothing.");
  }

  found(id) {
    const own = this.findings.about(id);
    if (own.length === 0) return note("None.");
    return makeList(own.map((finding) => [capital(wordsOf(finding.properties.code)), this.findings.describe(finding)]));
  }
}
