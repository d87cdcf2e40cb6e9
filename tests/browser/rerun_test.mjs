// Presses the button of pages that run again, in headless Chromium: rerun_test.mjs FOLDER-OF-PACKAGES FOLDER-OF-PAGES. What the page says
// when something in it was changed, and in browsers that lack what it needs.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { accessible, check, failures, open, pages, press, start, textOf } from "./browser.mjs";

const status = (page) => textOf(page, "#again [role=status]");
const ended = (page) => page.waitForFunction(() => document.querySelector("#again .mark") !== null, { timeout: 600_000 });

async function again(page) {
  await page.click("#rerun");
  await ended(page);
  return { said: await status(page), same: await page.$eval("#rerun-hash", (e) => e.dataset.same), hash: await textOf(page, "#rerun-hash") };
}

/** The bytes of an element, changed, in a copy of the page. */
function changed(name, to, id, change) {
  const html = readFileSync(join(pages, name), "utf8"), begin = `id="${id}">`, from = html.indexOf(begin) + begin.length, end = html.indexOf("<", from);
  const bytes = change(Buffer.from(html.slice(from, end), "base64").toString("latin1"));
  writeFileSync(join(pages, to), html.slice(0, from) + Buffer.from(bytes, "latin1").toString("base64") + html.slice(end));
}

async function same(browser, name, hashes) {
  const page = await open(browser, name), stored = await textOf(page, "#again .note code");
  const { said, same, hash } = await again(page);
  check(`${name}: the same bits`, same === "true" && hash === stored, `${same} ${hash}: ${said}`);
  check(`${name}: it says so`, hashes.test(said), said);
  await accessible(page, name);
  await page.close();
}

async function says(browser, name, what, expected, sameIs) {
  const page = await open(browser, name), { said, same } = await again(page);
  check(`${what} is said`, expected.test(said), said);
  check(`${what} is not called the same`, same === sameIs, same);
  await page.close();
}

async function growing(browser) {
  const page = await open(browser, "one.html");
  await page.evaluate(() => {
    window.times = [];
    document.querySelector("#time").addEventListener("input", (e) => window.times.push(Number(e.target.value)));
  });
  await page.focus("#rerun");
  await press(page, "Enter");
  await ended(page);
  const times = await page.evaluate(() => window.times);
  check("the explorer shows the run as it grows", times.length === 20 && times[0] === 0 && times.every((t, i) => i === 0 || t > times[i - 1]), times);
  await page.close();
}

async function stopping(browser) {
  const page = await open(browser, "one.html");
  await page.evaluate(() => { // at the first news, however fast the machine is
    new MutationObserver((_, me) => { if (/^Step/.test(document.querySelector("#again [role=status]").textContent)) { me.disconnect(); document.querySelector("#rerun-stop").click(); } })
      .observe(document.querySelector("#again"), { childList: true, subtree: true });
  });
  const stopped = await again(page);
  check("a stop is said", /^! Stopped Stopped at step \d+ of \d+/.test(stopped.said), stopped.said);
  check("what was stopped has no hash", stopped.same === undefined && stopped.hash === "–", stopped.hash);
  const anew = await again(page);
  check("after a stop it starts anew", anew.same === "true", anew.said);
  await page.close();
}

/** In a browser that lacks something, before the page's program starts. */
async function without(browser, what, remove, expected) {
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(remove);
  await page.goto(`file://${join(pages, "one.html")}`);
  const { said } = await again(page);
  check(`${what} is said`, expected.test(said), said);
  await page.close();
}

const policyOf = (name) => /Content-Security-Policy" content="([^"]*)"/.exec(readFileSync(join(pages, name), "utf8"))[1];
check("only pages that run again may", /script-src &#39;sha256-[^ ]+ &#39;wasm-unsafe-eval&#39;; worker-src blob:$/.test(policyOf("one.html")), policyOf("one.html"));
check("others may not", !/wasm|worker|blob/.test(policyOf("plain.html")), policyOf("plain.html"));

const otherDigit = (hash) => (hash[0] === "0" ? "1" : "0") + hash.slice(1);
const edit = (change) => (text) => { const stored = JSON.parse(text); change(stored); return JSON.stringify(stored); };
changed("one.html", "state.html", "rerun-stored", edit((s) => { s.state = otherDigit(s.state); }));
changed("one.html", "link.html", "rerun-stored", edit((s) => { s.links[3][1] = otherDigit(s.links[3][1]); }));
changed("one.html", "scene.html", "rerun-scene", (text) => text.replace("unique-four", "unique-fouR"));
changed("one.html", "last.html", "rerun-scene", (text) => text.slice(0, -33) + otherDigit(text.slice(-33)));
changed("one.html", "module.html", "rerun-module", (bytes) => bytes.slice(0, 200_000) + "tampered" + bytes.slice(200_008));

const browser = await start();
try {
  await same(browser, "one.html", /all \d+ step hashes are as stored/);
  await same(browser, "unchecked.html", /all \d+ step hashes are as stored/);
  await same(browser, "lineage.html", /✓ The same bits/);
  await same(browser, "single.html", /✓ The same bits/);
  await growing(browser);
  await stopping(browser);
  await says(browser, "state.html", "a wrong stored hash", /✗ Other bits .*all \d+ step hashes agree: the stored hash is not that of this run/, "false");
  await says(browser, "link.html", "where other bits begin", /begin to differ from those stored between step 128, whose hash is as stored, and step 192/, "false");
  await says(browser, "scene.html", "a changed scene", /The simulator stopped: scene:1: the scene was changed after it had been written/, undefined);
  await says(browser, "last.html", "another scene", /The scene in this page is not that of the stored run/, undefined);
  await says(browser, "module.html", "a damaged simulator", /✗ Not run to its end The simulator stopped: /, undefined);
  await without(browser, "no WebAssembly", () => { delete window.WebAssembly; }, /This browser has no WebAssembly.*so the run cannot be made again here/);
  await without(browser, "no SIMD", () => { WebAssembly.validate = () => false; }, /it has no SIMD/);
  await without(browser, "no unpacking", () => { delete window.DecompressionStream; }, /too old: it cannot unpack/);
} finally {
  await browser.close();
}
if (failures) process.exit(1);
console.log("pages run again, and say what they find");
