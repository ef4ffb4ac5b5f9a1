// The page as a new reader uses it: walks on a street, searches by parts of names, refuses places that are not there, and is read in words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { OpenPage, axeFaults, distance, isSerious, luminance, meanLuminance, shareOf, openForTests } from "./open_page.mjs";

const open = await openForTests(), { page } = open;

const status = () => open.text("#status");
const search = async (text) => {
  await page.fill("#place", text);
  await page.click("#go > .row button");
};

/** The class of what is below the walker's feet, and how far the eyes are above it. */
const below = () => page.evaluate(async () => {
  const { camera, rays, tileset } = window.citykiln;
  const floor = rays.floorBelow(camera.position);
  rays.down.set(camera.position.clone(), rays.down.ray.direction);
  const [hit] = rays.down.intersectObject(tileset.tiles.group, true);
  const table = await hit.object.userData.loaded.table;
  return { above: camera.position.z - floor, kind: table.classes[hit.object.geometry.attributes._feature_id_0.getX(hit.face.a)] };
});

test("no finding is shown at first, and none outside of the map is ever marked", async () => {
  assert.equal(await page.inputValue("#finding-code"), "none");
  assert.equal(await page.evaluate(() => window.citykiln.findings.placed.length), 0);
  await page.evaluate(() => {
    const { findings } = window.citykiln;
    findings.all.push({ properties: { code: "MissingNode", severity: "note", id: "w1" }, geometry: { type: "Point", coordinates: [20, 50] } }, { properties: { code: "MissingNode", severity: "note", id: "w1" }, geometry: null });
  });
  await page.selectOption("#finding-code", "");
  const outside = await page.evaluate(() => {
    const { findings, limits } = window.citykiln, { position } = findings.marks.geometry.attributes;
    return Array.from({ length: position.count }, (_, i) => i).filter((i) => position.getX(i) < limits.west || position.getX(i) > limits.east || position.getY(i) < limits.south || position.getY(i) > limits.north).length;
  });
  assert.equal(outside, 0);
  const before = (await open.camera()).at;
  const buttons = page.locator("#findings li button"), count = await buttons.count();
  await buttons.nth(count - 2).click();
  assert.match(await status(), /outside of the map/);
  await buttons.nth(count - 1).click();
  assert.match(await status(), /no place on the map/);
  assert.deepEqual((await open.camera()).at, before);
  await page.selectOption("#finding-code", "none");
});

test("walk begins on the street that is looked at", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  await page.click("#walk");
  await open.still();
  const { above, kind } = await below();
  assert.match(kind, /Road|Street|Path|Square/);
  assert.ok(Math.abs(above - 1.7) < 0.05, String(above));
  assert.ok(await page.evaluate(() => window.citykiln.camera.near <= 0.3), "the near plane fits the height");
  await page.click("#fly");
});

test("walk from high above, or while the sky is looked at, begins on the map", async () => {
  for (const [x, y, above, pitch] of [[0, 0, 800, 0.2], [2500, 0, 300, -0.1], [0, -3000, 800, -0.3]]) {
    await page.evaluate(([x, y, above, pitch]) => {
      const { camera, moves, page } = window.citykiln;
      moves.setMode("fly");
      camera.position.set(x, y, page.ground_m + above);
      moves.stand();
      moves.look(0, pitch);
    }, [x, y, above, pitch]);
    await page.click("#walk");
    await open.still();
    const [at, limits] = await page.evaluate(() => [window.citykiln.camera.position.toArray(), window.citykiln.limits]);
    assert.ok(at[0] > limits.west && at[0] < limits.east && at[1] > limits.south && at[1] < limits.north, String(at));
    assert.ok(Math.abs((await below()).above - 1.7) < 0.05);
  }
  await page.click("#fly");
});

