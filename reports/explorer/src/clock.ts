// Time: a slider, marks where cells divide, and play.
import { shownText, type Data, type Run } from "./data";
import type { State } from "./state";
import { drawn } from "./tools";

const playSeconds = 8; // duration of the whole run

export class Clock {
  readonly slider = document.createElement("input");
  private readonly play = document.createElement("button");
  private readonly output = document.createElement("output");
  private readonly marks = drawn("svg", { viewBox: "0 0 1000 9", preserveAspectRatio: "none", "aria-hidden": "true" });
  private times: number[] = [];
  private playing = false;

  constructor(
    parent: HTMLElement,
    private readonly data: Data,
    private readonly state: State,
  ) {
    this.slider.type = "range";
    this.slider.id = "time";
    this.slider.min = "0";
    this.slider.step = "any";
    this.slider.setAttribute("aria-label", "Time");
    this.play.id = "play";
    this.play.type = "button";
    this.output.htmlFor.add("time");
    const slide = document.createElement("div");
    slide.className = "slide";
    slide.append(this.slider, this.marks);
    parent.append(this.play, slide, this.output);
    this.slider.addEventListener("input", () => {
      this.stop();
      this.state.set({ time: Number(this.slider.value) });
    });
    this.slider.addEventListener("keydown", (e) => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
      if (!by) return;
      e.preventDefault();
      this.stop();
      this.step(by);
    });
    this.play.addEventListener("click", () => this.toggle());
    this.showPlaying();
    this.setRuns();
  }

  private shown(): Run[] {
    const { left, right } = this.state.choice;
    return [this.data.runs[left], ...(right >= 0 ? [this.data.runs[right]] : [])];
  }

  setRuns(): void {
    const runs = this.shown(),
      end = Math.max(...runs.map((run) => run.end)),
      times = new Set<number>([0, end]);
    for (const run of runs)
      for (const time of run.hasBodies ? run.times : run.cells.flatMap((c) => [c.born, c.ended])) times.add(time);
    this.times = [...times].sort((a, b) => a - b);
    this.slider.max = String(end);
    const divisions = new Set(runs.flatMap((run) => run.cells.filter((c) => c.fate === "divided").map((c) => c.ended)));
    this.marks.replaceChildren();
    for (const time of divisions) {
      // The slider's knob keeps half of its width from both ends.
      const x = (1000 * time) / (end || 1);
      this.marks.append(drawn("line", { x1: x, x2: x, y1: 0, y2: 9 }));
    }
    this.marks.style.margin = "0 8px";
    this.marks.style.width = "calc(100% - 16px)";
  }

  /** Goes to a later or an earlier frame. */
  step(by: number): void {
    const { time } = this.state.choice,
      slack = 1e-9 * (this.times[this.times.length - 1] || 1);
    const at =
      by > 0
        ? this.times.findIndex((t) => t > time + slack)
        : this.times.map((t) => t < time - slack).lastIndexOf(true);
    const last = this.times.length - 1,
      from = at < 0 ? (by > 0 ? last : 0) : at;
    this.state.set({ time: this.times[Math.min(last, Math.max(0, from + by - Math.sign(by)))] });
  }

  toggle(): void {
    if (this.playing) this.stop();
    else this.start();
  }

  private start(): void {
    const end = this.times[this.times.length - 1];
    if (this.state.choice.time >= end * (1 - 1e-9)) this.state.set({ time: 0 });
    this.playing = true;
    this.showPlaying();
    const from = this.state.choice.time,
      began = performance.now();
    const go = (now: number) => {
      if (!this.playing) return;
      const time = from + ((now - began) / 1000 / playSeconds) * end;
      this.state.set({ time: Math.min(end, Math.max(from, time)) });
      if (time >= end) this.stop();
      else requestAnimationFrame(go);
    };
    requestAnimationFrame(go);
  }

  private stop(): void {
    this.playing = false;
    this.showPlaying();
  }

  private showPlaying(): void {
    this.play.textContent = this.playing ? "❚❚ Pause" : "▶ Play";
    this.play.setAttribute("aria-pressed", String(this.playing));
  }

  update(): void {
    const { time } = this.state.choice;
    const living = this.shown().map((run) => {
      const at = Math.min(time, run.end);
      return run.cells.filter((c) => c.born <= at && (at < c.ended || (c.fate === "alive" && at <= c.ended))).length;
    });
    const counts = living.map((n) => `${n} ${n === 1 ? "cell" : "cells"}`).join(" | "),
      text = `time ${shownText(this.data, "time", time)}, ${counts}`;
    if (Number(this.slider.value) !== time) this.slider.value = String(time);
    this.slider.setAttribute("aria-valuetext", text);
    this.output.textContent = text;
  }
}
