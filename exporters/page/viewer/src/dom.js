// Elements of the page. Texts of strangers, such as tags, are set as text and never parsed as markup.

/** The element of index.html with an id. */
export const byId = (id) => document.getElementById(id);

/** Makes an element with properties and children; a child that is a string becomes text. */
export function make(name, properties = {}, ...children) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
}

/** Makes a description list of [term, text] pairs. */
export function makeList(pairs) {
  const list = make("dl");
  // texts of the map may run from right to left
  for (const [term, text] of pairs) list.append(make("dt", {}, String(term)), make("dd", { dir: "auto" }, String(text)));
  return list;
}

/** Shows one line below the scene, which screen readers say. */
export function say(text) {
  byId("status").textContent = text;
}
