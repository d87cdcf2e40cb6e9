// A chart of one measure of the organism over time, which grows with the run.
import { shownText, type Data } from "../data";
import { drawn, element } from "../tools";
import type { Measures } from "./talk";

const width = 600,
  height = 120;

export class Chart {
  readonly box = element("div", "measured");
  private readonly choice = element("select");
  private readonly line = drawn("polyline");
  private readonly said = element("span", "note");
  private times: number[] = [];
  private values: (number | null)[][] = [];
  private end: number | null = null;
  units: Data["units"] = {};

  constructor() {
    const label = element("label", "", "Over time ");
    const picture = drawn("svg", {
      viewBox: `0 0 ${width} ${height}`,
      preserveAspectRatio: "none",
      "aria-hidden": "true",
    });
    this.choice.id = "measure";
    label.append(this.choice);
    picture.append(this.line);
    this.box.append(label, " ", this.said, picture);
    this.box.hidden = true;
    this.choice.addEventListener("change", () => this.draw());
  }

  begin({ world, units }: Measures, end: number | null): void {
    const chosen = this.choice.value;
    this.times = [];
    this.values = [];
    this.end = end;
    this.units = units;
    this.choice.replaceChildren(...world.map((name) => element("option", "", name)));
    if (world.includes(chosen)) this.choice.value = chosen;
    this.box.hidden = false;
  }

  add(time: number, values: (number | null)[]): void {
    this.times.push(time);
    this.values.push(values);
    this.draw();
  }

  private draw(): void {
    const k = this.choice.selectedIndex,
      known = this.times
        .map((time, i): [number, number | null] => [time, this.values[i][k] ?? null])
        .filter((p): p is [number, number] => p[1] !== null);
    const low = Math.min(...known.map(([, y]) => y)),
      high = Math.max(...known.map(([, y]) => y)),
      last = this.end ?? (this.times[this.times.length - 1] || 1);
    this.line.setAttribute(
      "points",
      known
        .map(([x, y]) => `${(width * x) / (last || 1)},${height - 4 - ((height - 8) * (y - low)) / (high - low || 1)}`)
        .join(" "),
    );
    const text = (y: number): string => shownText(this, this.choice.value, y);
    this.said.textContent = known.length
      ? `${text(known[known.length - 1][1])}, from ${text(low)} to ${text(high)}`
      : "not measured in this scenario";
  }
}
