// What the page adds to the materials of tiles: haze with the distance, and windows that are lit by night in runs that were compiled for a day.
import { Vector3 } from "three";

/** A black object at the distance of visibility keeps 2 % of its contrast. */
const LOST = 3.912;

/** Uniforms that all materials share. `table` is the sky's (sky.js), `lit` the radiance of a lit window. */
export const uniforms = { table: { value: null }, haze: { value: 0 }, lit: { value: 0 }, eye: { value: new Vector3() } };

/** Sets the visibility, in metres. */
export function setVisibility(visibility_m) {
  uniforms.haze.value = LOST / visibility_m;
}

// panes are smooth; a third of the rooms is lit, each in a warmer or colder white
const WINDOWS = `
vec3 room = floor(placeAt / vec3(3.7, 3.7, 3.0));
float draw = fract(sin(dot(room, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
float pane = 1.0 - smoothstep(0.12, 0.3, roughnessFactor);
totalEmissiveRadiance += lit * pane * step(draw, 0.35) * mix(vec3(1.0, 0.5, 0.16), vec3(1.0, 0.72, 0.42), fract(draw * 91.0));`;

const HAZE = `
vec3 way = placeAt - eye;
float part = 1.0 - exp(-haze * length(way));
outgoingLight = mix(outgoingLight, texture2D(table, vec2(atan(way.y, way.x) / 6.28318530718, 0.5 / float(textureSize(table, 0).y))).rgb, part);`;

const PLACE = `
vec4 placeNow = vec4(transformed, 1.0);
#ifdef USE_INSTANCING
placeNow = instanceMatrix * placeNow;
#endif
placeAt = (modelMatrix * placeNow).xyz;`;

/** True for materials whose panes are lit: glass of buildings, and walls with a picture of their windows. */
const hasWindows = (mesh) => mesh.userData.layer === "buildings" && /FacadeAtlas|^Glass/.test(mesh.material.name);

/** Adds haze and windows to the material of a mesh. A material that two meshes share is changed once. */
export function prepare(mesh) {
  const { material } = mesh;
  if (material.userData.isPrepared || !material.isMeshStandardMaterial) return;
  const isWall = hasWindows(mesh);
  material.userData.isPrepared = true;
  material.customProgramCacheKey = () => (isWall ? "windows" : "haze");
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader.replace("void main() {", "varying vec3 placeAt;\nvoid main() {").replace("#include <project_vertex>", `#include <project_vertex>${PLACE}`);
    shader.fragmentShader = shader.fragmentShader.replace("void main() {", "uniform sampler2D table;\nuniform float haze, lit;\nuniform vec3 eye;\nvarying vec3 placeAt;\nvoid main() {")
      .replace("#include <emissivemap_fragment>", `#include <emissivemap_fragment>${isWall ? WINDOWS : ""}`)
      .replace("#include <opaque_fragment>", `${HAZE}\n#include <opaque_fragment>`);
  };
}
