// The lineage tree: time runs to the right; each cell is a line, with daughter A above and B below.
import type { Colouring } from "./colours";
import { isWithin, shownText, type Cell, type Data, type Run } from "./data";
import type { State } from "./state";
import { drawn } from "./tools";

const topRoom = 22,
  leftRoom = 8,
  readableRow = 15; // [pixel]
const maxLetters = 21; // max letters of a name

/** Returns about `wanted` round numbers from 0 to `most`. */
export function ticks(most: number, wanted: number): number[] {
  const raw = most / wanted,
    power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((x) => x * power).find((x) => x >= raw) ?? raw,
    numbers: number[] = [];
  for (let k = 0; k * step <= most * (1 + 1e-9); ++k) numbers.push(Number((k * step).toPrecision(12)));
  return numbers;
}

export class Tree {
  onPick: (path: string) => void = () => {};
  onHover: (path: string | null, x: number, y: number) => void = () => {};
  private readonly rows = new Map<Cell, number>();
  private readonly nodes = new Map<string, SVGGElement>();
  private now = drawn("line", { class: "now" });
  private place: (time: number) => number = () => 0;
  private leaves = 0;
  private whole = true; // true: the tree fits the pane; false: every row is readable

  constructor(
    private readonly pane: HTMLElement,
    private run: Run,
    private readonly state: State,
    private readonly colouring: Colouring,
    private readonly data: Pick<Data, "units">,
  ) {
    pane.addEventListener("click", (e) => {
      const path = this.pathAt(e);
      if (path !== null) this.onPick(path);
    });
    pane.addEventListener("pointermove", (e) => this.onHover(this.pathAt(e), e.clientX, e.clientY));
    pane.addEventListener("pointerleave", () => this.onHover(null, 0, 0));
    pane.addEventListener("focusin", (e) => {
      const path = this.pathAt(e);
      if (path !== null) this.onHover(path, 0, 0);
    });
    new ResizeObserver(() => this.build()).observe(pane);
    this.setRun(run);
  }

  private pathAt(event: Event): string | null {
    const node = (event.target as Element).closest?.("[data-path]");
    return node ? node.getAttribute("data-path") : null;
  }

  setRun(run: Run): void {
    this.run = run;
    this.rows.clear();
    this.leaves = 0;
    // Leaves stand below each other, a mother in the middle of her daughters.
    const roots = run.cells.filter((cell) => !cell.mother).sort((a, b) => (a.path < b.path ? -1 : 1));
    const visit = (cell: Cell): number => {
      const row = cell.daughters.length
        ? cell.daughters.map(visit).reduce((a, b) => a + b) / cell.daughters.length
        : this.leaves++;
      this.rows.set(cell, row);
      return row;
    };
    roots.forEach(visit);
    this.whole = this.leaves <= 128;
    this.build();
  }

  get canFit(): boolean {
    return this.leaves * readableRow + topRoom + 12 > this.pane.clientHeight;
  }
  get isWhole(): boolean {
    return this.whole;
  }
  fit(whole: boolean): void {
    this.whole = whole;
    this.build();
  }

