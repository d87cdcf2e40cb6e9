// Writes and runs scenarios in the playground, in headless Chromium: playground_test.mjs FOLDER-OF-PACKAGES FOLDER-OF-PAGES SOURCES.
// Shipped scenarios have the bits of their goldens, mistakes are told in the program's words at their lines.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { accessible, changes, check, failures, open, pause, settle, start, textOf } from "./browser.mjs";

const source = process.argv[4], isLarge = Boolean(process.env.MORULA_BROWSER_LARGE);
const some = (all, most) => (isLarge || all.length <= most ? all : all.filter((_, i) => Math.floor((i * most) / all.length) !== Math.floor(((i - 1) * most) / all.length)));
const status = (page) => textOf(page, "#write [role=status]");
const isRead = (page, before) => page.waitForFunction((b) => Number(document.querySelector("#messages").dataset.number ?? 0) > b, { timeout: 600_000 }, before);
const number = (page) => page.$eval("#messages", (e) => Number(e.dataset.number ?? 0));
const messages = (page) => page.$$eval("#messages li", (all) => all.map((item) => item.textContent.replace(/^[✗!] /, "")));

async function choose(page, name) {
  const before = await number(page);
  await page.select("#scenario", name);
  await isRead(page, before);
}

async function write(page, text) {
  const before = await number(page);
  await page.$eval("#editor", (e, t) => { e.value = t; e.dispatchEvent(new Event("input")); }, text);
  await isRead(page, before);
}

async function run(page) {
  await page.click("#run");
  await page.waitForFunction(() => document.querySelector("#write [role=status] .mark") !== null, { timeout: 600_000 });
  return textOf(page, "#hash");
}

async function shipped(page) {
  const names = some(await page.$$eval("#scenario option", (all) => all.map((o) => o.value)), 40).concat("thesis/unique-four");
  let runs = 0;
  for (const name of names) {
    await choose(page, name);
    const golden = join(source, "golden", `${name}.golden`), cost = await textOf(page, "#cost"), isRead = await page.$eval("#run", (e) => !e.disabled);
    check(`${name} is read, unless it must be refused`, isRead || !existsSync(golden), (await messages(page)).join("\n"));
    if (!isRead) check(`${name} is refused by name`, (await messages(page))[0].startsWith(`${name.split("/").pop()}.yaml: `), (await messages(page))[0]);
    if (!isRead || !/about a second/.test(cost) || !existsSync(golden)) continue;
    const bits = /^bits solver (\w+)$/m.exec(readFileSync(golden, "utf8"))[1], hash = await run(page);
    check(`${name} has the golden's bits`, hash === bits, `${hash}, not ${bits}: ${await status(page)}`);
    ++runs;
  }
  console.log(`${names.length} shipped scenarios are read, ${runs} have been run`);
}

async function mistaken(page) {
  await choose(page, "thesis/unique-four");
  const folder = join(source, "tests/bad_scenarios"), files = some(readdirSync(folder).filter((f) => f.endsWith(".expected")), 48);
  let other = 0;
  for (const file of files) {
    const name = file.replace(".expected", ""), text = readFileSync(join(folder, `${name}.yaml`), "latin1"), utf8 = readFileSync(join(folder, `${name}.yaml`), "utf8");
    // Files that scenarios name, and bytes that are no text, are the program's.
    if (/file:|\.obj|\.txt/.test(text) || Buffer.from(utf8, "utf8").toString("latin1") !== text || /\r|\0/.test(text)) { ++other; continue; }
    const expected = readFileSync(join(folder, file), "utf8").trimEnd().split(`tests/bad_scenarios/${name}.yaml`).join("unique-four.yaml").split("\n");
    await write(page, utf8);
    const found = (await messages(page)).slice(0, expected.length);
    check(`${name} is refused in the program's words`, found.join("\n") === expected.join("\n"), `\n${found.join("\n")}\n  not\n${expected.join("\n")}`);
    check(`${name} does not run`, await page.$eval("#run", (e) => e.disabled));
    const lines = new Set(expected.map((m) => Number(/^[^:]*:(\d+):/.exec(m)?.[1])).filter((n) => n));
    const marked = await page.$$eval("#editor", ([e]) => [...e.parentElement.querySelectorAll(".line")].map((l, i) => (l.classList.contains("wrong") ? i + 1 : 0)).filter((n) => n));
    const length = utf8.split("\n").length;
    check(`${name}: its lines are marked`, [...lines].filter((l) => l <= length).every((l) => marked.includes(l)), `${marked}, not ${[...lines]}`);
  }
  console.log(`${files.length - other} bad scenarios are refused, ${other} were not tried`);
}

