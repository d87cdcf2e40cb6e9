// The explorer: builds its parts into #explore and keeps them together.
import { Clock } from "./clock";
import { Colouring } from "./colours";
import { setUpCompare } from "./compare";
import { isWithin, numberText, readData, type Data, type Run } from "./data";
import { standpoints } from "./eye";
import { ForceKey } from "./force_key";
import { Info } from "./info";
import { setUpCharts } from "./live_chart";
import { State, type Choice } from "./state";
import { element, Tools } from "./tools";
import { Tree } from "./tree";
import { View } from "./view";

/** Returns the run to show beside the first: the other of two, else the next of the same scenario; -1: none. */
function beside({ runs }: Data): number {
  return runs.length === 2 ? 1 : runs.findIndex((run, i) => i > 0 && run.scenario === runs[0].scenario);
}

/** Returns true if any scenario gives colours to substances or cells; else clones are the better colours. */
function isColoured({ runs }: Data): boolean {
  return runs.some((run) => run.legend.length > 0 || Object.keys(run.cellColours).length > 0);
}

export class Explorer {
  protected readonly state: State;
  private readonly colouring: Colouring;
  protected readonly views: View[] = [];
  protected readonly tree: Tree;
  private readonly info: Info;
  protected readonly clock: Clock;
  private readonly tip = element("div", "tip");
  private readonly bar = element("div", "bar");
  private readonly forces: ForceKey;
  private readonly panes = element("div", "panes");
  private readonly viewRow = element("div", "views");
  private hasGraphics = true;
  private linking = false;

