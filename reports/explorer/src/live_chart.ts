// Charts of lines that answer: values at the pointer, and a part enlarged by dragging; a double click shows all again.
import uPlot from "uplot";
import style from "uplot/dist/uPlot.min.css";
import { numberText, type Data } from "./data";
import { element } from "./tools";

export type Line = [label: string, colour: string, isDashed: boolean, xs: number[], ys: number[]];

const ink = "#1b1f24",
  grid = { stroke: "#d9d9d4", width: 1 },
  font = '11px "DejaVu Sans", sans-serif',
  axis = { stroke: ink, grid, ticks: grid, font, labelFont: font };
let styled = false;

export class LiveChart {
  readonly box = element("div", "live");
  private readonly said = element("p", "note", "\u00a0");
  private plot: uPlot | null = null;

  constructor(private readonly height = 260) {
    this.box.append(this.said);
    if (!styled) document.head.append(element("style", "", style));
    styled = true;
    new ResizeObserver(() => this.plot?.setSize(this.size())).observe(this.box);
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(100, this.box.clientWidth), height: this.height };
  }

  /** Draws these lines. `end`: how far the x axis goes, at least. */
  show(x: string, y: string, lines: Line[], end = 0): void {
    // Steps have two points at one place, of which the later one counts.
    const isStepped = lines.map(([, , , xs]) => xs.some((value, i) => value === xs[i + 1]));
    const tables = lines.map(([, , , xs, ys]): uPlot.AlignedData => {
      const last = xs.map((_, i) => i).filter((i) => xs[i] !== xs[i + 1]);
      return [last.map((i) => xs[i]), last.map((i) => ys[i])];
    });
    const stepped = uPlot.paths.stepped!({ align: 1 });
    this.plot?.destroy();
    this.plot = new uPlot(
      {
        ...this.size(),
        legend: { show: false },
        cursor: { points: { show: lines.length <= 12 } },
        scales: { x: { time: false, range: (_, low, high) => [low, Math.max(high, end)] } },
        axes: [
          { label: x, labelSize: 22, ...axis },
          { label: y, labelSize: 22, size: 56, ...axis },
        ],
        series: [
          {},
          ...lines.map(([label, stroke, isDashed], i) => ({
            label,
            stroke,
            dash: isDashed ? [6, 4] : undefined,
            width: 1.5,
            spanGaps: true,
            points: { show: false },
            paths: isStepped[i] ? stepped : undefined,
          })),
        ],
        hooks: { setCursor: [(plot: uPlot) => this.say(plot)] },
      },
      tables.length ? uPlot.join(tables) : [[]],
    );
    this.box.prepend(this.plot.root);
  }

  /** Tells the values of the line that is nearest to the pointer. */
  private say(plot: uPlot): void {
    const { idx, top } = plot.cursor;
    let text = "\u00a0",
      nearest = Infinity;
    for (let k = 1; k < plot.data.length && idx != null && top != null && top >= 0; ++k) {
      let at = idx; // lines have values at times of their own
      while (at > 0 && plot.data[k][at] == null) --at;
      const value = plot.data[k][at];
      if (value == null) continue;
      const away = Math.abs(plot.valToPos(value, "y") - top);
      if (away >= nearest) continue;
      nearest = away;
      const { label } = plot.series[k];
      text = `${label ? `${label}: ` : ""}${numberText(value)} at ${numberText(plot.data[0][at])}`;
    }
    this.said.textContent = text;
  }
}

/** Draws the page's charts when they come into view; their pictures remain for paper. */
export function setUpCharts({ charts = {} }: Data): void {
  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      const chart = new LiveChart();
      target.querySelector("figure")!.prepend(chart.box);
      chart.show(...charts[target.id]);
      const canvas = chart.box.querySelector("canvas")!;
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", target.querySelector("img")!.alt);
      target.classList.add("alive");
    }
  });
  for (const id of Object.keys(charts)) seen.observe(document.getElementById(id)!);
}
