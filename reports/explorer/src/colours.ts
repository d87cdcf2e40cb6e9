// The colours of cells.
import type { Data, Frame, Run } from "./data";

export type Rgb = [number, number, number]; // 0 to 1, sRGB

export function rgbOf(hex: string): Rgb {
  const n = parseInt(hex.slice(1), 16);
  return [((n >> 16) & 255) / 255, ((n >> 8) & 255) / 255, (n & 255) / 255];
}

/** Colours by substances, generation, clone or a measure, whose scale spans its values in all frames. */
export class Colouring {
  private readonly scale: Rgb[];
  private readonly series: Rgb[];
  private readonly ranges = new Map<string, [number, number]>();

  constructor(private readonly data: Data) {
    this.scale = data.scale.map(rgbOf);
    this.series = data.series.map(rgbOf);
  }

  /** Returns the meanings that colours can have in these runs. */
  choices(): string[] {
    const measures = new Set<string>();
    for (const run of this.data.runs) run.measures.forEach((m) => measures.add(m));
    return ["substance", "generation", "clone", ...measures];
  }

  /** Returns the least and greatest value of a measure in all runs, at one time or (null) in all frames. */
  range(measure: string, time: number | null): [number, number] {
    const key = `${measure} ${time}`,
      known = this.ranges.get(key);
    if (known) return known;
    if (this.ranges.size > 1000) this.ranges.clear();
    let low = Infinity,
      high = -Infinity;
    for (const run of this.data.runs) {
      const m = run.measures.indexOf(measure),
        n = run.measures.length;
      if (m < 0 || !run.hasBodies) continue;
      const one = time === null ? null : run.frameNumber(time);
      for (let k = one ?? 0; k <= (one ?? run.times.length - 1); ++k) {
        const values = run.valuesOf(k);
        for (let i = m; i < values.length; i += n)
          if (Number.isFinite(values[i])) {
            low = Math.min(low, values[i]);
            high = Math.max(high, values[i]);
          }
      }
    }
    const range: [number, number] = low <= high ? [low, high] : [0, 1];
    this.ranges.set(key, range);
    return range;
  }

  at(share: number): Rgb {
    const x = Math.min(1, Math.max(0, share)) * (this.scale.length - 1),
      i = Math.min(this.scale.length - 2, Math.floor(x)),
      f = x - i;
    return [0, 1, 2].map((k) => this.scale[i][k] * (1 - f) + this.scale[i + 1][k] * f) as Rgb;
  }

  /** Clones begin with the four cells after two divisions. */
  private clone(path: string): Rgb {
    return rgbOf(this.data.clones[path.slice(0, 2)]);
  }

  ofCell(run: Run, frame: Frame, i: number, by: string, time: number | null): Rgb {
    const cell = run.cells[frame.cell[i]];
    const own = rgbOf((cell && run.cellColours[cell.path]) ?? run.colours[frame.state[i]]);
    if (by === "substance" || !cell) return own;
    if (by === "generation") return this.series[cell.path.length % this.series.length];
    if (by === "clone") return this.clone(cell.path);
    const m = run.measures.indexOf(by);
    if (m < 0) return own;
    const [low, high] = this.range(by, time),
      value = frame.values[i * run.measures.length + m];
    if (!Number.isFinite(value)) return [0.74, 0.74, 0.74];
    return this.at(high > low ? (value - low) / (high - low) : 0.5);
  }

  /** Returns a cell's colour in the tree: by its last substances, and grey for measures, which change with time. */
  ofLine(run: Run, path: string, state: number, by: string): string {
    const css = (c: Rgb) => `rgb(${c.map((x) => Math.round(255 * x)).join(",")})`;
    if (by === "generation") return css(this.series[path.length % this.series.length]);
    if (by === "clone") return css(this.clone(path));
    return run.cellColours[path] ?? run.colours[state];
  }
}
