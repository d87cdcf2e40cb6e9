// The page's data for the explorer, as runner/publish/report_data/explorer_data.cpp and frames.h write them.
import { strFromU8, unzlibSync } from "three/examples/jsm/libs/fflate.module.js";
import type { Line } from "./live_chart";
import { facesAcross } from "./occlusion";
import { unpacked, type FrameHead } from "./packed";

export type Fate = "alive" | "divided" | "died";

/** A cell that ever lived. Times are in the scene's unit. */
export interface Cell {
  path: string; // "" for the egg, then A and B
  name: string; // "" without a name
  born: number;
  ended: number; // for living cells: the run's end
  fate: Fate;
  state: number;
  label: string;
  mother: Cell | null;
  daughters: Cell[];
}

export type CellRow = [path: string, name: string, born: number, ended: number, fate: Fate, state: number];

interface Mesh {
  faces: Uint32Array;
  ball: Float32Array; // of spheres: vertices at distance 1 from the middle; empty for other cells
}

export interface Contact {
  a: number;
  b: number;
  area: number;
}

/** The living cells at one time; index i below is a cell of this frame. */
export interface Frame {
  time: number;
  step: number;
  count: number;
  cell: Uint32Array; // [i] number in Run.cells
  mesh: Uint32Array;
  state: Uint32Array;
  values: Float32Array; // [i * measures + m]
  contacts: Contact[];
  connections: [number, number][];
  forces: Float32Array; // [3 (i * Run.netForces + k)] net force of each kind on each cell; NaN: unknown
  vertexForces: VertexForces | null; // only in the last frame
  positions: Float32Array; // xyz of all vertices, cell after cell
  firstVertex: Uint32Array; // [i], and the number of all vertices at the end
}

/** Returns a frame with room for `count` cells and measures of each. */
export function blankFrame(time: number, step: number, count: number, measures: number): Frame {
  return {
    time,
    step,
    count,
    cell: new Uint32Array(count),
    mesh: new Uint32Array(count),
    state: new Uint32Array(count),
    values: new Float32Array(count * measures),
    contacts: [],
    connections: [],
    forces: new Float32Array(0),
    vertexForces: null,
    positions: new Float32Array(0),
    firstVertex: new Uint32Array(count + 1),
  };
}

/** Forces on the vertices of each cell, as runner/publish/report_data/frames.h writes them. */
export class VertexForces {
  private readonly steps: Float32Array; // [i * kinds + k]
  private readonly first: Uint32Array; // [i * kinds + k] index of its first number
  private readonly numbers: Int8Array;

  constructor(
    bytes: ArrayBuffer,
    at: number,
    private readonly kinds: number,
    firstVertex: Uint32Array,
  ) {
    const cells = firstVertex.length - 1,
      n = cells * kinds;
    this.steps = new Float32Array(bytes, at, n);
    this.first = new Uint32Array(n + 1);
    for (let k = 0; k < n; ++k) {
      const i = Math.floor(k / kinds);
      this.first[k + 1] = this.first[k] + (this.steps[k] > 0 ? 3 * (firstVertex[i + 1] - firstVertex[i]) : 0);
    }
    this.numbers = new Int8Array(bytes, at + 4 * n, this.first[n]);
  }

  /** Returns the forces [kind][3 * vertex of the cell] on a cell of the frame; null for kinds without forces. */
  of(cell: number): (Float32Array | null)[] {
    return Array.from({ length: this.kinds }, (_, kind) => {
      const k = cell * this.kinds + kind,
        step = this.steps[k];
      return step > 0
        ? Float32Array.from(this.numbers.subarray(this.first[k], this.first[k + 1]), (x) => step * x)
        : null;
    });
  }
}

export class Run {
  readonly title: string;
  readonly scenario: string;
  readonly end: number;
  readonly cells: Cell[] = [];
  readonly byPath = new Map<string, Cell>();
  readonly states: string[];
  readonly colours: string[];
  /** Colours that the scenario gives to cells, by path; they take the place of the colours of their states. */
  readonly cellColours: Record<string, string>;
  readonly legend: [string, string][];
  readonly measures: string[];
  readonly forces: string[]; // all kinds
  readonly netForces: string[]; // kinds whose net force on a cell may differ from 0
  readonly meshes: Uint32Array[] = [];
  readonly across: Uint32Array[] = []; // facesAcross of each mesh
  readonly vertexCounts: number[] = []; // vertices of each mesh whose places frames hold
  private readonly balls: Float32Array[] = []; // of spheres: vertices at distance 1 from the middle; empty for others
  readonly shell: { axes?: number[]; vertices?: number[]; faces?: number[] } | null;
  readonly radius: number;
  readonly times: number[];
  private readonly heads: FrameHead[] = [];
  private known: ArrayBuffer | null = null; // the frames, unpacked when one is first asked for
  private readonly kept = new Map<number, Frame>(); // the last few decoded frames

