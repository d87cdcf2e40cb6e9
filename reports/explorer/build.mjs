// Builds explorer.js, rerun.js (which also repeats the page's run) and playground.js from the sources:
// node build.mjs FOLDER, where FOLDER holds node_modules.
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
  legalComments: "eof", // keeps the licences of libraries
  target: "es2021",
  format: "iife",
  charset: "ascii",
  loader: { ".css": "text" },
  logLevel: "warning",
};
const program = async (of) => JSON.stringify((await build({ ...common, entryPoints: [join(here, of)], write: false })).outputFiles[0].text);
for (const [name, entry, define] of [
  ["playground.js", "src/playground/main.ts", { PLAYGROUND_WORKER: await program("src/playground/worker.ts"), WORKER: '""' }],
  ["rerun.js", "src/rerun/main.ts", { WORKER: await program("src/rerun/worker.ts") }],
  ["explorer.js", "src/main.ts", {}], // last, because build.sh checks this file
])
  await build({ ...common, entryPoints: [join(here, entry)], outfile: join(folder, name), define });
