// Sets a walker down: on the street that is looked at, picked or searched, looking along it; again and again until its fine tile is loaded.
import { Vector3 } from "three";
import { rowOfId } from "./features.js";
import { streetAt } from "./street.js";

/** Lower cameras begin where they are, not where they look. */
const LOW_M = 15;
/** What stands nearer than this is in the way of a view along a street. */
const FREE_M = 12;
/** The picked object is looked at from the street if it is not farther than this. */
const SEEN_M = 60;

/** Each landing may load finer tiles; so many settle. */
const MOST_LANDINGS = 6;

const isIn = ({ west, south, east, north }, { x, y }) => x > west && x < east && y > south && y < north;
const headingTo = (from, to) => Math.atan2(to.x - from.x, to.y - from.y);
const turnBetween = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));

export class Walk {
  /** @param {object} parts {tileset, rays, moves, camera}. */
  constructor(parts) {
    Object.assign(this, parts);
    this.wanted = null;
    this.turn = 0;
    this.moves.interrupted = () => (this.wanted = null);
  }

  /** Begins to walk. @param picked The place and the id of what is picked: {at, id}; null for what is looked at. */
  begin(picked) {
    this.wanted = { point: this.pointOf(picked), id: picked?.id ?? null, picked: picked?.at ?? null, landings: 0, heading: this.moves.heading };
    this.moves.setMode("walk");
    return this.land();
  }

  pointOf(picked) {
    const { limits, above_m, heading } = this.moves, { position } = this.camera;
    if (picked) return picked.at.clone();
    const hit = above_m > LOW_M ? this.rays.at(0, this.rays.middle)?.point : position.clone();
    if (hit && isIn(limits, hit)) return hit;
    // the sky, or outside of the map: ahead of the camera, but on the map
    const ahead = hit ?? position.clone().add(new Vector3(Math.sin(heading), Math.cos(heading), 0).multiplyScalar(above_m));
    return new Vector3(clamp(ahead.x, limits.west, limits.east), clamp(ahead.y, limits.south, limits.north), limits.ground_m);
  }

  /** Sets the walker down by the tiles that are shown now. */
  async land() {
    const { wanted } = this, turn = ++this.turn;
    if (!wanted) return;
    const own = await this.streetOf(wanted);
    if (turn !== this.turn || this.wanted !== wanted) return;
    const { x, y } = wanted.point;
    const at = own?.at ?? new Vector3(x, y, this.rays.groundAt(x, y) ?? this.moves.limits.ground_m);
    this.moves.walkAt(at, own ? this.headingAt(own, wanted) : wanted.heading);
  }

  /** Sets the walker down for the last time, if the tiles that are seen from there have changed nothing. Returns true if the walker stands. */
  async settle() {
    const before = this.camera.position.clone(), { wanted } = this;
    await this.land();
    if (wanted && this.wanted === wanted && (++wanted.landings > MOST_LANDINGS || before.distanceTo(this.camera.position) < 0.1)) this.wanted = null;
    return !this.wanted;
  }

  async streetOf({ point, id }) {
    const tiles = this.tileset.shown;
    const rowOf = (table) => rowOfId(table, id);
    return (id && (await streetAt(tiles, point, rowOf))) || streetAt(tiles, point);
  }

  /** Along the street: towards what is picked beside it, else the way that is free and nearer to the view before. */
  headingAt({ at, heading }, { heading: before, picked }) {
    const eye = at.clone().add(new Vector3(0, 0, 1.7));
    if (picked) {
      const far_m = Math.hypot(picked.x - at.x, picked.y - at.y);
      if (far_m > 4 && far_m < SEEN_M) return headingTo(at, picked);
    }
    const [near, back] = [heading, heading + Math.PI].sort((a, b) => turnBetween(a, before) - turnBetween(b, before));
    const free = this.rays.free(eye, near);
    return free < FREE_M && this.rays.free(eye, back) > free ? back : near;
  }
}

const clamp = (value, least, most) => Math.min(most - 2, Math.max(least + 2, value));
