// The page's help: a dialog that "?" and a button open.
import { byId } from "./dom.js";

const isTyping = ({ target }) => target.matches?.("input, select, textarea");

export function listenForHelp() {
  const dialog = byId("help");
  byId("open-help").addEventListener("click", () => dialog.showModal());
  byId("close-help").addEventListener("click", () => dialog.close());
  window.addEventListener("keydown", (event) => {
    if (event.key !== "?" || isTyping(event) || dialog.open) return;
    event.preventDefault();
    dialog.showModal();
  });
}