  constructor(
    json: any,
    private readonly packed: () => Uint8Array,
  ) {
    this.title = json.title;
    this.scenario = json.scenario;
    this.end = json.end;
    this.states = json.states;
    this.colours = json.colours;
    this.cellColours = json.cellColours ?? {};
    this.legend = json.legend;
    this.measures = json.measures;
    this.forces = json.forces;
    this.netForces = json.netForces;
    this.shell = json.shell;
    this.radius = json.radius;
    for (const { faces, ball } of json.meshes as Mesh[]) this.addMesh(faces, ball);
    this.takeCells(json.cells);
    let offset = 0;
    for (const [time, step, cells, contacts, connections, size, vertexForces] of json.frames) {
      this.heads.push({ time, step, cells, contacts, connections, offset, size, vertexForces });
      offset += size;
    }
    this.times = this.heads.map((head) => head.time);
  }

  protected addMesh(faces: Uint32Array, ball = new Float32Array(0)): void {
    this.meshes.push(faces);
    this.across.push(facesAcross(faces));
    this.balls.push(ball);
    this.vertexCounts.push(ball.length ? 0 : faces.reduce((most, v) => Math.max(most, v), -1) + 1);
  }

  private get bytes(): ArrayBuffer {
    return (this.known ??= unpacked(this.packed(), this.heads, this));
  }

  /** Replaces the cells that ever lived. */
  protected takeCells(rows: CellRow[]): void {
    this.cells.length = 0;
    this.byPath.clear();
    for (const [path, name, born, ended, fate, state] of rows) {
      const cell: Cell = {
        path,
        name,
        born,
        ended,
        fate,
        state,
        label: name || path || "egg",
        mother: null,
        daughters: [],
      };
      this.cells.push(cell);
      this.byPath.set(path, cell);
    }
    for (const cell of this.cells) {
      cell.mother = cell.path === "" ? null : (this.byPath.get(cell.path.slice(0, -1)) ?? null);
      cell.mother?.daughters.push(cell);
    }
    for (const cell of this.cells) cell.daughters.sort((a, b) => (a.path < b.path ? -1 : 1));
  }

  /** True if any cells of the run are ever connected. */
  get connected(): boolean {
    return this.heads.some((head) => head.connections > 0);
  }

  /** False for runs of a study that would leave no room for them: they are larger than ten frames. */
  get hasVertexForces(): boolean {
    return this.heads.some((head) => head.vertexForces > 0);
  }

  get hasBodies(): boolean {
    return this.heads.length > 0;
  }

