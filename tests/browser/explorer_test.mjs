// Clicks and types through pages of `morula report`, in headless Chromium: explorer_test.mjs FOLDER-OF-PACKAGES FOLDER-OF-PAGES FILE...
// Every interaction on each of the files, and what is special of one.html, two.html and evil.html. Times are printed, not judged:
// they are the machine's.
import { accessible, changes, check, clickNode, drag, failures, hashOf, open, pause, press, settle, start, textOf } from "./browser.mjs";
import { otherwise, walk } from "./walk.mjs";

async function address(browser, hash) {
  const page = await open(browser, "one.html", undefined, hash);
  check("the address brings it back", (await hashOf(page)).includes("colour=volume") && (await page.$eval(".tools select[name=clip]", (s) => s.value)) === "y");
  const camera = (text) => (/camera=([^&]*)/.exec(text)?.[1] ?? "").split(",").map(Number);
  await changes(page, "turning goes on from there, which", async () => {
    await page.focus("#explorer canvas");
    await press(page, "ArrowRight", 1, true);
    await press(page, "ArrowLeft", 2, true);
  });
  await pause(400);
  const [was, is] = [camera(hash), camera(await hashOf(page))];
  check("the camera stands where it stood, but for one step", was.length === 7 && Math.hypot(was[0] - is[0], was[1] - is[1], was[2] - is[2]) < 0.11 * Math.hypot(...was.slice(0, 3)), `${was} ${is}`);
  await page.goto(page.url().split("#")[0] + "#time=1e999&selected=%E0%A4%A&colour=%3Cscript%3E&kinds=%3Cscript%3E&forces=true&left=7&camera=a,b", { waitUntil: "load" });
  await page.reload();
  check("an address of nonsense is passed over", (await page.$("#explorer canvas")) !== null);
  await page.close();
}

async function twoRuns(browser) {
  const page = await open(browser, "two.html");
  check("two organisms side by side", (await page.$$("#explorer canvas")).length === 2);
  const bars = await page.$$eval("#explorer .scale", (all) => all.map((bar) => [bar.textContent, bar.clientWidth].join()));
  check("both have one scale", bars.length === 2 && bars[0] === bars[1], bars);
  await changes(page, "turning one organism turns the other, which", () => drag(page, 60), 1);
  await page.focus("#time");
  await changes(page, "one slider for both, which", () => press(page, "ArrowLeft", 8), 1);
  await changes(page, "forces in both, which", () => page.click(".tools input[name=forces]"), 1);
  check("what differs is named", /physics\.pressure\.constant/.test(await textOf(page, "#parameters")));
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
  check("in the box, too", await page.evaluate(() => window.evil === undefined && document.querySelector("#info h3").textContent.includes("<img")), await textOf(page, "#info h3"));
  await page.close();
}

/** From the list of a study's runs to the run in the explorer. */
async function study(browser) {
  const page = await open(browser, "study.html");
  const left = () => page.$eval(".tools select[name=left]", (s) => s.value), before = await left();
  const list = await page.$$eval("details a[href^='#left=']", (all) => all.map((a) => [a.textContent, a.closest("tr").querySelector("code").textContent]));
  const runs = await page.$$eval(".tools select[name=left] option", (all) => all.map((o) => o.textContent));
  check("each run in the explorer has a link and a command", JSON.stringify(list.map(([name]) => name)) === JSON.stringify(runs) && list.every(([, command]) => /report .* --run [0-9a-f]{16} -o/.test(command)), list[0]);
  await page.evaluate(() => (document.querySelector("details:has(a[href^='#left='])").open = true));
  await changes(page, "a link to a run", () => page.click("details a[href='#left=2']"));
  check("it shows the run, and the explorer is in sight", before === "0" && (await left()) === "2" && (await page.$eval("#explorer canvas", (c) => c.getBoundingClientRect().bottom > 0)));
  await accessible(page, "study.html with its list of runs");
  await page.close();
}

const browser = await start(), plain = await start(["--disable-3d-apis"]), files = process.argv.slice(4);
try {
  for (const file of files) {
    const hash = await walk(browser, file, file === "elegans.html");
    await otherwise(browser, plain, file);
    if (file === "study.html") await study(browser);
    if (file !== "one.html") continue;
    await address(browser, hash);
    await twoRuns(browser);
    await evil(browser);
  }
} finally {
  await browser.close();
  await plain.close();
}
if (failures) process.exit(1);
console.log(`all interactions work in ${files.join(", ")}`);
