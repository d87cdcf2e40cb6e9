// Clicks and types through pages of `morula report`, in headless Chromium: explorer_test.mjs FOLDER-OF-PACKAGES FOLDER-OF-PAGES.
// Times are printed, not judged: they are the machine's.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [packages, pages] = process.argv.slice(2).map((p) => resolve(p));
const require = createRequire(join(packages, "package.json"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--allow-file-access-from-files", "--disable-extensions"];

let failures = 0;
function check(what, holds, found = "") {
  if (holds) return;
  ++failures;
  console.log(`FAILED: ${what}${found === "" ? "" : `; found: ${found}`}`);
}

async function start(more = []) {
  return puppeteer.launch({ executablePath: process.env.CHROMIUM, headless: true, args: [...flags, ...more] });
}

/** Opens a page and listens for all that must not happen. */
async function open(browser, name, size = { width: 1280, height: 1000 }, hash = "") {
  const page = await browser.newPage();
  const url = pathToFileURL(join(pages, name)).href;
  page.on("console", (m) => check(`${name}: nothing on the console`, !["error", "warning"].includes(m.type()) || /GPU stall|swiftshader|WebGL-.*Performance/i.test(m.text()), m.text()));
  page.on("pageerror", (e) => check(`${name}: no error in the program`, false, e.message));
  page.on("request", (r) => check(`${name}: no request leaves the page`, r.url().split("#")[0] === url || r.url().startsWith("data:"), r.url()));
  await page.setViewport(size);
  await page.goto(url + hash, { waitUntil: "load" });
  return page;
}

const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
/** A place on a canvas as it lies now: pictures of elements scroll the page. */
async function placeOn(page, right = 0.5, down = 0.5) {
  await page.evaluate(() => document.querySelector(".panes").scrollIntoView({ block: "center" }));
  const box = await (await page.$("#explorer canvas")).boundingBox();
  return [box.x + right * box.width, box.y + down * box.height];
}
async function drag(page, by) {
  const [x, y] = await placeOn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by, y + by / 4, { steps: 4 });
  await page.mouse.up();
}
const hashOf = (page) => page.evaluate(() => decodeURIComponent(location.hash));
const selectedIn = (page) => page.evaluate(() => document.querySelector("#tree .selected")?.getAttribute("data-path") ?? null);
async function pixels(page, nth = 0) {
  await settle(page);
  return (await page.$$("#explorer canvas"))[nth].screenshot({ encoding: "base64" });
}
/** A busy machine may draw late: it has two seconds. */
async function changes(page, what, act, nth = 0) {
  const before = await pixels(page, nth);
  await act();
  for (let turn = 0; turn < 20; ++turn) {
    if (before !== (await pixels(page, nth))) return;
    await pause(100);
  }
  check(`${what} changes what is seen`, false);
}
async function clickNode(page, path) {
  const at = await page.evaluate((p) => {
    const node = document.querySelector(`#tree [data-path="${p}"] .hit`), box = node.getBoundingClientRect();
    node.scrollIntoView({ block: "center" });
    const now = node.getBoundingClientRect();
    return [now.x + Math.min(6, box.width / 2), now.y + now.height / 2];
  }, path);
  await page.mouse.click(...at);
  await settle(page);
}

async function accessible(page, name) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  for (const v of found.violations)
    if (["serious", "critical"].includes(v.impact)) check(`${name}: accessible`, false, `${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 160)).join(" ")}`);
}

async function contract(page, name) {
  for (const what of ["#verdict", "#explorer canvas", "#tree [data-path]", "#info", "#time", "#provenance"])
    check(`${name} has ${what}`, (await page.$(what)) !== null);
}