  /** Returns the last frame at `time` or before; the first frame if all are later. */
  frameNumber(time: number): number {
    let low = 0,
      high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time * (1 + 1e-12)) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }

  frame(number: number): Frame {
    const known = this.kept.get(number);
    if (known) return known;
    const frame = this.decode(this.heads[number]);
    if (this.kept.size >= 8) this.kept.delete(this.kept.keys().next().value!);
    this.kept.set(number, frame);
    return frame;
  }

  /** Returns the values of a frame's cells, [i * measures + m], without decoding shapes. */
  valuesOf(number: number): Float32Array {
    const head = this.heads[number],
      m = this.measures.length,
      words = 7 + m;
    const reals = new Float32Array(this.bytes, head.offset, head.cells * words),
      values = new Float32Array(head.cells * m);
    for (let i = 0; i < head.cells; ++i) values.set(reals.subarray(i * words + 7, (i + 1) * words), i * m);
    return values;
  }

  private decode(head: FrameHead): Frame {
    const m = this.measures.length,
      words = 7 + m;
    const numbers = new Uint32Array(this.bytes, head.offset, head.cells * words);
    const reals = new Float32Array(this.bytes, head.offset, head.cells * words);
    const frame = blankFrame(head.time, head.step, head.cells, m);
    for (let i = 0; i < head.cells; ++i) {
      const at = i * words;
      frame.cell[i] = numbers[at];
      frame.mesh[i] = numbers[at + 1];
      frame.state[i] = numbers[at + 2];
      frame.values.set(reals.subarray(at + 7, at + words), i * m);
      frame.firstVertex[i + 1] =
        frame.firstVertex[i] + this.vertexCounts[frame.mesh[i]] + this.balls[frame.mesh[i]].length / 3;
    }
    let place = head.offset + 4 * head.cells * words;
    const pairs = new Uint32Array(this.bytes, place, 3 * head.contacts),
      areas = new Float32Array(this.bytes, place, 3 * head.contacts);
    for (let k = 0; k < head.contacts; ++k)
      frame.contacts.push({ a: pairs[3 * k], b: pairs[3 * k + 1], area: areas[3 * k + 2] });
    place += 12 * head.contacts;
    const held = new Uint32Array(this.bytes, place, 2 * head.connections);
    for (let k = 0; k < head.connections; ++k) frame.connections.push([held[2 * k], held[2 * k + 1]]);
    place += 8 * head.connections;
    frame.forces = new Float32Array(this.bytes, place, 3 * this.netForces.length * head.cells);
    place += 4 * frame.forces.length;
    if (head.vertexForces)
      frame.vertexForces = new VertexForces(
        this.bytes,
        head.offset + head.vertexForces,
        this.forces.length,
        frame.firstVertex,
      );
    frame.positions = new Float32Array(3 * frame.firstVertex[head.cells]);
    for (let i = 0; i < head.cells; ++i) {
      const low = reals.subarray(i * words + 3, i * words + 6),
        step = reals[i * words + 6],
        first = 3 * frame.firstVertex[i],
        count = 3 * frame.firstVertex[i + 1] - first,
        ball = this.balls[frame.mesh[i]],
        shape = ball.length ? ball : new Uint16Array(this.bytes, place, count);
      for (let k = 0; k < count; k += 3)
        for (let axis = 0; axis < 3; ++axis) frame.positions[first + k + axis] = low[axis] + step * shape[k + axis];
      if (!ball.length) place += 2 * count;
    }
    return frame;
  }
}

export interface Data {
  runs: Run[];
  /** Shown units of measures, time, the scale bar and contact areas: [name, number of them in a unit of the scene]. */
  units: Record<string, [string, number]>;
  scale: string[];
  series: string[];
  clones: Record<string, string>; // by the path of the founder, or of a cell above founders
  forces: { name: string; colour: string; meaning: string }[]; // kinds
  charts?: Record<string, [x: string, y: string, lines: Line[]]>; // by the ids of their pictures
}

/** Returns the bytes that the page's element holds in base64. */
export function bytesOf(id: string): Uint8Array {
  return Uint8Array.from(atob(document.getElementById(id)?.textContent ?? ""), (c) => c.charCodeAt(0));
}

const format = 5; // explorerFormat in runner/publish/report_data/explorer_data.cpp

/** Returns the rows of a run's cells, and the colours that the scenario gives single ones. */
function cellsOf(run: number): { cells: CellRow[]; cellColours: Record<string, string> } {
  return JSON.parse(strFromU8(unzlibSync(bytesOf(`cells-${run}`))));
}

/** Returns the page's data; null if a program with another format made the page. */
export function readData(): Data | null {
  const json = JSON.parse(document.getElementById("data")!.textContent!);
  if (json.morula !== format) return null;
  const meshes: Mesh[] = json.meshes.map((faces: number[], k: number) => ({
    faces: Uint32Array.from(faces),
    ball: Float32Array.from(json.balls[k]),
  }));
  return {
    units: json.units,
    scale: json.scale,
    series: json.series,
    clones: json.clones,
    charts: json.charts,
    forces: json.forces.map(([name, colour, meaning]: string[]) => ({ name, colour, meaning })),
    runs: json.runs.map(
      (run: any, i: number) =>
        new Run({ ...run, ...cellsOf(i), meshes: run.meshes.map((k: number) => meshes[k]) }, () =>
          bytesOf(`frames-${i}`),
        ),
    ),
  };
}

export function isWithin(path: string, ancestor: string): boolean {
  return path.startsWith(ancestor);
}

/** Returns a measure's value, or a time, with its unit: "12.5 µm". */
export function shownText(data: Pick<Data, "units">, measure: string, value: number): string {
  const [unit, factor] = data.units[measure] ?? ["", 1];
  return numberText(factor * value) + (unit && Number.isFinite(value) ? ` ${unit}` : "");
}

/** Returns a number with four digits. */
export function numberText(x: number): string {
  if (!Number.isFinite(x)) return "not measured";
  return Number.isInteger(x) && Math.abs(x) < 1e6 ? String(x) : Number(x.toPrecision(4)).toString();
}
