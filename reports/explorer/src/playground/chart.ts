// A chart of one measure of the organism over time, which grows with the run.
import type { Data } from "../data";
import { LiveChart } from "../live_chart";
import { element } from "../tools";
import type { Measures } from "./talk";

export class Chart {
  readonly box = element("div", "measured");
  private readonly choice = element("select");
  private readonly chart = new LiveChart(180);
  private times: number[] = [];
  private values: (number | null)[][] = [];
  private end: number | null = null;
  private units: Data["units"] = {};

  constructor() {
    const label = element("label", "", "Over time ");
    this.choice.id = "measure";
    label.append(this.choice);
    this.box.append(label, this.chart.box);
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
      measure = this.choice.value;
    const unitOf = (what: string): [string, number] => this.units[what] ?? ["", 1],
      titled = (what: string) => what + (unitOf(what)[0] && ` [${unitOf(what)[0]}]`);
    const known = this.times.map((_, i) => i).filter((i) => this.values[i][k] != null),
      perTime = unitOf("time")[1];
    this.chart.show(
      titled("time"),
      known.length ? titled(measure) : `${measure}: not measured in this scenario`,
      [
        [
          measure,
          "#0b62b5",
          false,
          known.map((i) => perTime * this.times[i]),
          known.map((i) => unitOf(measure)[1] * this.values[i][k]!),
        ],
      ],
      perTime * (this.end ?? 0),
    );
  }
}
