// explorer.js out of the sources, and rerun.js, which runs the page's run again besides: node build.mjs FOLDER, where FOLDER holds
// node_modules.
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2] ?? here);
const { build } = createRequire(join(folder, "package.json"))("esbuild");
const common = {
  nodePaths: [join(folder, "node_modules")],
  bundle: true,
  minify: true,
  legalComments: "eof", // licences stay with what they are of
  target: "es2021",
  format: "iife",
  charset: "ascii",
  logLevel: "warning",
};
const worker = await build({ ...common, entryPoints: [join(here, "src/rerun/worker.ts")], write: false });
for (const [name, entry, define] of [
  ["rerun.js", "src/rerun/main.ts", { WORKER: JSON.stringify(worker.outputFiles[0].text) }],
  ["explorer.js", "src/main.ts", {}], // what build.sh looks for comes last
])
  await build({ ...common, entryPoints: [join(here, entry)], outfile: join(folder, name), define });
