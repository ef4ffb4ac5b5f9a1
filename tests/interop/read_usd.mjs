// read_usd.mjs FACTS FOLDER FILE…: reads layers of USD with tinyusdz and three's USDLoader, each without composing them.
// Writes FACTS, JSON: for each file, `three`, a list of meshes with `path`, `vertices`, `triangles`, `low` and `high`, and
// `tinyusdz`, the path of the layer as tinyusdz prints it, in FOLDER.
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

// both are made for browsers
Object.defineProperty(process, 'type', { value: 'renderer' });
globalThis.WorkerGlobalScope = class {};
globalThis.self = globalThis;
globalThis.location = { href: 'file:///' };

const here = new URL('.', import.meta.url).pathname;
const { default: tinyusdz } = await import('tinyusdz');
const { Box3, ImageLoader } = await import('three');
const { USDLoader } = await import('three/addons/loaders/USDLoader.js');
ImageLoader.prototype.load = (url, done) => done({ width: 1, height: 1 }); // no images without a browser

const tiny = await tinyusdz({ wasmBinary: readFileSync(join(here, 'node_modules/tinyusdz/tinyusdz.wasm')) });

function readWithTinyusdz(file, folder) {
  const loader = new tiny.TinyUSDZLoaderNative();
  if (!loader.loadAsLayerFromBinary(new Uint8Array(readFileSync(file)), basename(file))) throw new Error(`${file}: ${loader.error()}`);
  const out = join(folder, `${basename(file)}.tinyusdz.usda`);
  writeFileSync(out, loader.layerToString());
  loader.delete();
  return out;
}

function pathOf(object) {
  return object.parent ? `${pathOf(object.parent)}/${object.name}` : '';
}

function readWithThree(file) {
  const bytes = readFileSync(file);
  const group = new USDLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  const meshes = [];
  group.traverse((object) => {
    if (!object.isMesh) return;
    const { position } = object.geometry.attributes;
    const { min, max } = new Box3().setFromBufferAttribute(position);
    const corners = object.geometry.index ? object.geometry.index.count : position.count;
    meshes.push({ path: pathOf(object), vertices: position.count, triangles: corners / 3, low: min.toArray(), high: max.toArray() });
  });
  return meshes;
}

const [facts, folder, ...files] = process.argv.slice(2);
const found = files.map((file) => ({ file, three: readWithThree(file), tinyusdz: readWithTinyusdz(file, folder) }));
writeFileSync(facts, JSON.stringify(found));