test("walk begins on the street that is searched, and looks along it", async () => {
  await search("Lindenallee");
  await page.waitForSelector("#feature:not([hidden])");
  await page.click("#walk");
  await open.still();
  assert.equal((await below()).kind, "ResidentialRoad");
  const free = await page.evaluate(() => window.citykiln.rays.free(window.citykiln.camera.position, window.citykiln.moves.heading));
  assert.ok(free > 5, `a wall is ${free} m ahead`);
  const { id } = await page.evaluate(async () => {
    const { camera, rays, tileset } = window.citykiln;
    rays.down.set(camera.position.clone(), rays.down.ray.direction);
    const [hit] = rays.down.intersectObject(tileset.tiles.group, true);
    const table = await hit.object.userData.loaded.table;
    return { id: String(table.ids[hit.object.geometry.attributes._feature_id_0.getX(hit.face.a)]) };
  });
  const [, wanted] = await page.evaluate(() => window.citykiln.records.names().then((names) => names.find(([name]) => name === "Lindenallee")));
  assert.equal(`w${id}`, wanted);
  await page.click("#fly");
});

test("walkers stay on the map", async () => {
  await page.evaluate(() => {
    const { camera, moves, limits } = window.citykiln;
    camera.position.set(limits.east - 5, 0, limits.ground_m + 1.7);
    moves.mode = "walk";
    moves.look(Math.PI / 2, 0);
    for (let i = 0; i < 100; ++i) moves.step({ ahead: 1, aside: 0, up: 0 });
  });
  assert.ok(await page.evaluate(() => window.citykiln.camera.position.x <= window.citykiln.limits.east));
  await page.click("#home");
  await open.still();
});

test("walls stop walkers, who then go along them", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  await page.click("#walk");
  await open.still();
  const [far, walked, along] = await page.evaluate(() => {
    const { camera, moves, rays } = window.citykiln, from = camera.position.clone();
    // how far a wall is that one walks straight at
    const wallAhead = (heading) => {
      rays.level.set(from.clone().setZ(from.z - 0.7), from.clone().set(Math.sin(heading), Math.cos(heading), 0));
      rays.level.far = 60;
      const [hit] = rays.level.intersectObject(rays.group, true);
      return hit?.object.userData.layer === "buildings" && hit.face.normal.clone().transformDirection(hit.object.matrixWorld).dot(rays.level.ray.direction) < -0.9 ? hit.distance : Infinity;
    };
    const [far, heading] = Array.from({ length: 72 }, (_, i) => (i * Math.PI) / 36).map((each) => [wallAhead(each), each]).sort((a, b) => a[0] - b[0])[0];
    moves.look(heading, 0);
    for (let i = 0; i < 2 * far + 20; ++i) moves.step({ ahead: 0.5, aside: 0, up: 0 });
    const walked = camera.position.clone().sub(from).dot(from.clone().set(Math.sin(heading), Math.cos(heading), 0)), stopped = camera.position.clone();
    moves.look(heading + 1.2, 0);
    for (let i = 0; i < 4; ++i) moves.step({ ahead: 0.5, aside: 0, up: 0 });
    return [far, walked, Math.hypot(camera.position.x - stopped.x, camera.position.y - stopped.y)];
  });
  console.log(`# a wall ${far.toFixed(1)} m ahead stops after ${walked.toFixed(1)} m; ${along.toFixed(1)} of 2 m along it`);
  assert.ok(walked < far + 1 && walked > far - 2, `${walked} m towards a wall ${far} m away`);
  assert.ok(along > 0.5);
  await page.click("#fly");
});

test("swapped and outside coordinates are refused with the map's box", async () => {
  const before = (await open.camera()).at;
  await search("12.3000, 48.7000");
  assert.match(await status(), /Latitude comes first: 48.7, 12.3 is on the map\..*latitudes 48\.69\d+ to 48\.70\d+ and longitudes 12\.2\d+ to 12\.3\d+/);
  await search("43.73, 7.42");
  assert.match(await status(), /43.73, 7.42 is outside of the map\. The map spans latitudes 48\.69/);
  assert.deepEqual((await open.camera()).at, before);
});

