// One file, explorer.js, out of the sources: node build.mjs FOLDER, where FOLDER holds node_modules.
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2] ?? here);
const { build } = createRequire(join(folder, "package.json"))("esbuild");
await build({
  entryPoints: [join(here, "src/main.ts")],
  nodePaths: [join(folder, "node_modules")],
  outfile: join(folder, "explorer.js"),
  bundle: true,
  minify: true,
  legalComments: "eof", // licences stay with what they are of
  target: "es2021",
  format: "iife",
  charset: "ascii",
  logLevel: "warning",
});
