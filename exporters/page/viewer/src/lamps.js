// Street lamps. Lights of the tiles (--lights) throw light where they are; in runs without any, the page finds the lamps in the tiles and lights
// them itself. Only the nearest ones are lights, since each is paid in every pixel; the others are a glow, and a pool of light below.
import { AdditiveBlending, Box3, BufferGeometry, Color, Float32BufferAttribute, InstancedBufferAttribute, InstancedMesh, Matrix4, PlaneGeometry, PointLight, Points, PointsMaterial, ShaderMaterial, Vector3 } from "three";
import { CANDELA } from "./sky.js";

const LIT = 8;
/** Lamps move to other places only when the camera has moved this far. */
const STEP_M = 4;
/** A luminaire of 4,000 lm over half a sphere, at 3,000 K (compiler/props/luminaires.inc). */
const OWN = { intensity: 1300, color: new Color("#ffd3a0"), distance: 60 };
const MOST_POOLS = 3000, POOL_M = 26;

const lampName = (object) => (/^(PostTop|Arm)Lamp/.test(object.name) || !object.parent ? object.name : lampName(object.parent));

/** Returns where the lantern of a lamp's mesh is. Meshes are as glTF has them: y up, the arm towards x. */
function headOf(mesh, name) {
  const box = new Box3().setFromBufferAttribute(mesh.geometry.attributes.position);
  return new Vector3(name.startsWith("Arm") ? 0.85 * box.max.x : 0, 0.94 * box.max.y, 0);
}

/** Returns the places of the lanterns in a tile: {at, light, above_m}. */
function lanternsOf(tile, toScene) {
  const lanterns = [], seen = new Set();
  for (const mesh of tile.meshes) {
    const name = lampName(mesh);
    if (!mesh.isInstancedMesh || !/Lamp/.test(name) || seen.has(mesh.parent)) continue;
    // the parts of one lamp are meshes of one group
    if (mesh.parent.name === name) seen.add(mesh.parent);
    const head = headOf(mesh, name), matrix = new Matrix4();
    for (let i = 0; i < mesh.count; ++i) {
      mesh.getMatrixAt(i, matrix);
      const toWorld = matrix.premultiply(mesh.matrixWorld).premultiply(toScene);
      const at = head.clone().applyMatrix4(toWorld), foot = new Vector3().applyMatrix4(toWorld);
      lanterns.push({ at, light: OWN, above_m: at.z - foot.z });
    }
  }
  return lanterns;
}

const poolVertex = `attribute float above;
varying vec2 place; varying float high, far;
void main() {
  place = position.xy; high = above;
  vec4 seen = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  far = length(seen.xyz);
  gl_Position = projectionMatrix * seen;
}`;
// the illuminance of a lamp at a height, as ground of albedo 0.2 reflects it; near lamps are lights, which brighten the ground themselves
const poolFragment = `uniform vec3 light;
varying vec2 place; varying float high, far;
void main() {
  float r = length(place), d2 = high * high + r * r;
  float lux = high / (d2 * sqrt(d2)) * smoothstep(${(POOL_M / 2).toFixed(1)}, ${(POOL_M / 3).toFixed(1)}, r);
  gl_FragColor = vec4(light * (0.2 / 3.1416) * lux * smoothstep(40.0, 90.0, far), 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

function makePools() {
  const material = new ShaderMaterial({ uniforms: { light: { value: new Color() } }, vertexShader: poolVertex, fragmentShader: poolFragment,
    transparent: true, blending: AdditiveBlending, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -40 });
  const pools = new InstancedMesh(new PlaneGeometry(POOL_M, POOL_M), material, MOST_POOLS);
  pools.geometry.setAttribute("above", new InstancedBufferAttribute(new Float32Array(MOST_POOLS), 1));
  return Object.assign(pools, { frustumCulled: false, visible: false, count: 0 });
}

function makeGlow() {
  const material = new PointsMaterial({ color: "#ffd9a8", size: 0.7, transparent: true, blending: AdditiveBlending, depthWrite: false });
  return Object.assign(new Points(new BufferGeometry(), material), { frustumCulled: false, visible: false });
}

export class Lamps {
  /** @param {Object3D} group The group that tiles are added to, turned into the frame of the scene. */
  constructor(scene, group) {
    this.group = group;
    this.places = new Map();
    this.pool = Array.from({ length: LIT }, () => new PointLight("white", 0));
    this.scene = scene;
    this.pools = makePools();
    this.glow = makeGlow();
    scene.add(this.pools, this.glow);
    this.last = new Vector3(Infinity, 0, 0);
  }

  /** Takes the lights out of a tile, which is loaded before it is added to the group. */
  take(tile) {
    const lights = [];
    tile.scene.updateMatrixWorld(true);
    const toScene = tile.scene.parent ? new Matrix4() : this.group.matrixWorld;
    tile.scene.traverse((object) => object.isLight && lights.push(object));
    const own = lights.map((light) => ({ at: light.getWorldPosition(new Vector3()).applyMatrix4(toScene), light, above_m: 0 }));
    for (const light of lights) light.removeFromParent();
    this.places.set(tile, own.length > 0 ? own : lanternsOf(tile, toScene));
    if (this.places.get(tile).length > 0 && !this.pool[0].parent) this.scene.add(...this.pool);
    this.last.x = Infinity;
  }

  forget(tile) {
    this.places.delete(tile);
  }

  /** Moves the lit lamps to those nearest to the camera. */
  update(eye, shown, exposure, areLit) {
    if (eye.distanceTo(this.last) < STEP_M && this.exposure === exposure && this.areLit === areLit) return;
    this.last.copy(eye);
    [this.exposure, this.areLit] = [exposure, areLit];
    const near = shown.flatMap((tile) => this.places.get(tile) ?? []);
    near.sort((a, b) => a.at.distanceToSquared(eye) - b.at.distanceToSquared(eye));
    this.pool.forEach((light, i) => this.put(light, areLit ? near[i] : undefined));
    this.putPools(areLit ? near.filter(({ light }) => light === OWN).slice(0, MOST_POOLS) : []);
  }

  put(pooled, lamp) {
    pooled.intensity = lamp ? lamp.light.intensity * CANDELA * this.exposure : 0;
    if (!lamp) return;
    pooled.position.copy(lamp.at);
    pooled.color.copy(lamp.light.color);
    pooled.distance = lamp.light.distance;
  }

  putPools(lamps) {
    const { pools, glow } = this, above = pools.geometry.attributes.above;
    pools.visible = glow.visible = lamps.length > 0;
    pools.count = lamps.length;
    lamps.forEach(({ at, above_m }, i) => {
      pools.setMatrixAt(i, new Matrix4().makeTranslation(at.x, at.y, at.z - above_m + 0.15));
      above.setX(i, above_m);
    });
    pools.instanceMatrix.needsUpdate = above.needsUpdate = true;
    pools.material.uniforms.light.value.copy(OWN.color).multiplyScalar(OWN.intensity * CANDELA * this.exposure);
    glow.geometry.dispose();
    glow.geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lamps.flatMap(({ at }) => at.toArray()), 3));
  }
}
