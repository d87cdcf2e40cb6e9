// Through everything that an explorer offers, by clicking and typing, whatever the page is of.
import {
  accessible, changes, check, clickNode, contract, drag, firstFrame, hashOf, open, pause, placeOn, placeOnNode, press, selectedIn, settle, textOf, turning,
} from "./browser.mjs";

/** A leaf that lives at the end, and a cell that has divided, of the run on the left. */
export function someCells(page) {
  return page.evaluate(() => {
    const all = [...document.querySelectorAll("#tree [data-path]")].map((n) => n.getAttribute("data-path")), known = new Set(all);
    return [all.find((p) => p !== "" && !known.has(p + "A")), all.find((p) => p !== "" && known.has(p + "A")) ?? ""];
  });
}

async function tree(page, name) {
  const [, inner] = await someCells(page);
  await page.mouse.click(...(await placeOn(page, 0.45, 0.47))); // a leaf that is seen, for others may lie behind
  await settle(page);
  const leaf = (await selectedIn(page)) ?? (await someCells(page))[0];
  await page.focus("#explorer canvas");
  await press(page, "Escape");
  await page.mouse.move(1, 1);
  await changes(page, `${name}: a click on a leaf`, () => clickNode(page, leaf));
  check(`${name}: a click on a leaf selects it`, (await selectedIn(page)) === leaf, await selectedIn(page));
  check(`${name}: the box tells of it`, (await textOf(page, "#info h3")).length > 0);
  check(`${name}: and of its neighbours, with areas`, /Touches (no other cell|\d+, with contact areas:.*\d)/.test(await textOf(page, "#info")), await textOf(page, "#info"));
  if (inner !== "") {
    await changes(page, `${name}: a click on an inner node`, () => clickNode(page, inner));
    check(`${name}: it dims what does not descend from it`, (await page.$$("#tree .dim")).length > 0);
    check(`${name}: and nothing that does`, await page.evaluate((p) => [...document.querySelectorAll("#tree [data-path]")].every((n) => n.classList.contains("dim") !== n.getAttribute("data-path").startsWith(p)), inner));
  }
  await clickNode(page, leaf);
  await page.evaluate((p) => document.querySelector(`#tree [data-path="${p}"]`).focus(), leaf);
  const mother = leaf.slice(0, -1);
  for (const [key, to] of [["ArrowLeft", mother], ["ArrowRight", mother + "A"], ["ArrowDown", mother + "B"], ["ArrowUp", mother + "A"], ["Home", ""]]) {
    await press(page, key);
    check(`${name}: ${key} goes on to '${to}'`, (await selectedIn(page)) === to, await selectedIn(page));
  }
  await press(page, "Escape");
  check(`${name}: Escape selects nothing`, (await selectedIn(page)) === null);
}

async function organism(page, name) {
  const middle = await placeOn(page, 0.45, 0.47);
  await page.mouse.move(...middle);
  await page.waitForFunction(() => !document.querySelector(".tip").hidden, { timeout: 60_000 }).catch(() => check(`${name}: hover shows a name`, false));
  const called = await textOf(page, ".tip");
  await page.mouse.click(...middle);
  await settle(page);
  const path = await selectedIn(page);
  check(`${name}: a click on a cell selects it in the tree`, path !== null);
  check(`${name}: the name was the cell's`, (await textOf(page, "#info h3")).includes(called.split(" ")[0]), called);
  await page.mouse.move(...(await placeOnNode(page, path ?? "")));
  await settle(page);
  check(`${name}: hover in the tree shows the name`, await page.$eval(".tip", (t) => !t.hidden && t.textContent.length > 0));
  const link = await page.$("#info .links button");
  const to = await link.evaluate((b) => b.dataset.cell);
  await link.click();
  check(`${name}: a relative's button goes to it`, (await selectedIn(page)) === to);
  await page.focus("#explorer canvas");
  await press(page, "Escape");
}

async function time(page, name) {
  const now = () => page.$eval("#time", (t) => Number(t.value)), end = await now();
  await changes(page, `${name}: the slider`, async () => { await page.focus("#time"); await press(page, "ArrowLeft", 4); });
  const late = await now();
  check(`${name}: ArrowLeft goes back in time`, late < end, late);
  await press(page, "PageDown");
  const earlier = await now();
  check(`${name}: PageDown goes back farther`, earlier < late, earlier);
  check(`${name}: the slider says time and cells`, /time .* cell/.test(await page.$eval("#time", (t) => t.getAttribute("aria-valuetext"))));
  check(`${name}: divisions are marked`, (await page.$$(".clock svg line")).length >= 1);
  await page.click("#play");
  await page.waitForFunction((t) => Number(document.querySelector("#time").value) > t, { timeout: 120_000 }, earlier).catch(() => check(`${name}: play goes on`, false));
  if ((await textOf(page, "#play")).includes("Pause")) await page.click("#play");
  await page.$eval("#time", (t) => { t.value = t.max; t.dispatchEvent(new Event("input")); });
}

