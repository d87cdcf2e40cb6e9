// The arrows of forces that are shown, and their scale.
import type { Arrow } from "./arrows";
import { rgbOf } from "./colours";
import { isWithin, type Data, type Frame, type Run } from "./data";
import type { Choice } from "./state";

const shortest = 1 / 200; // of the longest arrow: shorter arrows are left out

export function isWished(choice: Choice, kind: string): boolean {
  return choice.kinds === "all" || choice.kinds.split(",").includes(kind);
}

/** Returns the kinds of data.forces that these runs have. */
export function kindsOf(data: Data): Data["forces"] {
  return data.forces.filter((kind) => data.runs.some((run) => run.forces.includes(kind.name)));
}

/** Returns the radius [length] of a ball with the cells' mean volume. */
function meanRadius(run: Run, frame: Frame): number {
  const m = run.measures.indexOf("volume"),
    n = run.measures.length;
  let volume = 0;
  for (let i = 0; i < frame.count && m >= 0; ++i) volume += frame.values[i * n + m];
  return volume > 0 ? Math.cbrt((3 * volume) / (4 * Math.PI * frame.count)) : run.radius;
}

interface Forces {
  of: { run: Run; frame: Frame; cell: number };
  kind: string;
  at: [number, number, number];
  force: [number, number, number];
}

/** Returns the selected cell if forces on its vertices are known, which are then shown; else -1. */
export function cellWithVertexForces(run: Run, choice: Choice): number {
  const frame = run.frame(run.frameNumber(choice.time));
  return frame.vertexForces
    ? frame.cell.findIndex((n) => choice.selected !== null && run.cells[n]?.path === choice.selected)
    : -1;
}

function* onVertices(run: Run, frame: Frame, cell: number, choice: Choice): Generator<Forces> {
  const { positions, firstVertex } = frame,
    forces = frame.vertexForces!.of(cell);
  for (const [k, kind] of run.forces.entries()) {
    if (!isWished(choice, kind) || !forces[k]) continue;
    for (let v = 3 * firstVertex[cell], f = 0; v < 3 * firstVertex[cell + 1]; v += 3, f += 3)
      yield {
        of: { run, frame, cell },
        kind,
        at: [positions[v], positions[v + 1], positions[v + 2]],
        force: [forces[k]![f], forces[k]![f + 1], forces[k]![f + 2]],
      };
  }
}

function* onCells(run: Run, frame: Frame, choice: Choice, centres: ArrayLike<number>): Generator<Forces> {
  for (let cell = 0; cell < frame.count; ++cell)
    for (const [k, kind] of run.netForces.entries()) {
      const f = 3 * (cell * run.netForces.length + k);
      if (isWished(choice, kind))
        yield {
          of: { run, frame, cell },
          kind,
          at: [centres[3 * cell], centres[3 * cell + 1], centres[3 * cell + 2]],
          force: [frame.forces[f], frame.forces[f + 1], frame.forces[f + 2]],
        };
    }
}

function strength(force: readonly number[]): number {
  return Math.hypot(force[0], force[1], force[2]);
}

/**
 * The forces shown for one run. `longest`: the largest one [force]; `room`: the room for its arrow [length]; `size`:
 * the farthest distance of a point from the origin [length].
 */
export class ForcesOfRun {
  readonly forces: Forces[];
  readonly longest: number;
  readonly room: number;
  readonly ofVertices: boolean;

  constructor(
    private readonly run: Run,
    private readonly choice: Choice,
    private readonly colours: Map<string, string>,
    size: number,
    centres: ArrayLike<number>,
  ) {
    const frame = run.frame(run.frameNumber(choice.time)),
      cell = cellWithVertexForces(run, choice);
    this.ofVertices = cell >= 0;
    this.forces = [...(cell >= 0 ? onVertices(run, frame, cell, choice) : onCells(run, frame, choice, centres))];
    this.longest = this.forces.reduce((most, { force }) => Math.max(most, strength(force) || 0), 0);
    // Arrows begin at a cell's middle, or at its surface, where at most a tenth of the view is left.
    this.room = this.ofVertices ? Math.min(0.3 * meanRadius(run, frame), 0.1 * size) : 0.8 * meanRadius(run, frame);
  }

  /**
   * Returns the arrows, with lengths of `perForce` [length/force]. `isThere`: tells if a point is not cut away. If a
   * cell is selected that has forces, or whose descendants have, only their arrows are shown.
   */
  arrows(perForce: number, isThere: (at: [number, number, number]) => boolean): (Arrow & { kind: string })[] {
    const { selected } = this.choice,
      { run } = this,
      within = (n: number) => isWithin(run.cells[n]?.path ?? "", selected!);
    const some = selected !== null && this.forces.some(({ of }) => within(of.frame.cell[of.cell]));
    return this.forces
      .filter(
        ({ force, at, of }) =>
          strength(force) > shortest * this.longest && isThere(at) && (!some || within(of.frame.cell[of.cell])),
      )
      .map(({ at, force, kind }) => ({
        kind,
        from: at,
        along: force.map((x) => x * perForce) as [number, number, number],
        colour: rgbOf(this.colours.get(kind)!),
      }));
  }
}
