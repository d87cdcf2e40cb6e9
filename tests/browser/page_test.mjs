// What pages promise: page_test.mjs FOLDER-OF-PACKAGES FOLDER-OF-PAGES SOURCES FILE [SURFACES.ply]. They are small and
// hold the surfaces that are exported, no number is broken on a telephone or on paper, charts answer.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { check, failures, firstFrame, open, settle, start, textOf } from "./browser.mjs";

const [packages, pages, sources, file, surfaces] = process.argv.slice(2);
const { buildSync } = createRequire(join(resolve(packages), "package.json"))("esbuild");
const program = buildSync({ entryPoints: [join(sources, "packed.ts")], nodePaths: [join(resolve(packages), "node_modules")], bundle: true, format: "esm", write: false }).outputFiles[0].text;
const { unpacked } = await import(`data:text/javascript;base64,${Buffer.from(program).toString("base64")}`);

const html = readFileSync(join(pages, file), "utf8");
const textOfId = (id) => new RegExp(`id="${id}">([^<]*)</script>`).exec(html)[1];
const data = JSON.parse(textOfId("data"));
check(`${file} is at most 4 MB`, html.length <= 4e6, html.length);

/** Every vertex of the last frame of run 0 lies within half a step of the exported one, and a step is small. */
function vertices() {
  const run = data.runs[0], columns = 7 + run.measures.length, heads = [];
  const vertexCounts = run.meshes.map((k) => data.meshes[k].reduce((most, v) => Math.max(most, v), -1) + 1);
  let offset = 0;
  for (const [time, step, cells, contacts, connections, size, vertexForces] of run.frames) {
    heads.push({ time, step, cells, contacts, connections, offset, size, vertexForces });
    offset += size;
  }
  const bytes = unpacked(Buffer.from(textOfId("frames-0"), "base64"), heads, { ...run, vertexCounts });
  const ply = readFileSync(surfaces), head = ply.indexOf("end_header\n"), from = head + 11, size = 19; // bytes of a vertex
  const exact = Array.from({ length: Number(/element vertex (\d+)/.exec(ply.toString("latin1", 0, head))[1]) }, (_, v) => [0, 4, 8].map((k) => ply.readFloatLE(from + size * v + k)));
  const last = heads[heads.length - 1], words = new Uint32Array(bytes, last.offset), reals = new Float32Array(bytes, last.offset);
  let place = last.offset + 4 * (last.cells * (columns + 3 * run.netForces.length) + 3 * last.contacts + 2 * last.connections), at = 0, worst = 0;
  for (let i = 0; i < last.cells; ++i) {
    const row = i * columns, step = reals[row + 6], count = vertexCounts[words[row + 1]], grid = new Uint16Array(bytes, place, 3 * count);
    const own = exact.slice(at, at + count), side = Math.max(...[0, 1, 2].map((axis) => Math.max(...own.map((p) => p[axis])) - Math.min(...own.map((p) => p[axis]))));
    check("a step is at most the cell's longest side over 1024", step <= side / 1024, step / side);
    own.forEach((p, v) => p.forEach((x, axis) => (worst = Math.max(worst, Math.abs(reals[row + 3 + axis] + step * grid[3 * v + axis] - x) / step))));
    at += count;
    place += 6 * count;
  }
  check("the page has every exported vertex", at === exact.length, `${at} ${exact.length}`);
  // Tolerance: half a step; an export's half of a 65535th of a box of at most 2048 steps; floats, 2^-24 of a place.
  check("decoded vertices lie within half a step of the exported ones", worst <= 0.5 + 1024 / 65535 + 0.001, worst);
}
if (surfaces) vertices();
else check(`${file} shows 24 runs, each at eleven times or more`, data.runs.length === 24 && data.runs.every((run) => run.frames.length >= 11), data.runs.map((run) => run.frames.length));

/** Returns texts of numbers that are broken into lines, and tables that are wider than the paper. */
const broken = (page) =>
  page.evaluate(() => {
    const found = [];
    const texts = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode())
      if (node.parentElement.closest("td, th, li"))
        for (const { 0: number, index } of node.data.matchAll(/[-−]?\d[\d.,]*(e[-+]?\d+)?/g)) {
          const range = document.createRange();
          range.setStart(node, index);
          range.setEnd(node, index + number.length);
          const lines = new Set([...range.getClientRects()].map((box) => Math.round(box.top)));
          if (lines.size > 1 && !node.parentElement.closest("code, .long")) found.push(number);
        }
    return found;
  });

const browser = await start();
try {
  const page = await open(browser, file, { width: 1000, height: 700 });
  await firstFrame(page, file);
  const figure = await page.$("#chart-0");
  await figure.scrollIntoView();
  await page.waitForSelector("#chart-0.alive canvas", { timeout: 60_000 });
  const box = await (await page.$("#chart-0 .u-over")).boundingBox();
  await page.mouse.move(box.x + box.width * 0.6, box.y + box.height * 0.5);
  await settle(page);
  check("a chart tells the values at the pointer", /\d at \d/.test(await textOf(page, "#chart-0 .live .note")), await textOf(page, "#chart-0 .live .note"));
  await page.setViewport({ width: 390, height: 800 });
  await settle(page);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  check("at 390 pixels nothing runs out of the page", width <= 390, width);
  check("at 390 pixels no number is broken", (await broken(page)).length === 0, (await broken(page)).slice(0, 5));
  await page.setViewport({ width: 688, height: 1000 }); // A4 without margins
  await page.emulateMediaType("print");
  await settle(page);
  check("on paper no number is broken", (await broken(page)).length === 0, (await broken(page)).slice(0, 5));
  const wide = await page.evaluate(() => [...document.querySelectorAll("table")].filter((t) => t.scrollWidth > 688).map((t) => `${t.scrollWidth}: ${t.caption?.textContent}`));
  check("on paper no table is cut", wide.length === 0, wide.slice(0, 5).join("; "));
} finally {
  await browser.close();
}
if (failures) process.exit(1);
console.log(`${file}: ${html.length} bytes, as small, whole and legible as promised`);