test("names are suggested while one types, by parts and without accents", async () => {
  const suggested = async (text) => {
    await page.fill("#place", "");
    await page.locator("#place").pressSequentially(text);
    await page.waitForTimeout(150);
    return page.locator("#matches bdi").allInnerTexts();
  };
  assert.deepEqual(await suggested("farber"), ["Färbergasse"]);
  assert.deepEqual(await suggested("bahnhofstrasse"), ["Bahnhofstraße"]);
  assert.ok((await suggested("allee")).length >= 3);
  assert.deepEqual(await suggested("xyz"), []);
  await suggested("linden");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.waitForSelector("#feature:not([hidden])");
  assert.equal(await open.text("#feature-title"), "Lindenallee");
});

test("all that share a name are listed, the ways of one street once", async () => {
  await page.evaluate(async () => {
    const names = await window.citykiln.records.names();
    names.push(["Zwilling", "w3", "House", 0, 0], ["Zwilling", "w4", "ResidentialRoad", 0, 0], ["Zwilling", "w5", "ResidentialRoad", 90, 0], ["Zwilling", "w6", "ResidentialRoad", 900, 0],
      ["شارع الملك", "w9", "ResidentialRoad", 0, 0], ["Чайковского улица", "w10", "ResidentialRoad", 0, 0], ["東京駅", "w11", "House", 0, 0]);
  });
  await search("zwilling");
  await page.waitForFunction(() => document.querySelectorAll("#matches button").length === 3);
  assert.deepEqual((await page.locator("#matches button").allInnerTexts()).sort(), ["Zwilling house", "Zwilling residential road", "Zwilling residential road, 2 parts"]);
});

test("names in other scripts are found and shown in their own direction", async () => {
  for (const [typed, name] of [["الملك", "شارع الملك"], ["чаиковского", "Чайковского улица"], ["東京", "東京駅"]]) {
    await page.fill("#place", typed);
    await page.waitForFunction((name) => document.querySelector("#matches bdi")?.textContent === name, name);
  }
  // a name that runs from right to left does not move the words beside it
  await page.fill("#place", "الملك");
  await page.waitForFunction(() => document.querySelector("#matches bdi")?.textContent.includes("الملك"));
  const [name, all] = await page.evaluate(() => [document.querySelector("#matches bdi"), document.querySelector("#matches button")].map((element) => element.getBoundingClientRect().toJSON()));
  assert.ok(name.left - all.left < 20, "the name stands first");
  await page.fill("#place", "");
});

test("names are shown in English by option, and in their own direction", async () => {
  const id = await page.evaluate(async () => {
    const { records } = window.citykiln, [, id] = (await records.names()).find(([name]) => name === "Lindenallee"), record = await records.find(id);
    Object.assign(record, { name: "شارع الملك", tags: { ...record.tags, "name:en": "King Street" } });
    await window.citykiln.pick(id);
    return id;
  });
  assert.equal(await open.text("#feature-title"), "شارع الملك");
  assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById("feature-title")).direction), "rtl");
  await page.selectOption("#names", "en");
  await page.waitForFunction(() => document.getElementById("feature-title").textContent === "King Street");
  await page.waitForFunction(() => location.hash.includes("names=en"));
  await page.selectOption("#names", "local");
  await page.evaluate((id) => window.citykiln.records.find(id).then((record) => Object.assign(record, { name: "Lindenallee" })), id);
});

test("links and ids that lead to nothing say so", async () => {
  for (const [hash, words] of [["id=w999999", /way 999999, which is not on this map/], ["x=9e9&y=0&z=3", /outside of the map/]]) {
    await page.evaluate((hash) => (location.hash = hash), hash);
    await page.waitForFunction((source) => new RegExp(source).test(document.getElementById("status").textContent), words.source);
  }
});

test("the address follows the view", async () => {
  await open.put(40, -160, 70, 0.3, -0.45);
  await page.waitForFunction(() => location.hash.includes("x=40&y=-160"));
  await page.selectOption("#colours", "level");
  await open.still();
  await page.waitForFunction(() => location.hash.includes("colours=level"));
  await page.selectOption("#colours", "none");
});

