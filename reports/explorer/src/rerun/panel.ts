// Repeats the page's run in this browser: a button, the progress, and a comparison with the stored bits. The explorer
// shows the organism of the repeated run.
import { bytesOf, Run } from "../data";
import { element } from "../tools";
import { start, whyNot, type News } from "./talk";

/** The stored run, as runner/publish/report/rerun_block.cpp writes it. */
interface Stored {
  scene: string; // the scene's hash
  state: string; // the hash of the last state
  steps: number;
  every: number; // steps between hashes; 0: none are stored
  links: [number, string][]; // step and hash, rising
}

const textOf = (id: string) => new TextDecoder().decode(bytesOf(id));
const counted = (n: number, what: string) => `${n} ${what}${n === 1 ? "" : "s"}`;

export class Panel {
  private readonly button = element("button", "", "Run it again in this browser");
  private readonly stop = element("button", "", "Stop");
  private readonly progress = element("progress");
  private readonly status = element("p");
  private readonly hash = element("code");
  private readonly stored: Stored;
  private readonly links: Map<number, string>;
  private readonly frames = new Map<number, Float32Array>(); // shapes of the repeated run by frame number
  private readonly numbers = new Map<number, number>(); // frame numbers by step
  private agreed = 0; // number of equal links
  private lastSame = -1;
  private firstOther = -1;
  private running: { end(): void } | null = null;

  constructor(
    place: HTMLElement,
    private readonly run: Run,
  ) {
    this.stored = JSON.parse(textOf("rerun-stored"));
    this.links = new Map(this.stored.links);
    this.button.id = "rerun";
    this.stop.id = "rerun-stop";
    this.hash.id = "rerun-hash";
    this.button.type = this.stop.type = "button";
    this.status.setAttribute("role", "status");
    this.progress.max = this.stored.steps || 1;
    this.progress.setAttribute("aria-label", "Steps");
    this.stop.hidden = this.progress.hidden = true;
    const tools = element("div", "tools");
    tools.append(this.button, this.stop, this.progress);
    const line = element("p", "note", "State hash stored ");
    line.append(element("code", "", this.stored.state), element("br"), "State hash here ", this.hash);
    this.hash.textContent = "–";
    place.replaceChildren(tools, this.status, line);
    this.button.addEventListener("click", () => this.begin());
    this.stop.addEventListener("click", () => this.halt());
    this.showOwnFrames();
  }

  private say(text: string, mark = "", word = ""): void {
    this.status.replaceChildren(...(mark ? [element("span", `mark ${mark}`, word), " "] : []), text);
  }

  private finish(text: string, mark: string, word: string): void {
    this.running = null;
    this.stop.hidden = this.progress.hidden = true;
    this.button.disabled = false;
    this.say(text, mark, word);
  }

  private begin(): void {
    const why = whyNot();
    if (why)
      return this.finish(
        `${why[0].toUpperCase()}${why.slice(1)}, so the run cannot be made again here; ` +
          "the command below makes it again elsewhere.",
        "bad",
        "✗ Not run",
      );
    const scene = textOf("rerun-scene");
    if (scene.slice(-33).trim() !== this.stored.scene)
      return this.finish(
        "The scene in this page is not that of the stored run: one of them was changed.",
        "bad",
        "✗ Not run",
      );
    this.agreed = 0;
    this.lastSame = this.firstOther = -1;
    this.frames.clear();
    this.numbers.clear();
    if (this.run.hasBodies) this.run.times.forEach((_, i) => this.numbers.set(this.run.frame(i).step, i));
    this.hash.textContent = "…";
    delete this.hash.dataset.same;
    this.stop.hidden = this.progress.hidden = false;
    this.button.disabled = true;
    this.progress.value = 0;
    this.say("Starting");
    try {
      const order = {
        module: bytesOf("rerun-module"),
        scene,
        every: this.stored.every,
        frames: [...this.numbers.keys()].sort((a, b) => a - b),
      };
      this.running = start(order, (news) => this.hear(news));
    } catch (error) {
      this.finish(`The worker could not be started: ${(error as Error).message}`, "bad", "✗ Not run");
    }
  }

