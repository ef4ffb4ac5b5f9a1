// validate_glb.mjs FILE.glb…: runs Khronos' glTF validator; fails on any error or warning. Prints one line for each kind of message,
// and the counts.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import validator from "gltf-validator";

const totals = { files: 0, errors: 0, warnings: 0, infos: 0 };
const codes = new Map();
for (const path of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
    maxIssues: 100000,
    // files of glb/shared
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(path), uri))),
  });
  totals.files += 1;
  totals.errors += issues.numErrors;
  totals.warnings += issues.numWarnings;
  totals.infos += issues.numInfos;
  for (const message of issues.messages) {
    const key = `${["error", "warning", "info", "hint"][message.severity]} ${message.code}`;
    const seen = codes.get(key) ?? { count: 0, example: `${path} ${message.pointer ?? ""}: ${message.message}` };
    seen.count += 1;
    codes.set(key, seen);
  }
}
for (const [key, { count, example }] of codes) console.log(`${count} ${key}, e.g. ${example}`);
console.log(`${totals.files} files: ${totals.errors} errors, ${totals.warnings} warnings, ${totals.infos} infos`);
process.exit(totals.errors + totals.warnings > 0 ? 1 : 0);