async function oneRun(browser) {
  const page = await open(browser, "one.html");
  await page.waitForFunction(() => performance.getEntriesByName("morula-first-frame").length > 0);
  console.log(`first frame after ${Math.round(await page.evaluate(() => performance.getEntriesByName("morula-first-frame")[0].startTime))} ms`);
  await contract(page, "one.html");
  check("the verdict stands first", await page.evaluate(() => document.querySelector("main > section").id === "verdict"));
  check("seven cells in the tree", (await page.$$("#tree [data-path]")).length >= 7, (await page.$$("#tree [data-path]")).length);

  // Trees and cells
  const [leaf, inner] = await page.evaluate(() => {
    const all = [...document.querySelectorAll("#tree [data-path]")].map((n) => n.getAttribute("data-path"));
    return [all.find((p) => !all.includes(p + "A")), all.find((p) => p !== "" && all.includes(p + "A"))];
  });
  await changes(page, "a click on a leaf", () => clickNode(page, leaf));
  check("a click on a leaf selects it", (await selectedIn(page)) === leaf, await selectedIn(page));
  check("the box tells of it", (await page.$eval("#info h3", (h) => h.textContent)).length > 0);
  check("the box tells its neighbours", /Touches/.test(await page.$eval("#info", (i) => i.textContent)));
  await changes(page, "a click on an inner node", () => clickNode(page, inner));
  check("an inner node dims what does not descend from it", (await page.$$("#tree .dim")).length > 0);
  check("and nothing that does", await page.evaluate((p) => [...document.querySelectorAll("#tree [data-path]")].every((n) => n.classList.contains("dim") !== n.getAttribute("data-path").startsWith(p)), inner));

  // Keys: to the mother, a daughter, the sister
  await clickNode(page, leaf);
  await page.evaluate((p) => document.querySelector(`#tree [data-path="${p}"]`).focus(), leaf);
  for (const [key, to] of [["ArrowLeft", leaf.slice(0, -1)], ["ArrowRight", leaf.slice(0, -1) + "A"], ["ArrowDown", leaf.slice(0, -1) + "B"], ["ArrowUp", leaf.slice(0, -1) + "A"], ["Home", ""]]) {
    await page.keyboard.press(key);
    check(`${key} goes on to '${to}'`, (await selectedIn(page)) === to, await selectedIn(page));
  }
  await page.keyboard.press("Escape");
  check("Escape selects nothing", (await selectedIn(page)) === null);

  // The organism: what the mouse stands on and clicks at
  const middle = await placeOn(page, 0.4, 0.45);
  await page.mouse.move(...middle);
  await page.waitForFunction(() => !document.querySelector(".tip").hidden, { timeout: 3000 }).catch(() => check("hover shows a name", false));
  const name = await page.$eval(".tip", (t) => t.textContent);
  await page.mouse.click(...middle);
  await settle(page);
  const path = await selectedIn(page);
  check("a click on a cell selects it in the tree", path !== null);
  check("the name was the cell's", (await page.$eval("#info h3", (h) => h.textContent)).includes(name.split(" ")[0]), name);
  const node = await page.$eval(`#tree [data-path="${path}"] .hit`, (n) => { const b = n.getBoundingClientRect(); return [b.x + 3, b.y + b.height / 2]; });
  await page.mouse.move(...node);
  await settle(page);
  check("hover in the tree shows the name", await page.$eval(".tip", (t) => !t.hidden && t.textContent.length > 0));
  const link = await page.$("#info .links button");
  const to = await link.evaluate((b) => b.dataset.cell);
  await link.click();
  check("a relative's button goes to it", (await selectedIn(page)) === to);
  await page.keyboard.press("Tab");

  // Time
  const end = await page.$eval("#time", (t) => Number(t.value));
  await changes(page, "the slider", async () => { await page.focus("#time"); for (let i = 0; i < 25; ++i) await page.keyboard.press("ArrowLeft"); });
  const earlier = await page.$eval("#time", (t) => Number(t.value));
  check("ArrowLeft goes back in time", earlier < end, earlier);
  check("the slider says time and cells", /time .* cell/.test(await page.$eval("#time", (t) => t.getAttribute("aria-valuetext"))));
  check("divisions are marked", (await page.$$(".clock svg line")).length >= 2);
  await page.click("#play");
  await pause(400);
  await page.click("#play");
  check("play goes on", (await page.$eval("#time", (t) => Number(t.value))) > earlier);

  // What is shown
  await page.evaluate(() => { document.querySelector("#time").value = document.querySelector("#time").max; document.querySelector("#time").dispatchEvent(new Event("input")); });
  for (const name of ["wireframe", "normals", "shell", "surface"]) {
    await changes(page, name, () => page.click(`.tools input[name=${name}]`));
    await page.click(`.tools input[name=${name}]`);
  }
  for (const colour of ["generation", "clone", "volume"]) await changes(page, `colour by ${colour}`, () => page.select(".tools select[name=colour]", colour));
  check("a colour bar with both ends", /volume.*\d/.test(await page.$eval(".bar", (b) => b.textContent)) && (await page.$(".bar .ramp")) !== null);
  await changes(page, "opacity", async () => { await page.focus(".tools input[name=opacity]"); for (let i = 0; i < 5; ++i) await page.keyboard.press("PageDown"); });
  await changes(page, "a clip plane", () => page.select(".tools select[name=clip]", "y"));
  await changes(page, "a view from above", () => page.select(".tools select[name=view]", "top"));
  await changes(page, "turning with the mouse", () => drag(page, 90));
  await page.focus("#explorer canvas");
  await changes(page, "turning with keys", async () => { await page.keyboard.down("Shift"); await page.keyboard.press("ArrowLeft"); await page.keyboard.up("Shift"); });
  await pause(400);
  const hash = await hashOf(page);
  for (const part of ["colour=volume", "clip=y", "opacity=", "camera="]) check(`the address holds ${part}`, hash.includes(part), hash);
  await page.close();
  const again = await open(browser, "one.html", undefined, hash);
  check("the address brings it back", (await hashOf(again)).includes("colour=volume") && (await again.$eval(".tools select[name=clip]", (s) => s.value)) === "y");
  const camera = (text) => (/camera=([^&]*)/.exec(text)?.[1] ?? "").split(",").map(Number);
  await changes(again, "turning goes on from there, which", async () => { await again.focus("#explorer canvas"); await again.keyboard.down("Shift"); await again.keyboard.press("ArrowRight"); await again.keyboard.press("ArrowLeft"); await again.keyboard.press("ArrowLeft"); await again.keyboard.up("Shift"); });
  await pause(400);
  const [was, is] = [camera(hash), camera(await hashOf(again))];
  check("the camera stands where it stood, but for one step", was.length === 7 && Math.hypot(was[0] - is[0], was[1] - is[1], was[2] - is[2]) < 0.11 * Math.hypot(...was.slice(0, 3)), `${was} ${is}`);
  await again.goto(again.url().split("#")[0] + "#time=1e999&selected=%E0%A4%A&colour=%3Cscript%3E&left=7&camera=a,b", { waitUntil: "load" });
  await again.reload();
  check("an address of nonsense is passed over", (await again.$("#explorer canvas")) !== null);

  console.log(`frames a second while turning: ${await turning(again)}`);
  await accessible(again, "one.html");
  await again.close();
}

