// The sky that is shown: a table of radiance that citykiln computed for each time of page.json and the page loads when it is chosen, sun or moon
// as a light, and the light that the sky throws on everything. Radiances are multiplied by the exposure before they go to the graphics card,
// so that nights keep their digits.
import * as THREE from "three";
import { byId, make } from "./dom.js";
import { fetchJson } from "./records.js";
import { uniforms as shared } from "./surfaces.js";

/** The radiance of material emission at 1, and of one candela a square metre, in the unit of the tables (compiler/sky/generate.h). */
const EMISSION = 100 / 6250;
export const CANDELA = 1 / 6250;
/** Luminance of a lit window, in candela a square metre. */
const WINDOW_CD_M2 = 40;
/** White ground under street lamps; darker places are not brightened further. */
const LEAST_WHITE = 0.002;
/** Level white ground in the picture, where the tone curve starts to bend below 1. */
const KEY = 1.5;
/** The share by which eyes get used to the colour of the light. */
const ADAPTED = 0.7;

const vertexShader = `varying vec3 to;
void main() {
  to = position;
  gl_Position = projectionMatrix * mat4(mat3(modelViewMatrix)) * vec4(position, 1.0);
  gl_Position = gl_Position.xyww;
}`;
const fragmentShader = `uniform sampler2D table;
uniform vec3 ground, toSun, disk;
uniform float haze, above;
varying vec3 to;
void main() {
  vec3 d = normalize(to);
  float rows = float(textureSize(table, 0).y);
  float turn = atan(d.y, d.x) / 6.28318530718;
  vec3 c = texture2D(table, vec2(turn, (0.5 + sqrt(max(d.z, 0.0)) * (rows - 1.0)) / rows)).rgb;
  // level ground around the map, in the haze of its distance
  if (d.z < 0.0) c = mix(ground, c, 1.0 - exp(-haze * above / max(-d.z, 0.0001)));
  c += disk * smoothstep(0.99998, 0.99999, dot(d, toSun));
  gl_FragColor = vec4(c, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

function makeDome() {
  const uniforms = { table: { value: null }, ground: { value: new THREE.Color() }, toSun: { value: new THREE.Vector3(0, 0, 1) }, disk: { value: new THREE.Color() }, above: { value: 100 }, haze: shared.haze };
  const material = new THREE.ShaderMaterial({ uniforms, vertexShader, fragmentShader, side: THREE.BackSide, depthWrite: false });
  const dome = new THREE.Mesh(new THREE.SphereGeometry(1, 48, 32), material);
  dome.frustumCulled = false;
  dome.renderOrder = -1;
  return dome;
}

/** Returns the factors on red, green and blue by which white ground is exposed, and looks nearly white. */
function exposureOf([r, g, b]) {
  const grey = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const exposure = KEY / Math.max(grey, LEAST_WHITE);
  return [r, g, b].map((c) => (grey > LEAST_WHITE ? exposure * (grey / Math.max(c, 0.1 * grey)) ** ADAPTED : exposure));
}

function textureOf({ columns, rows, radiance }, gains) {
  const texels = new Uint16Array(columns * rows * 4);
  for (let i = 0; i < columns * rows; ++i) {
    for (let c = 0; c < 3; ++c) texels[4 * i + c] = THREE.DataUtils.toHalfFloat(Math.min(radiance[3 * i + c] * gains[c], 60000));
    texels[4 * i + 3] = THREE.DataUtils.toHalfFloat(1);
  }
  const texture = new THREE.DataTexture(texels, columns, rows, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.wrapS = THREE.RepeatWrapping;
  texture.needsUpdate = true;
  return texture;
}

export class Sky {
  constructor(scene, renderer, page, progress, changed) {
    this.scene = scene;
    this.progress = progress;
    this.toLight = new THREE.Vector3(0, 0, 1);
    this.areWindowsBaked = Boolean(page.skies.find((sky) => sky.is_of_run)?.are_lamps_lit);
    this.page = page;
    this.changed = changed;
    this.exposure = 1;
    this.tables = {};
    this.dome = makeDome();
    this.sun = new THREE.DirectionalLight();
    this.maker = new THREE.PMREMGenerator(renderer);
    scene.add(this.dome, this.sun, this.sun.target);
    const options = page.skies.map((sky, i) => make("option", { value: String(i) }, sky.is_of_run ? `${sky.label}, the run's time` : sky.label));
    byId("time").append(...options);
    byId("time").addEventListener("change", (event) => this.set(Number(event.target.value)));
  }

  /** Shows the sky with a number, when its table is loaded. */
  async set(number) {
    const sky = this.page.skies[number];
    if (!sky) return;
    this.number = number;
    byId("time").value = String(number);
    this.tables[number] ??= this.progress.during("the sky", fetchJson(sky.file));
    const table = await this.tables[number];
    // another one may have been chosen meanwhile
    if (this.number === number) this.show(sky, table);
  }

  show(sky, table) {
    const gains = exposureOf(table.white_ground);
    const colour = (rgb) => new THREE.Color().setRGB(...rgb.map((c, i) => c * gains[i]));
    this.exposure = gains[1];
    const { uniforms } = this.dome.material;
    uniforms.table.value?.dispose();
    shared.table.value = uniforms.table.value = textureOf(table, gains);
    // the tiles of a run by night have lit windows of their own
    shared.lit.value = sky.are_lamps_lit && !this.areWindowsBaked ? WINDOW_CD_M2 * CANDELA * this.exposure : 0;
    uniforms.ground.value = colour(table.ground);
    uniforms.toSun.value.fromArray(table.to_light);
    this.toLight.fromArray(table.to_light);
    this.sun.position.copy(this.toLight).multiplyScalar(1000);
    this.sun.color = colour(table.light);
    this.setEnvironment();
    uniforms.disk.value = colour(table.disk.map((c) => Math.min(c, 500 / this.exposure)));
    this.showNote(sky);
    this.changed();
  }

  // the sky without the disk, which is a light of its own
  setEnvironment() {
    this.dome.material.uniforms.disk.value = new THREE.Color(0, 0, 0);
    this.dome.removeFromParent();
    const only = new THREE.Scene();
    only.add(this.dome);
    this.environment?.dispose();
    this.environment = this.maker.fromScene(only, 0, 0.1, 10);
    this.scene.environment = this.environment.texture;
    this.scene.add(this.dome);
  }

  /** Windows and signals glow at their own luminance, which is faint by day. */
  apply(tile) {
    for (const mesh of tile.meshes) {
      const material = mesh.userData.own ?? mesh.material;
      if (material.emissive) material.emissiveIntensity = EMISSION * this.exposure;
    }
  }

  showNote(sky) {
    const run = this.page.skies.find((each) => each.is_of_run);
    const text = !this.areWindowsBaked
      ? "The page lights windows and lamps by night. Compile with --time 2026-12-21T18:00 for those of an hour, as previews show them."
      : sky.is_of_run ? "" : `Windows and lamps are those of ${run.label}.`;
    byId("time-note").textContent = text;
  }
}