async function looks(page, name) {
  for (const shown of ["wireframe", "normals", "shell", "surface", "connections"])
    if (await page.$(`.tools input[name=${shown}]`)) {
      await changes(page, `${name}: ${shown}`, () => page.click(`.tools input[name=${shown}]`));
      await page.click(`.tools input[name=${shown}]`);
    }
  for (const colour of ["generation", "clone", "volume"]) await changes(page, `${name}: colour by ${colour}`, () => page.select(".tools select[name=colour]", colour));
  check(`${name}: a colour bar with both ends`, /volume.*\d/.test(await textOf(page, ".bar")) && (await page.$(".bar .ramp")) !== null);
  await changes(page, `${name}: opacity`, async () => { await page.focus(".tools input[name=opacity]"); await press(page, "PageDown", 5); });
  await changes(page, `${name}: a clip plane`, () => page.select(".tools select[name=clip]", "y"));
  await changes(page, `${name}: a view from above`, () => page.select(".tools select[name=view]", "top"));
  await changes(page, `${name}: turning with the mouse`, () => drag(page, 90));
  await page.focus("#explorer canvas");
  await changes(page, `${name}: turning with keys`, () => press(page, "ArrowLeft", 1, true));
}

/** Arrows of forces: their key, each kind by itself, and those on the vertices of a selected cell. */
export async function forces(page, name) {
  if (!(await page.$(".tools input[name=forces]"))) return;
  await changes(page, `${name}: forces`, () => page.click(".tools input[name=forces]"));
  check(`${name}: a key tells their scale`, /\d \[force\]/.test(await textOf(page, ".bar.forces")) && (await page.$eval(".forces .arrow", (a) => a.clientWidth)) > 10, await textOf(page, ".bar.forces"));
  check(`${name}: and what they are`, /the net force of each kind on a cell/.test(await textOf(page, ".bar.forces")));
  const [leaf] = await someCells(page);
  await changes(page, `${name}: forces on a cell's vertices`, () => clickNode(page, leaf));
  check(`${name}: the key says so`, /on each vertex of/.test(await textOf(page, ".bar.forces")), await textOf(page, ".bar.forces"));
  check(`${name}: the box says how large they are`, /net force/.test(await textOf(page, "#info")));
  await changes(page, `${name}: without pressure`, () => page.click(".forces input[name=force-pressure]"));
  await pause(400);
  check(`${name}: the address holds the kinds`, /forces=true/.test(await hashOf(page)) && /kinds=(?!.*pressure)/.test(await hashOf(page)), await hashOf(page));
  await page.click(".forces input[name=force-pressure]");
  await page.click(".tools input[name=forces]");
  await page.focus("#explorer canvas");
  await press(page, "Escape");
}

/** Everything, in a wide window; `timed`: also how fast it turns. Returns what the address holds at the end. */
export async function walk(browser, file, timed) {
  const page = await open(browser, file);
  await firstFrame(page, file);
  await contract(page, file);
  check(`${file}: the verdict stands first`, await page.evaluate(() => document.querySelector("main > section").id === "verdict"));
  if (timed) {
    await turning(page, file);
    await page.select(".tools select[name=view]", "iso"); // it has turned as far as the machine is fast
    await pause(500);
    await settle(page);
  }
  await tree(page, file);
  await organism(page, file);
  await time(page, file);
  await forces(page, file);
  await looks(page, file);
  await accessible(page, file);
  await pause(400);
  const hash = await hashOf(page);
  for (const part of ["colour=volume", "clip=y", "opacity=", "camera="]) check(`${file}: the address holds ${part}`, hash.includes(part), hash);
  await page.close();
  return hash;
}

/** As narrow as a telephone, and dark; on paper; without WebGL, where the stored pictures stand in. */
export async function otherwise(browser, plain, file) {
  const page = await open(browser, file, { width: 390, height: 800, hasTouch: true, isMobile: true });
  const width = () => page.evaluate(() => document.documentElement.scrollWidth);
  check(`${file}: at 390 pixels nothing runs out of the page`, (await width()) <= 390, await width());
  await contract(page, `${file} at 390 pixels`);
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await accessible(page, `${file} at 390 pixels, dark`);
  await page.emulateMediaFeatures([]);
  await page.emulateMediaType("print");
  for (const [what, isSeen] of [["#explorer .tools", false], ["#explorer canvas", false], ["#tree svg", true], ["#verdict", true]])
    await page // the tree is drawn anew when the medium changes
      .waitForFunction((w, seen) => document.querySelector(w).checkVisibility() === seen, { timeout: 60_000 }, what, isSeen)
      .catch(() => check(`${file}: on paper ${what} is ${isSeen ? "seen" : "not seen"}`, false));
  await page.close();
  const without = await open(plain, file);
  check(`${file}: without WebGL the stored picture`, (await without.$("#explorer .view img")) !== null && (await without.$("#explorer canvas")) === null);
  const [leaf] = await someCells(without);
  await clickNode(without, leaf);
  check(`${file}: and the tree`, (await selectedIn(without)) === leaf);
  await without.close();
}
