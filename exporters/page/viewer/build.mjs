// build.mjs [FOLDER]: makes the files of the page: one bundle, the page, its style, Draco's decoder, and the licences of all that is in the
// bundle. FOLDER is ../files unless given.
import { build } from "esbuild";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../files");
mkdirSync(out, { recursive: true });

const { metafile } = await build({
  absWorkingDir: here, entryPoints: ["src/main.js"], outfile: join(out, "viewer.js"), bundle: true, minify: true, format: "esm",
  target: "es2022", metafile: true, legalComments: "none", logLevel: "error",
});

// the packages of which something is in the bundle
const packages = new Set(Object.values(metafile.outputs).flatMap(({ inputs }) => Object.keys(inputs))
  .filter((path) => metafile.inputs[path].bytes > 0).map((path) => path.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean));

const licences = [...packages].sort().map((name) => {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json")));
  return `${name} ${version} (${license})\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
});
licences.push(`Draco's decoder 1.5 (Apache-2.0): draco_decoder.wasm, draco_wasm_wrapper.js\nCopyright the Draco Authors, https://github.com/google/draco. The text of the licence is that of 3d-tiles-renderer above.\n`);
licences.push(`meshopt_decoder (MIT), in viewer.js\nCopyright (c) 2016-2026 Arseny Kapoulkine, https://github.com/zeux/meshoptimizer. The text of the licence is that of three above.\n`);
writeFileSync(join(out, "licences.txt"), licences.join(`\n${"-".repeat(80)}\n\n`));

for (const name of ["index.html", "style.css"]) copyFileSync(join(here, name), join(out, name));
for (const name of ["draco_decoder.wasm", "draco_wasm_wrapper.js"])
  copyFileSync(join(here, "node_modules/three/examples/jsm/libs/draco/gltf", name), join(out, name));
