// The panel about the picked feature: class, tags, recipe, what is assumed, and the findings about it. All of it is text.
import { byId, make, makeList, say } from "./dom.js";

const KINDS = { n: "node", w: "way", r: "relation" };

const heading = (text) => make("h3", {}, text);
const note = (text) => make("p", { className: "note" }, text);

/** Returns the rows of a recipe: numbers with the unit that ends their name. */
function rowsOf(recipe) {
  return Object.entries(recipe).map(([name, value]) => {
    const unit = name.endsWith("_m2") ? " m²" : name.endsWith("_m") ? " m" : "";
    return [name.replace(/_m2?$/, "").replaceAll("_", " "), `${value}${unit}`];
  });
}

export class FeaturePanel {
  constructor(page, records, findings, closed) {
    Object.assign(this, { page, records, findings, closed, id: null });
    byId("close-feature").addEventListener("click", () => this.close());
  }

  close() {
    byId("feature").hidden = true;
    this.id = null;
    this.closed();
    byId("scene").focus();
  }

  /** Shows a feature and returns its record; undefined if the run has none. */
  async show(id) {
    this.id = id;
    const record = await this.records.find(id);
    if (this.id !== id) return undefined;
    byId("feature-title").textContent = record?.name || `${KINDS[id[0]]} ${id.slice(1)}`;
    byId("feature-text").replaceChildren(...this.parts(id, record ?? {}));
    byId("feature").hidden = false;
    say(`Picked ${record?.class ?? "feature"} ${id}`);
    return record;
  }

  parts(id, record) {
    const href = `https://www.openstreetmap.org/${KINDS[id[0]]}/${id.slice(1)}`;
    const link = make("a", { href, target: "_blank", rel: "noopener noreferrer" }, `${KINDS[id[0]]} ${id.slice(1)}`);
    return [
      make("p", {}, link),
      makeList([["class", record.class ?? "unknown"], ...(record.height_m ? [["height", `${record.height_m} m`]] : [])]),
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
    return makeList(own.map((finding) => [finding.properties.code, this.findings.describe(finding)]));
  }
}