  constructor(
    root: HTMLElement,
    private readonly data: Data,
  ) {
    const second = beside(data);
    const initial: Choice = {
      time: Math.max(data.runs[0].end, second > 0 ? data.runs[second].end : 0),
      selected: null,
      hovered: null,
      colour: isColoured(data) ? "substance" : "clone",
      names: data.runs[0].cells.length <= 64 && data.runs[0].cells.some((cell) => cell.name !== ""),
      scaleNow: false,
      surface: true,
      wireframe: false,
      normals: false,
      connections: false,
      forces: false,
      kinds: "all",
      shell: true,
      opacity: 1,
      clip: "",
      clipAt: 0,
      left: 0,
      right: second,
      camera: null,
    };
    this.state = new State(initial, {
      runs: data.runs.length,
      time: Math.max(...data.runs.map((r) => r.end)),
      isCell: (path) => data.runs.some((r) => r.byPath.has(path)),
    });
    this.colouring = new Colouring(data);
    const anyBodies = data.runs.some((run) => run.hasBodies);
    const treePane = element("div", "tree");
    treePane.id = "tree";
    const infoBox = element("div");
    infoBox.id = "info";
    infoBox.setAttribute("aria-live", "polite");
    const clockBox = element("div", "clock");
    this.tip.hidden = true;
    const tools = new Tools(data, this.state, this.colouring, anyBodies);
    tools.onLook = (direction) => this.views.forEach((view) => view.look(direction));
    this.forces = new ForceKey(data, this.state);
    root.append(tools.box, this.panes, this.bar, this.forces.box, clockBox, infoBox, this.tip);
    if (anyBodies) this.panes.append(this.viewRow);
    else this.panes.style.gridTemplateColumns = "minmax(0, 1fr)";
    this.panes.append(treePane);
    if (anyBodies) this.makeViews();
    this.tree = new Tree(treePane, this.firstRun(), this.state, this.colouring, this.data);
    this.info = new Info(infoBox, data, this.state);
    this.clock = new Clock(clockBox, data, this.state);
    this.fitButton(tools.box);
    for (const part of [this.tree, this.info]) part.onPick = (path: string) => this.pick(path);
    this.tree.onHover = (path, x, y) => this.hover(path, x, y);
    this.state.listen((changed) => this.changed(changed));
    addEventListener("hashchange", () => {
      if (location.hash.includes("=")) root.scrollIntoView(); // a link of the page leads to a run here
    });
    root.addEventListener("keydown", (e) => this.key(e));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.takePaper());
    this.updateAll();
  }

  private takePaper(): void {
    this.views.forEach((view) => view.takePaper());
    this.forces.takePaper();
    this.forces.update(this.views);
  }

  private firstRun(): Run {
    return this.data.runs[this.state.choice.left];
  }
  private shown(): number[] {
    const { left, right } = this.state.choice;
    return right >= 0 ? [left, right] : [left];
  }

  private makeViews(): void {
    this.views.length = 0;
    this.viewRow.replaceChildren();
    for (const number of this.shown()) {
      const run = this.data.runs[number],
        box = element("div", "view");
      this.viewRow.append(box);
      if (!run.hasBodies || !this.hasGraphics) {
        this.showPicture(box, number);
        continue;
      }
      try {
        const view = new View(box, run, this.state, this.colouring);
        view.onPick = (path) => {
          if (path === null) this.state.set({ selected: null });
          else this.pick(path);
        };
        view.onHover = (path, x, y) => this.hover(path, x, y);
        view.onResize = () => this.scaleBars();
        view.onCamera = (moved) => this.link(moved);
        const caption = element("div", "caption", this.data.runs.length > 1 ? run.title : ""),
          scale = element("div", "scale");
        box.append(caption, scale);
        this.views.push(view);
      } catch {
        this.hasGraphics = false;
        box.replaceChildren();
        this.showPicture(box, number);
      }
    }
    // All views have one scale, so that sizes can be compared.
    const size = Math.max(...this.views.map((view) => view.size)),
      { camera } = this.state.choice;
    this.linking = true; // the first place of the eye is not the user's choice
    for (const view of this.views) {
      view.size = size;
      view.look(standpoints.iso);
      if (camera) view.putAt(camera);
    }
    this.linking = false;
    this.scaleBars();
  }

  /** Shows the page's picture of the run, for lack of WebGL or of shapes. */
  private showPicture(box: HTMLElement, number: number): void {
    const run = this.data.runs[number],
      stored = document.querySelector<HTMLImageElement>(`#picture-${number} img`) ?? this.pictureUnder(run.title);
    if (stored) {
      const picture = stored.cloneNode() as HTMLImageElement;
      box.append(picture);
    }
    box.append(
      element(
        "div",
        "caption",
        run.hasBodies
          ? "This browser has no WebGL: the stored picture instead."
          : `${run.title}: no shapes are kept in this page.`,
      ),
    );
  }

  /** Returns the picture in the page's block with this title. */
  private pictureUnder(title: string): HTMLImageElement | null {
    const block = [...document.querySelectorAll("main > section")].find(
      (section) => section.querySelector("h2")?.textContent === title,
    );
    return block?.querySelector("img") ?? null;
  }

  private fitButton(tools: HTMLElement): void {
    const button = element("button", "", "");
    button.type = "button";
    const show = () => {
      button.textContent = this.tree.isWhole ? "Tree: every label" : "Tree: all of it";
      button.hidden = !this.tree.canFit;
    };
    button.addEventListener("click", () => {
      this.tree.fit(!this.tree.isWhole);
      show();
    });
    show();
    tools.append(button);
  }

  /** Moves the cameras of all views together. */
  private link(moved: View): void {
    if (this.linking) return;
    this.linking = true;
    for (const view of this.views) if (view !== moved) view.putAt(moved.eye.place());
    this.linking = false;
    this.scaleBars();
    this.state.set({ camera: moved.eye.place() });
  }

  private scaleBars(): void {
    for (const view of this.views) {
      const bar = view.canvas.parentElement!.querySelector<HTMLElement>(".scale"),
        perPixel = view.eye.lengthPerPixel();
      if (!bar || !(perPixel > 0)) continue;
      const [unit, factor] = this.data.units.scale ?? ["", 1],
        most = 120 * perPixel * factor;
      const power = 10 ** Math.floor(Math.log10(most)),
        length = [5, 2, 1].map((x) => x * power).find((x) => x <= most) ?? power;
      const text = numberText(length) + (unit && ` ${unit}`),
        width = `${(length / factor / perPixel).toFixed(1)}px`;
      if (bar.textContent !== text) bar.textContent = text; // equal text needs no new layout
      if (bar.style.width !== width) bar.style.width = width;
    }
    this.forces.measure(this.views[0]);
  }

  private pick(path: string): void {
    const { choice } = this.state,
      run = this.data.runs[this.shown().find((n) => this.data.runs[n].byPath.has(path)) ?? choice.left],
      cell = run.byPath.get(path);
    if (!cell) return;
    // If neither the cell nor a descendant lives now, the time changes to the cell's.
    const isSeen = run.cells.some(
      (c) => isWithin(c.path, path) && c.born <= choice.time && (choice.time < c.ended || c.fate === "alive"),
    );
    let time = choice.time;
    if (!isSeen) {
      const frames = run.times.filter((t) => t >= cell.born && (t < cell.ended || cell.fate === "alive"));
      time = frames.length ? frames[frames.length >> 1] : (cell.born + cell.ended) / 2;
    }
    this.state.set({ selected: path, time });
    this.tree.reveal(path, false);
  }

  private hover(path: string | null, x: number, y: number): void {
    if (this.state.choice.hovered !== path) this.state.set({ hovered: path });
    const cell =
      path === null
        ? undefined
        : this.shown()
            .map((n) => this.data.runs[n].byPath.get(path))
            .find((c) => c);
    this.tip.hidden = !cell || (x === 0 && y === 0);
    if (!cell) return;
    this.tip.textContent = cell.label + (cell.name ? ` (${cell.path || "egg"})` : "");
    this.tip.style.left = `${Math.min(x + 12, innerWidth - 160) + scrollX}px`;
    this.tip.style.top = `${y + 14 + scrollY}px`;
  }

  private key(event: KeyboardEvent): void {
    const at = event.target as HTMLElement;
    if (
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      ["INPUT", "SELECT", "TEXTAREA", "BUTTON"].includes(at.tagName)
    )
      return;
    const inTree = at.closest("#tree") !== null,
      view = this.views.find((v) => v.canvas === at);
    if (!inTree && !view) return;
    const run = this.firstRun(),
      cell = run.byPath.get(this.state.choice.selected ?? "") ?? run.cells[0];
    const sister = cell.mother?.daughters.find((d) => d !== cell);
    let to: string | undefined;
    if (event.shiftKey && view) {
      const turns: Record<string, [number, number]> = {
        ArrowLeft: [-0.1, 0],
        ArrowRight: [0.1, 0],
        ArrowUp: [0, 0.1],
        ArrowDown: [0, -0.1],
      };
      if (!turns[event.key]) return;
      view.eye.turn(...turns[event.key]);
    } else if (event.key === "ArrowLeft") to = cell.mother?.path;
    else if (event.key === "ArrowRight") to = cell.daughters[0]?.path;
    else if (event.key === "ArrowUp" || event.key === "ArrowDown") to = sister?.path;
    else if (event.key === "Home") to = run.cells[0].path;
    else if (event.key === "Enter" || (event.key === " " && inTree)) to = at.getAttribute("data-path") ?? undefined;
    else if (event.key === "Escape") this.state.set({ selected: null });
    else if (event.key === " ") this.clock.toggle();
    else if (event.key === "." || event.key === ",") this.clock.step(event.key === "." ? 1 : -1);
    else return;
    event.preventDefault();
    if (to === undefined) return;
    // The first arrow key selects the egg; later ones go on from there.
    this.pick(this.state.choice.selected === null && event.key !== "Enter" ? cell.path : to);
    if (inTree) this.tree.reveal(this.state.choice.selected!, true);
  }

  private changed(changed: Set<keyof Choice>): void {
    if (changed.has("left") || changed.has("right")) {
      if (this.viewRow.isConnected) {
        this.views.forEach((view) => view.dispose());
        this.makeViews();
      }
      this.tree.setRun(this.firstRun());
      this.clock.setRuns();
      this.updateAll();
      return;
    }
    if (changed.has("camera") && this.state.choice.camera && !this.linking)
      this.views.forEach((v) => {
        if (changed.size > 1) v.putAt(this.state.choice.camera!);
      });
    if (changed.size === 1 && changed.has("camera")) return;
    if (changed.size === 1 && changed.has("hovered")) {
      this.tree.hover(this.state.choice.hovered);
      this.views.forEach((view) => view.update());
      return;
    }
    this.updateAll();
  }

  protected updateAll(): void {
    this.views.forEach((view) => view.update());
    this.tree.update();
    this.clock.update();
    this.info.update();
    this.legend();
    this.forces.update(this.views);
    this.scaleBars();
  }

  private legend(): void {
    const { colour } = this.state.choice,
      run = this.firstRun();
    const chip = (text: string, css: string) => {
      const made = element("span", "chip"),
        swatch = element("i");
      swatch.style.background = css;
      made.append(swatch, text);
      return made;
    };
    if (colour === "substance") this.bar.replaceChildren(...run.legend.map(([label, css]) => chip(label, css)));
    else if (colour === "generation") {
      const most = Math.max(...run.cells.map((c) => c.path.length));
      this.bar.replaceChildren(
        ...Array.from({ length: Math.min(most, 15) + 1 }, (_, g) =>
          chip(String(g), this.data.series[g % this.data.series.length]),
        ),
      );
    } else if (colour === "clone")
      this.bar.replaceChildren(
        ...["AA", "AB", "BA", "BB"]
          .filter((p) => run.byPath.has(p))
          .map((p) => chip(run.byPath.get(p)!.label, this.data.clones[p])),
      );
    else {
      const [low, high] = this.colouring.range(colour, this.state.choice.scaleNow ? this.state.choice.time : null),
        ramp = element("span", "ramp");
      ramp.style.background = `linear-gradient(to right, ${this.data.scale.join(",")})`;
      const [unit, factor] = this.data.units[colour] ?? ["", 1];
      this.bar.replaceChildren(
        `${colour.replace(/_/g, " ")}${unit ? ` [${unit}]` : ""}: ${numberText(factor * low)}`,
        ramp,
        numberText(factor * high),
      );
    }
  }
}

const place = document.getElementById("explore");
if (place && document.getElementById("data")) {
  const data = readData();
  if (data) {
    new Explorer(place, data);
    setUpCharts(data);
  } else
    place.textContent =
      "The program that made this page and its explorer are of two versions; ./morula report makes both anew.";
}
setUpCompare();