test("the compass turns with the view, and a press turns to the north; the bar is as long as it says", async () => {
  await open.put(0, 0, 200, 1, -1.5);
  await page.evaluate(() => window.citykiln.draw());
  assert.match(await page.evaluate(() => document.getElementById("needle").style.transform), /rotate\(-1(\.0+)?rad\)/);
  const [text, metres] = await page.evaluate(() => {
    const { rays } = window.citykiln, width = document.getElementById("scene").clientWidth, px = document.getElementById("scale-bar").getBoundingClientRect().width;
    const [a, b] = [rays.at(-px / width, 0), rays.at(px / width, 0)];
    return [document.getElementById("scale-text").textContent, a.point.distanceTo(b.point)];
  });
  assert.ok(Math.abs(parseFloat(text) - metres) < 0.15 * metres, `${text}, measured ${metres}`);
  await page.click("#compass");
  assert.equal((await open.camera()).heading, 0);
});

test("? opens the help, and Escape closes it", async () => {
  await page.focus("#scene");
  await page.keyboard.press("?");
  assert.ok(await page.isVisible("#help"));
  assert.match(await open.text("#help"), /pinch/);
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#help"));
});

test("words of people, not of the program", async () => {
  const ids = await page.evaluate(() => window.citykiln.records.names().then((names) => names.map(([, id]) => id)));
  for (const id of ["w35", ...ids.slice(0, 10)]) {
    await page.evaluate((id) => window.citykiln.pick(id), id);
    const text = (await open.text("#feature")).replaceAll("OpenStreetMap", "");
    assert.doesNotMatch(text, /\b[nwr]\d+\b|[a-z][A-Z]|[sdpc]\|/, text);
  }
  await page.evaluate(() => window.citykiln.pick("w35"));
  assert.match(await open.text("#feature-text"), /Residential road[\s\S]*2 traffic lanes \(1 each way\), 2 pavements/);
});

test("a bar says what is loading, and a plate stands there until the first tile does", async () => {
  const other = await OpenPage.start({ size: { width: 400, height: 200 } }), slow = other.page;
  let letGo;
  const held = new Promise((resolve) => (letGo = resolve));
  await slow.route(/\.glb/, async (route) => (await held, route.continue()));
  await slow.goto(`${process.env.PAGE_URL}#detail=20`);
  await slow.waitForFunction(() => /^Loading tiles: \d+ of \d+$/.test(document.getElementById("loading-text").innerText) && window.citykiln.sky.environment);
  assert.ok(await slow.evaluate(() => window.citykiln.plate.visible));
  letGo();
  await slow.waitForFunction(() => window.citykiln.isStill && document.getElementById("loading").hidden);
  assert.equal(await slow.evaluate(() => window.citykiln.plate.visible), false);
  await other.close();
});

test("the page lights windows and lamps of a run that was compiled for a day", async () => {
  await open.put(0, -160, 40, 0, -0.3);
  await page.selectOption("#time", { label: (await page.locator("#time option").allInnerTexts()).find((text) => text.startsWith("00:00")) });
  const picture = await open.picture(1);
  const isWindow = (pixel) => luminance(pixel) > 110 && pixel[0] > pixel[2] + 25;
  console.log(`# mean luminance ${meanLuminance(picture).toFixed(0)}, ${(shareOf(picture, isWindow) * 100).toFixed(2)} % lit windows`);
  assert.ok(shareOf(picture, isWindow) > 0.0005);
  const lamps = await page.evaluate(() => window.citykiln.lamps.pool.filter((light) => light.intensity > 0).map((light) => light.position.toArray()));
  assert.ok(lamps.length > 0, "no lamp is lit");
  const [x, y] = lamps[0];
  await open.put(x, y - 12, 8, 0, -0.5);
  const lit = await open.picture(1);
  await page.evaluate(() => window.citykiln.lamps.pool.forEach((light) => (light.intensity = 0)));
  assert.ok(meanLuminance(lit) > 1.2 * meanLuminance(await open.picture(1)));
  await page.selectOption("#time", { label: (await page.locator("#time option").allInnerTexts()).find((text) => text.includes("the run's time")) });
});