async function turning(page) {
  return page.evaluate(async () => {
    const canvas = document.querySelector("#explorer canvas"), began = performance.now();
    canvas.focus();
    let frames = 0;
    while (performance.now() - began < 1000) {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", shiftKey: true, bubbles: true }));
      await new Promise(requestAnimationFrame);
      const gl = canvas.getContext("webgl2");
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
      ++frames;
    }
    return Math.round((1000 * frames) / (performance.now() - began));
  });
}

async function narrow(browser) {
  const page = await open(browser, "one.html", { width: 390, height: 800, hasTouch: true, isMobile: true });
  check("at 390 pixels nothing runs out of the page", (await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, await page.evaluate(() => document.documentElement.scrollWidth));
  await contract(page, "one.html at 390 pixels");
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await accessible(page, "one.html at 390 pixels, dark");
  await page.close();
}

async function twoRuns(browser) {
  const page = await open(browser, "two.html");
  check("two organisms side by side", (await page.$$("#explorer canvas")).length === 2);
  await changes(page, "turning one organism turns the other, which", () => drag(page, 60), 1);
  await page.focus("#time");
  await changes(page, "one slider for both, which", async () => { for (let i = 0; i < 8; ++i) await page.keyboard.press("ArrowLeft"); }, 1);
  check("what differs is named", /physics\.pressure\.constant/.test(await page.$eval("#parameters", (p) => p.textContent)));
  await page.click(".swipe-tools button");
  check("blinking goes on until it is stopped", (await page.$eval(".swipe-tools button", (b) => b.getAttribute("aria-pressed"))) === "true");
  await page.select(".tools select[name=right]", "-1");
  await settle(page);
  check("one alone", (await page.$$("#explorer canvas")).length === 1);
  await accessible(page, "two.html");
  await page.close();
}

async function evil(browser) {
  const page = await open(browser, "evil.html");
  check("no text of a scenario runs", await page.evaluate(() => window.evil === undefined && document.querySelectorAll("img[src=x]").length === 0));
  check("it is seen as it was written", await page.evaluate(() => document.body.textContent.includes("<script>window.evil=1</script>")));
  await clickNode(page, "A");
  check("in the box, too", await page.evaluate(() => window.evil === undefined && document.querySelector("#info h3").textContent.includes("<img")), await page.$eval("#info h3", (h) => h.textContent));
  await page.close();
}

async function withoutGraphics() {
  const browser = await start(["--disable-3d-apis"]);
  const page = await browser.newPage();
  await page.goto(pathToFileURL(join(pages, "one.html")).href, { waitUntil: "load" });
  check("without WebGL the stored picture", (await page.$("#explorer .view img")) !== null && (await page.$("#explorer canvas")) === null);
  await clickNode(page, "A");
  check("and the tree", (await selectedIn(page)) === "A");
  await browser.close();
}

const browser = await start();
try {
  await oneRun(browser);
  await narrow(browser);
  await twoRuns(browser);
  await evil(browser);
} finally {
  await browser.close();
}
await withoutGraphics();
if (failures) process.exit(1);
console.log("all interactions work");
