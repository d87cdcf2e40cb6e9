// A headless Chromium in which nothing may be reported and no request may leave the page, and hands that click and type in it.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

export const [packages, pages] = process.argv.slice(2).map((p) => resolve(p));
const require = createRequire(join(packages, "package.json"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--allow-file-access-from-files", "--disable-extensions", "--disable-gpu-compositing"];

export let failures = 0;
export function check(what, holds, found = "") {
  if (holds) return;
  ++failures;
  console.log(`FAILED: ${what}${found === "" ? "" : `; found: ${found}`}`);
}

export async function start(more = []) {
  return puppeteer.launch({ executablePath: process.env.CHROMIUM, headless: true, args: [...flags, ...more] });
}

/** Opens a page and listens for all that must not happen. */
export async function open(browser, name, size = { width: 1000, height: 700 }, hash = "") {
  const page = await browser.newPage(), url = pathToFileURL(join(pages, name)).href;
  page.on("console", (m) => check(`${name}: nothing on the console`, !["error", "warning"].includes(m.type()) || /GPU stall|swiftshader|WebGL-.*Performance/i.test(m.text()), m.text()));
  page.on("pageerror", (e) => check(`${name}: no error in the program`, false, e.message));
  page.on("request", (r) => check(`${name}: no request leaves the page`, r.url().split("#")[0] === url || r.url().startsWith("data:") || r.url().startsWith("blob:"), r.url()));
  await page.setViewport(size);
  await page.goto(url + hash, { waitUntil: "load", timeout: 300_000 });
  return page;
}

export const pause = (ms) => new Promise((done) => setTimeout(done, ms));
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
export const textOf = (page, what) => page.$eval(what, (e) => e.textContent);
export const hashOf = (page) => page.evaluate(() => decodeURIComponent(location.hash));
export const selectedIn = (page) => page.evaluate(() => document.querySelector("#tree .selected")?.getAttribute("data-path") ?? null);

/** A place on a canvas as it lies now: pictures of elements scroll the page. */
export async function placeOn(page, right = 0.5, down = 0.5) {
  await page.evaluate(() => document.querySelector(".panes").scrollIntoView({ block: "center" }));
  const box = await (await page.$("#explorer canvas")).boundingBox();
  return [box.x + right * box.width, box.y + down * box.height];
}

export async function drag(page, by) {
  const [x, y] = await placeOn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by, y + by / 4, { steps: 4 });
  await page.mouse.up();
}

export async function press(page, key, times = 1, shift = false) {
  if (shift) await page.keyboard.down("Shift");
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
  if (shift) await page.keyboard.up("Shift");
}

/** On a line of the tree, near its beginning. */
export async function placeOnNode(page, path) {
  return page.evaluate((p) => {
    const node = document.querySelector(`#tree [data-path="${p}"] .hit`);
    node.scrollIntoView({ block: "center" });
    const box = node.getBoundingClientRect();
    return [box.x + Math.min(6, box.width / 2), box.y + box.height / 2];
  }, path);
}

export async function clickNode(page, path) {
  await page.mouse.click(...(await placeOnNode(page, path)));
  await settle(page);
}

async function pixels(page, nth) {
  await settle(page);
  return (await page.$$("#explorer canvas"))[nth].screenshot({ encoding: "base64", optimizeForSpeed: true });
}

/** A busy machine may draw late: it has ten seconds and more. */
export async function changes(page, what, act, nth = 0) {
  const before = await pixels(page, nth);
  await act();
  for (let turn = 0; turn < 100; ++turn) {
    if (before !== (await pixels(page, nth))) return;
    await pause(100);
  }
  check(`${what} changes what is seen`, false);
}

/** No finding of axe-core at all, whatever its weight. */
export async function accessible(page, name) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  for (const v of found.violations) check(`${name}: accessible`, false, `${v.impact}: ${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 160)).join(" ")}`);
}

export async function contract(page, name) {
  for (const what of ["#verdict", "#explorer canvas", "#tree [data-path]", "#info", "#time", "#provenance"])
    check(`${name} has ${what}`, (await page.$(what)) !== null);
}

export async function firstFrame(page, name) {
  await page.waitForFunction(() => performance.getEntriesByName("morula-first-frame").length > 0, { timeout: 300_000 });
  console.log(`${name}: first frame after ${Math.round(await page.evaluate(() => performance.getEntriesByName("morula-first-frame")[0].startTime))} ms`);
}

/** Frames a second while the organism turns, its canvas of 800 by 600 pixels. */
export async function turning(page, name) {
  const style = await page.addStyleTag({ content: ".panes { grid-template-columns: 802px 1fr !important } .view { width: 802px; height: 602px !important }" });
  await pause(300);
  const [rate, width, height] = await page.evaluate(async () => {
    const canvas = document.querySelector("#explorer canvas"), gl = canvas.getContext("webgl2"), began = performance.now();
    canvas.focus();
    let frames = 0;
    while (performance.now() - began < 1500) {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", shiftKey: true, bubbles: true }));
      await new Promise(requestAnimationFrame);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
      ++frames;
    }
    return [(1000 * frames) / (performance.now() - began), canvas.width, canvas.height];
  });
  console.log(`${name}: ${rate.toFixed(1)} frames a second while turning at ${width} x ${height}`);
  await style.evaluate((s) => s.remove());
}