  private halt(): void {
    this.running?.end();
    this.hash.textContent = "–";
    this.finish(`Stopped at step ${this.progress.value} of ${this.stored.steps}${this.soFar()}.`, "warn", "! Stopped");
  }

  /** Describes the comparison of step hashes so far. */
  private soFar(): string {
    if (this.firstOther >= 0) return `; other bits than stored since ${this.whereOther()}`;
    return this.agreed ? `; ${counted(this.agreed, "step hash").replace("hashs", "hashes")} so far, all as stored` : "";
  }

  private whereOther(): string {
    return this.lastSame >= 0
      ? `between step ${this.lastSame}, whose hash is as stored, and step ${this.firstOther}`
      : `step ${this.firstOther}`;
  }

  private hear(news: News): void {
    if (news.kind === "step") {
      this.progress.value = news.step;
      this.say(`Step ${news.step} of ${this.stored.steps}, ${counted(news.cells, "cell")}${this.soFar()}`);
    } else if (news.kind === "link") {
      const stored = this.links.get(news.step);
      if (stored === news.hash) {
        ++this.agreed;
        this.lastSame = this.firstOther < 0 ? news.step : this.lastSame;
      } else if (stored !== undefined && this.firstOther < 0) this.firstOther = news.step;
    } else if (news.kind === "frame") this.grow(news.step, news.time, news.cells, news.vertices);
    else if (news.kind === "failed") {
      this.hash.textContent = "–";
      this.finish(`The simulator stopped: ${news.why}.`, "bad", "✗ Not run to its end");
    } else this.judge(news.hash, news.seconds);
  }

  private judge(hash: string, seconds: number): void {
    const same = hash === this.stored.state,
      took = `${seconds.toFixed(2)} s in this browser`;
    this.hash.textContent = hash;
    this.hash.dataset.same = String(same && this.firstOther < 0);
    const share = this.agreed === this.links.size ? "all" : `${this.agreed} of`,
      hashes = this.agreed ? `, and ${share} ${this.links.size} step hashes are as stored` : "";
    if (same && this.firstOther < 0)
      this.finish(`The last state has the stored hash${hashes}. ${took}.`, "good", "✓ The same bits");
    else if (this.firstOther >= 0)
      this.finish(
        `They begin to differ from those stored ${this.lastSame >= 0 ? "" : "at "}${this.whereOther()}` +
          `${same ? ", though the last state is as stored" : ""}. ${took}.`,
        "bad",
        "✗ Other bits",
      );
    else if (this.agreed)
      this.finish(
        `The last state has another hash than stored, though all ${this.agreed} step hashes agree: ` +
          `the stored hash is not that of this run. ${took}.`,
        "bad",
        "✗ Other bits",
      );
    else
      this.finish(
        "The last state has another hash than stored; " +
          `no step hashes are stored that would tell where they begin to differ. ${took}.`,
        "bad",
        "✗ Other bits",
      );
  }

  /** Makes the explorer show the shapes of the repeated run in place of stored ones. */
  private showOwnFrames(): void {
    const { frames } = this,
      { title } = this.run,
      stored = Run.prototype.frame;
    Run.prototype.frame = function (number) {
      const frame = stored.call(this, number),
        positions = this.title === title ? frames.get(number) : undefined;
      return positions ? { ...frame, positions } : frame;
    };
  }

  private grow(step: number, time: number, cells: Uint32Array, vertices: Float32Array): void {
    const number = this.numbers.get(step),
      slider = document.querySelector<HTMLInputElement>("#time");
    if (number === undefined || !slider) return;
    const stored = this.run.frame(number);
    // The page has no data for cells that differ from the stored ones.
    if (stored.positions.length !== vertices.length || stored.cell.some((cell, i) => cell !== cells[i])) return;
    this.frames.set(number, vertices);
    slider.value = String(time);
    slider.dispatchEvent(new Event("input"));
  }
}