test("the sun throws shadows", async () => {
  await page.selectOption("#detail", "6");
  await open.put(0, -160, 40, 0, -0.5);
  const shaded = await open.picture(4);
  assert.ok(await page.evaluate(() => window.citykiln.sky.sun.castShadow));
  await page.selectOption("#detail", "20");
  await page.evaluate(() => (window.citykiln.tileset.tiles.errorTarget = 6));
  const plain = await open.picture(2);
  const darker = plain.filter((pixel, i) => luminance(pixel) > luminance(shaded[i] ?? pixel) + 25).length / plain.length;
  console.log(`# ${(darker * 100).toFixed(1)} % of the picture is in shadow`);
  assert.ok(darker > 0.02);
  await page.selectOption("#detail", "20");
});

test("colours are those of the legend to the digit", async () => {
  for (const mode of ["level", "error", "source"]) {
    await open.put(0, -160, 70, 0, -0.45);
    await page.selectOption("#colours", mode);
    const picture = await open.picture(1), rows = await page.evaluate(() => window.citykiln.colours.rows());
    const hexes = rows.map(([hex]) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)));
    const exact = shareOf(picture, (pixel) => hexes.some((hex) => distance(hex, pixel) < 3));
    console.log(`# ${mode}: ${(100 * exact).toFixed(0)} % of the pixels have a colour of the legend`);
    assert.ok(exact > 0.5, mode);
    await page.selectOption("#colours", "none");
  }
});

test("a picture stays within its budget of triangles", async () => {
  await open.put(0, -160, 40, 0, -0.3);
  await page.evaluate(() => (window.citykiln.budget.triangles = 30000, window.citykiln.tileset.setDetail(2)));
  await page.selectOption("#detail", "2");
  const before = await page.evaluate(() => window.citykiln.renderer.info.render.triangles);
  await open.still();
  const [triangles, factor] = await page.evaluate(() => [window.citykiln.renderer.info.render.triangles, window.citykiln.budget.factor]);
  console.log(`# ${before} to ${triangles} triangles, errors ${factor.toFixed(1)} times as large`);
  assert.ok(factor > 1);
  await page.evaluate(() => (window.citykiln.budget.triangles = 3e6, window.citykiln.budget.turn(1)));
  await page.selectOption("#detail", "20");
});

test("the memory of a tile counts a picture once, however many materials share it", async () => {
  await open.put(0, -160, 70, 0, -0.45);
  const [bytes, shared] = await page.evaluate(() => {
    const { tiles, loaded } = window.citykiln.tileset, textures = new Set(), sources = new Set();
    const [tile, own] = [...loaded].sort(([a], [b]) => tiles.lruCache.getMemoryUsage(b) - tiles.lruCache.getMemoryUsage(a))[0];
    const buffers = new Set();
    for (const { material, geometry } of own.meshes) {
      for (const value of Object.values(material)) if (value?.isTexture) textures.add(value), sources.add(value.source);
      for (const attribute of [geometry.index, ...Object.values(geometry.attributes)]) buffers.add((attribute?.data ?? attribute)?.array);
    }
    const pixels = (texture) => texture.source.data.width * texture.source.data.height;
    const most = [...buffers].reduce((sum, array) => sum + (array?.byteLength ?? 0), 0) + [...sources].reduce((sum, { data }) => sum + data.width * data.height * 6, 0);
    return [[tiles.lruCache.getMemoryUsage(tile), most], [textures.size, sources.size, [...textures].reduce((sum, texture) => sum + pixels(texture), 0)]];
  });
  console.log(`# ${(bytes[0] / 1e6).toFixed(1)} MB; ${shared[0]} textures of ${shared[1]} pictures`);
  assert.ok(shared[0] > shared[1], "no picture is shared, so this shows nothing");
  assert.ok(bytes[0] < 1.3 * bytes[1], `${bytes[0]} bytes for ${bytes[1]}`);
});

test("axe finds no serious fault", async () => {
  await page.evaluate(() => window.citykiln.pick("w35"));
  await page.fill("#place", "allee");
  assert.deepEqual((await axeFaults(open)).filter(isSerious), []);
});

test("the page throws no errors", () => assert.deepEqual(open.errors, []));
