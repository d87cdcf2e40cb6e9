// A run that grows while the explorer shows it.
import { blankFrame, Run, type Cell, type Data, type Frame } from "../data";
import { Explorer } from "../main";
import type { Measures, Read, Snapshot } from "./talk";

/** Returns the colour of the first substance with one, by its name or its longest prefix with a *; else grey. */
function colourOf(substances: string, colours: Record<string, string>): string {
  for (const name of substances.split(" ")) {
    const fits = Object.keys(colours)
      .filter((key) => key === name || (key.endsWith("*") && name.startsWith(key.slice(0, -1))))
      .sort((a, b) => b.length - a.length);
    if (name && fits.length) return colours[fits[0]];
  }
  return "#9aa0a6";
}

export class LiveRun extends Run {
  private readonly own: Frame[] = [];
  private readonly meshOf = new Map<number, number>(); // by number of vertices
  private readonly stateOf = new Map<string, number>(); // by substances
  private readonly grown: { cells: Cell[]; times: number[]; end: number };

  constructor(
    private readonly read: Read,
    measures: Measures,
  ) {
    super(
      {
        title: read.name,
        scenario: read.name,
        end: read.end ?? 0,
        states: [],
        colours: [],
        legend: Object.entries({ ...read.cellColours, ...read.colours }),
        measures: measures.cell,
        forces: [],
        netForces: [],
        shell: read.shell,
        radius: read.radius,
        meshes: [],
        cells: [],
        frames: [],
      },
      () => new Uint8Array(0),
    );
    this.grown = this as unknown as typeof this.grown;
  }

  get hasBodies(): boolean {
    return this.read.hasBodies;
  }
  frame(number: number): Frame {
    return this.own[number];
  }
  valuesOf(number: number): Float32Array {
    return this.own[number].values;
  }

  private state(substances: string): number {
    const known = this.stateOf.get(substances);
    if (known !== undefined) return known;
    this.stateOf.set(substances, this.states.length);
    this.colours.push(colourOf(substances, this.read.colours));
    return this.states.push(substances) - 1;
  }

  add({ time, step, lineage, cells = [], contacts = [], vertices, meshes }: Snapshot): void {
    for (const [path, , , , , , colour] of lineage ?? []) if (colour) this.cellColours[path] = colour;
    if (lineage)
      this.takeCells(
        lineage.map(([path, name, born, ended, fate, substances]) => [
          path,
          name,
          born,
          ended,
          fate,
          this.state(substances),
        ]),
      );
    for (const cell of this.cells) if (cell.fate === "alive") cell.ended = time;
    for (const [count, faces] of meshes) {
      this.meshOf.set(count, this.meshes.length);
      this.addMesh(Uint32Array.from(faces));
    }
    const m = this.measures.length,
      frame = blankFrame(time, step, cells.length, m);
    frame.contacts = contacts.map(([a, b, area]) => ({ a, b, area }));
    frame.positions = vertices;
    cells.forEach(([number, substances, values, count], i) => {
      frame.cell[i] = number;
      frame.state[i] = this.state(substances);
      frame.mesh[i] = this.meshOf.get(count) ?? 0;
      frame.values.set(
        values.map((x) => x ?? NaN),
        i * m,
      );
      frame.firstVertex[i + 1] = frame.firstVertex[i] + count;
    });
    this.own.push(frame);
    this.grown.times.push(time);
    this.grown.end = Math.max(this.read.end ?? 0, time);
  }
}

export class LiveExplorer extends Explorer {
  constructor(
    root: HTMLElement,
    data: Data,
    private readonly run: LiveRun,
  ) {
    super(root, data);
  }

  /** Shows the run's growth: updates the tree and the clock, and the organism at its last time. */
  grow(): void {
    this.tree.setRun(this.run);
    this.clock.setRuns();
    this.state.set({ time: this.run.times[this.run.times.length - 1] });
    this.updateAll();
  }

  leave(): void {
    for (const view of this.views) view.dispose();
  }
}
