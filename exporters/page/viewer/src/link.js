// The state of the page as the part of its address behind "#": where the camera is, what is shown, and what is picked.

const USUAL_DETAIL_PX = 6;

const number = (value, digits) => String(Number(value.toFixed(digits)));

/** Returns the state as text, such as "x=12&y=-40&z=18.2&heading=20&pitch=-5". */
export function writeLink({ position, heading, pitch, mode, hidden, colours, time, detail_px, names, id }) {
  const link = new URLSearchParams({
    x: number(position.x, 2), y: number(position.y, 2), z: number(position.z, 2),
    heading: number((heading * 180) / Math.PI, 2), pitch: number((pitch * 180) / Math.PI, 2),
  });
  if (mode !== "fly") link.set("mode", mode);
  if (hidden.size > 0) link.set("hide", [...hidden].join(","));
  if (colours !== "none") link.set("colours", colours);
  if (detail_px !== USUAL_DETAIL_PX) link.set("detail", String(detail_px));
  if (time !== undefined) link.set("time", String(time));
  if (names !== "local") link.set("names", names);
  if (id) link.set("id", id);
  return link.toString();
}

/** Returns the state that a text gives; what it does not give is undefined. Texts of other forms give nothing. */
export function readLink(text) {
  const link = new URLSearchParams(text);
  const read = (name) => {
    const value = Number(link.get(name) ?? NaN);
    return Number.isFinite(value) ? value : undefined;
  };
  const [x, y, z] = ["x", "y", "z"].map(read);
  const radians = (name) => (read(name) === undefined ? undefined : (read(name) * Math.PI) / 180);
  return {
    position: [x, y, z].includes(undefined) ? undefined : [x, y, z],
    heading: radians("heading") ?? 0,
    pitch: radians("pitch") ?? 0,
    mode: link.get("mode") === "walk" ? "walk" : "fly",
    hidden: (link.get("hide") ?? "").split(",").filter(Boolean),
    colours: link.get("colours") ?? "none",
    time: read("time"),
    detail_px: read("detail") ?? USUAL_DETAIL_PX,
    names: link.get("names") ?? "local",
    id: /^[nwr]-?\d+$/.test(link.get("id") ?? "") ? link.get("id") : undefined,
  };
}