async function hands(page) {
  await choose(page, "thesis/unique-four");
  await page.focus("#editor");
  await page.$eval("#editor", (e) => { const at = e.value.indexOf("constant:"); e.setSelectionRange(at, at); });
  await page.keyboard.press("ArrowRight");
  check("the schema's help stands at the key", /^physics\.pressure\.constant: .*k_p/i.test(await textOf(page, "#help")), await textOf(page, "#help"));
  await write(page, (await page.$eval("#editor", (e) => e.value)).replace("mesh:", "mehs:"));
  await page.click("#messages button");
  const caret = await page.$eval("#editor", (e) => e.value.slice(e.selectionStart, e.selectionStart + 4));
  check("a message leads to its place", caret === "mehs", caret);
  await write(page, "morula: 1\nname: large\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\ncycle: {length: 1.0}\nstop: {cycles: 14}\nphysics:\n  time_step: auto\n  mesh: {icosphere: 2}\n  cell: {radius: 1, mass: 1}\n  membrane: {stiffness: 40, damping: 0.5}\n  pressure: {constant: 172, outside: 41}\n");
  check("what is too large is said beforehand", /Too large for a page/.test(await textOf(page, "#cost")), await textOf(page, "#cost"));
  await choose(page, "thesis/elegans-128");
  await page.focus("#run");
  await page.keyboard.press("Enter");
  await page.waitForSelector("#explorer canvas", { timeout: 600_000 });
  await page.waitForFunction(() => /step [1-9]/.test(document.querySelector("#write [role=status]").textContent), { timeout: 600_000 });
  await page.click("#stop");
  check("a stop is said", /Stopped/.test(await status(page)), await status(page));
  check("what was stopped has no hash", (await textOf(page, "#hash")) === "–");
  const saved = await page.$eval("#write a[download]", (a) => [a.download, decodeURIComponent(a.href.split(",").slice(1).join(","))]);
  check("the scenario can be saved", saved[0] === "elegans-128.yaml" && saved[1] === readFileSync(join(source, "scenarios/thesis/elegans-128.yaml"), "utf8"), saved[0]);
  await choose(page, "worm/four-cell");
  const began = performance.now();
  await page.click("#run");
  await page.waitForFunction(() => performance.getEntriesByName("morula-first-frame").length > 0, { timeout: 600_000 });
  console.log(`organism after ${Math.round(performance.now() - began)} ms`);
  await page.waitForFunction(() => document.querySelector("#write [role=status] .mark") !== null, { timeout: 600_000 });
  await settle(page);
  for (const what of ["#editor", "#run", "#stop", "#hash", "#messages", "#explorer canvas", "#tree [data-path]"]) check(`there is ${what}`, (await page.$(what)) !== null);
  await changes(page, "back to the start of the run, which", async () => {
    await page.$eval("#time", (e) => { e.value = "0"; e.dispatchEvent(new Event("input")); });
    await pause(200);
  });
  await accessible(page, "playground");
}

const browser = await start();
try {
  const page = await open(browser, "playground.html");
  await isRead(page, 0);
  await shipped(page);
  await mistaken(page);
  await hands(page);
  await page.close();
  const small = await open(browser, "playground.html", { width: 390, height: 800 });
  await small.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await isRead(small, 0);
  await run(small);
  check("390 pixels are wide enough", (await small.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await accessible(small, "playground, small and dark");
} finally {
  await browser.close();
}
if (failures) process.exit(1);
console.log("the playground works");