  private build(): void {
    const w = Math.max(200, this.pane.clientWidth - 2),
      h = Math.max(120, this.pane.clientHeight - 2);
    const fitted = (h - topRoom - 10) / Math.max(1, this.leaves),
      row = this.whole ? Math.min(34, fitted) : Math.max(readableRow, Math.min(34, fitted));
    const height = Math.round(topRoom + 10 + row * this.leaves),
      labels = row >= 9;
    const longest = Math.max(
      1,
      ...this.run.cells.filter((c) => !c.daughters.length).map((c) => Math.min(maxLetters + 1, c.label.length)),
    );
    const rightRoom = labels ? 12 + Math.min(0.4 * w, 6.8 * longest) : 10,
      end = this.run.end || 1;
    this.place = (time) => leftRoom + ((w - leftRoom - rightRoom) * time) / end;
    const y = (cell: Cell) => topRoom + row * (this.rows.get(cell)! + 0.5);
    const svg = drawn("svg", {
      width: w,
      height,
      viewBox: `0 0 ${w} ${height}`,
      role: "tree",
      "aria-label":
        `Lineage of ${this.run.title}: ${this.run.cells.length} cells. ` +
        "Arrow keys: mother to the left, daughter to the right, sister up and down",
    });
    const axis = drawn("g", { class: "axis", "aria-hidden": "true" });
    const [unit, perTime] = this.data.units.time ?? ["", 1],
      marks = ticks(perTime * end, Math.max(2, Math.round(w / 90)));
    for (const t of marks) {
      const x = this.place(t / perTime);
      axis.append(drawn("line", { x1: x, x2: x, y1: topRoom - 6, y2: height }));
      const text = drawn("text", { x: x + 2, y: 11 });
      text.textContent = unit && t === 0 ? `0 ${unit}` : String(t);
      axis.append(text);
    }
    svg.append(axis);
    this.nodes.clear();
    const thickness = Math.max(1, Math.min(3, 0.7 * row));
    for (const cell of this.run.cells) {
      const called = cell.label + (cell.name && cell.path ? ` (${cell.path})` : "");
      const ending =
        cell.fate === "alive" ? "alive at the end" : `${cell.fate} at ${shownText(this.data, "time", cell.ended)}`;
      const node = drawn("g", {
        "data-path": cell.path,
        role: "treeitem",
        tabindex: -1,
        "aria-level": cell.path.length + 1,
        "aria-selected": "false",
        "aria-label": `${called}, born at ${shownText(this.data, "time", cell.born)}, ${ending}`,
      });
      const x1 = this.place(cell.born),
        x2 = Math.max(this.place(cell.ended), x1 + 1),
        at = y(cell);
      if (cell.daughters.length > 1)
        node.append(
          drawn("path", {
            class: "fork",
            d: `M${x2} ${y(cell.daughters[0])}V${y(cell.daughters[cell.daughters.length - 1])}`,
          }),
        );
      const life = drawn("path", { class: "life", d: `M${x1} ${at}H${x2}`, stroke: this.run.cellColours[cell.path] ?? this.run.colours[cell.state] });
      life.style.strokeWidth = thickness < 3 ? `${thickness}px` : "";
      node.append(life);
      if (cell.fate === "died") node.append(drawn("path", { class: "fork", d: `M${x2 - 3} ${at - 3}l6 6m0 -6l-6 6` }));
      node.append(
        drawn("path", {
          class: "hit",
          d: `M${x1} ${at}H${x2 + (cell.daughters.length ? 0 : rightRoom - 4)}`,
          "stroke-width": Math.max(3, Math.min(14, row)),
        }),
      );
      if (labels && !cell.daughters.length) {
        const text = drawn("text", { x: x2 + 5, y: at + 4 });
        text.textContent = cell.label.slice(0, maxLetters);
        node.append(text);
        if (cell.label.length > maxLetters) {
          // The invisible rest of the name is for screen readers: visible text must be part of the accessible name.
          const rest = drawn("tspan", {}),
            more = drawn("text", { x: w - 2, y: at + 4, "text-anchor": "end", "aria-hidden": "true" });
          rest.textContent = cell.label.slice(maxLetters);
          rest.style.fill = "transparent";
          text.append(rest);
          more.textContent = "…";
          svg.append(more);
        }
      }
      svg.append(node);
      this.nodes.set(cell.path, node);
    }
    this.now = drawn("line", { class: "now", y1: topRoom - 6, y2: height, "aria-hidden": "true" });
    svg.append(this.now);
    this.pane.replaceChildren(svg);
    this.update();
  }

  update(): void {
    const { choice } = this.state,
      selected = choice.selected === null ? undefined : this.run.byPath.get(choice.selected);
    const dims = selected !== undefined && selected.daughters.length > 0;
    for (const cell of this.run.cells) {
      const node = this.nodes.get(cell.path)!;
      node.classList.toggle("dim", dims && !isWithin(cell.path, selected!.path));
      node.classList.toggle("unborn", cell.born > choice.time);
      node.classList.toggle("selected", cell === selected);
      node.classList.toggle("hover", cell.path === choice.hovered);
      node.setAttribute("aria-selected", String(cell === selected));
      (node.querySelector(".life") as SVGPathElement).setAttribute(
        "stroke",
        this.colouring.ofLine(this.run, cell.path, cell.state, choice.colour),
      );
    }
    const entry = selected ?? this.run.cells[0];
    for (const node of this.nodes.values()) if (node.tabIndex === 0) node.tabIndex = -1;
    if (entry) this.nodes.get(entry.path)!.tabIndex = 0;
    this.now.setAttribute("x1", String(this.place(choice.time)));
    this.now.setAttribute("x2", String(this.place(choice.time)));
  }

  hover(path: string | null): void {
    for (const [of, node] of this.nodes) node.classList.toggle("hover", of === path);
  }

  reveal(path: string, focus: boolean): void {
    const node = this.nodes.get(path);
    if (!node) return;
    const box = node.getBoundingClientRect(),
      pane = this.pane.getBoundingClientRect();
    if (box.top < pane.top || box.bottom > pane.bottom) this.pane.scrollTop += box.top - pane.top - pane.height / 2;
    if (focus) node.focus({ preventScroll: true });
  }
}
