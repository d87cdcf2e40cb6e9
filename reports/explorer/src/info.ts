// Information on the selected cell, and links to its relatives.
import { isWithin, numberText, shownText, type Cell, type Data, type Frame, type Run } from "./data";
import type { State } from "./state";
import { element } from "./tools";

export class Info {
  onPick: (path: string) => void = () => {};

  constructor(
    private readonly box: HTMLElement,
    private readonly data: Data,
    private readonly state: State,
  ) {}

  private button(cell: Cell, before = ""): HTMLButtonElement {
    const button = element("button", "", before + cell.label);
    button.type = "button";
    button.dataset.cell = cell.path;
    button.addEventListener("click", () => this.onPick(cell.path));
    return button;
  }

  private table(rows: [string, string][]): HTMLElement {
    const table = element("table"),
      body = element("tbody");
    for (const [name, value] of rows) {
      const row = element("tr"),
        head = element("th", "", name);
      head.scope = "row";
      row.append(head, element("td", "", value));
      body.append(row);
    }
    table.append(body);
    return table;
  }

  private relatives(cell: Cell): HTMLElement {
    const links = element("div", "links"),
      mother = cell.mother;
    if (mother) {
      links.append(this.button(mother, "mother "));
      for (const sister of mother.daughters) if (sister !== cell) links.append(this.button(sister, "sister "));
    }
    for (const daughter of cell.daughters) links.append(this.button(daughter, "daughter "));
    return links;
  }

  private neighbours(run: Run, frame: Frame, i: number): HTMLElement {
    const part = element("div");
    const touching = frame.contacts
      .filter((c) => c.a === i || c.b === i)
      .map((c) => ({ cell: run.cells[frame.cell[c.a === i ? c.b : c.a]], area: c.area }));
    touching.sort((a, b) => b.area - a.area || (a.cell.path < b.cell.path ? -1 : 1));
    part.append(
      element(
        "div",
        "",
        touching.length ? `Touches ${touching.length}, with contact areas:` : "Touches no other cell.",
      ),
    );
    const links = element("div", "links");
    for (const { cell, area } of touching) {
      const button = this.button(cell);
      button.append(` ${shownText(this.data, "contact", area)}`);
      links.append(button);
    }
    part.append(links);
    return part;
  }

  /** Returns the sizes of the net forces of each kind, and of their sum. */
  private forces(run: Run, frame: Frame, i: number): [string, string][] {
    const n = run.netForces.length,
      of = run.netForces.map((_, k) => [...frame.forces.subarray(3 * (i * n + k), 3 * (i * n + k) + 3)]);
    const all = [0, 1, 2].map((axis) => of.reduce((sum, force) => sum + force[axis], 0)),
      sizes = of.map((force) => Math.hypot(...force));
    const seen = run.netForces
      .map((kind, k): [string, number] => [kind, sizes[k]])
      .filter(([, size]) => size > 1e-9 * Math.max(...sizes));
    return n && Number.isFinite(sizes[0])
      ? [
          [
            "net force",
            `${numberText(Math.hypot(...all))} [force]` +
              (seen.length ? `: ${seen.map(([kind, size]) => `${kind} ${numberText(size)}`).join(", ")}` : ""),
          ],
        ]
      : [];
  }

  /** Shows a cell at the present time: measures and neighbours, or the reason why there are none. */
  private present(run: Run, cell: Cell): HTMLElement {
    const column = element("div"),
      { time } = this.state.choice;
    if (this.data.runs.length > 1) column.append(element("strong", "", run.title));
    if (!run.hasBodies) return column;
    const frame = run.frame(run.frameNumber(time)),
      i = frame.cell.findIndex((n) => run.cells[n] === cell);
    if (i >= 0) {
      const m = run.measures.length,
        rows: [string, string][] = [];
      for (let k = 0; k < m; ++k)
        if (Number.isFinite(frame.values[i * m + k]))
          rows.push([run.measures[k], shownText(this.data, run.measures[k], frame.values[i * m + k])]);
      column.append(this.table([...rows, ...this.forces(run, frame, i)]), this.neighbours(run, frame, i));
      return column;
    }
    let living = 0,
      volume = 0;
    const m = run.measures.indexOf("volume");
    for (let k = 0; k < frame.count; ++k)
      if (run.cells[frame.cell[k]] && isWithin(run.cells[frame.cell[k]].path, cell.path)) {
        ++living;
        if (m >= 0) volume += frame.values[k * run.measures.length + m];
      }
    if (living)
      column.append(
        element(
          "p",
          "",
          `${living} of its descendants live at this time` +
            (m >= 0 ? `; their volume is ${shownText(this.data, "volume", volume)}.` : "."),
        ),
      );
    else
      column.append(
        element(
          "p",
          "",
          cell.born > time ? "Not yet born at this time." : "Neither it nor a descendant lives at this time.",
        ),
      );
    return column;
  }

  update(): void {
    const { choice } = this.state,
      first = this.data.runs[choice.left];
    if (choice.selected === null) {
      this.box.replaceChildren(
        element(
          "p",
          "",
          "No cell is selected. Click on a cell or on a line of the tree; " +
            "arrow keys go on to mother, daughters and sister.",
        ),
      );
      return;
    }
    const shown = [first, ...(choice.right >= 0 ? [this.data.runs[choice.right]] : [])];
    const cell = shown.map((run) => run.byPath.get(choice.selected!)).find((c) => c);
    if (!cell) return;
    const run = shown.find((r) => r.byPath.has(choice.selected!))!;
    const descendants = run.cells.filter((c) => c !== cell && isWithin(c.path, cell.path)).length;
    const heading = element("h3", "", cell.label + (cell.name ? ` (${cell.path || "egg"})` : ""));
    const columns = element("div", "columns");
    const rows: [string, string][] = [
      ["substances", run.states[cell.state] || "none"],
      ["generation", String(cell.path.length)],
      ["born", shownText(this.data, "time", cell.born)],
      [cell.fate === "alive" ? "alive at the end" : cell.fate, shownText(this.data, "time", cell.ended)],
    ];
    if (descendants) rows.push(["descendants", String(descendants)]);
    const life = element("div");
    life.append(this.table(rows), this.relatives(cell));
    columns.append(life);
    for (const r of shown) {
      const there = r.byPath.get(choice.selected);
      if (there) columns.append(this.present(r, there));
      else columns.append(element("p", "", `${r.title}: there is no such cell.`));
    }
    this.box.replaceChildren(heading, columns);
  }
}
