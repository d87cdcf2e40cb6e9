// The playground: a scenario to edit, its mistakes while one types, and its organism while it grows.
import type { Data } from "../data";
import { whyNot } from "../rerun/talk";
import { element } from "../tools";
import { Chart } from "./chart";
import { Editor, helpAt } from "./editor";
import { LiveExplorer, LiveRun } from "./live";
import { style } from "./style";
import type { Measures, News, Order, Read, Written } from "./talk";

declare const PLAYGROUND_WORKER: string; // the program of worker.ts (build.mjs)

/** The page's data, as runner/publish/report/playground.cpp writes them. */
interface Told {
  scenarios: { name: string; summary: string; text: string; files: [string, string, string][] }[];
  schema: unknown;
  scale: string[];
  series: string[];
  clones: Record<string, string>;
  program: string;
}

const secondsText = (s: number) =>
  s < 1
    ? "about a second"
    : s < 90
      ? `${Math.round(s)} s or more`
      : s < 5400
        ? `${Math.round(s / 60)} minutes or more`
        : `${Math.round(s / 3600)} hours or more`;
const counted = (n: number, what: string) => `${n} ${what}${n === 1 ? "" : "s"}`;

class Playground {
  private readonly editor = new Editor("editor", "Scenario (YAML)");
  private readonly dna = new Editor("dna", "DNA file");
  private readonly choice = element("select");
  private readonly runButton = element("button", "", "Run");
  private readonly stopButton = element("button", "", "Stop");
  private readonly messages = element("ol");
  private readonly help = element("p", "note");
  private readonly cost = element("p", "note");
  private readonly status = element("p");
  private readonly hash = element("code", "", "–");
  private readonly command = element("code");
  private readonly saves = element("span");
  private readonly chart = new Chart();
  private readonly module: Uint8Array;
  private reader: Worker | null = null;
  private runner: Worker | null = null;
  private number = 0;
  private files: [string, string, string][] = [];
  private read: Read | null = null;
  private nanoseconds = 400; // per vertex and time step, in the last run
  private timer = 0;
  private explorer: LiveExplorer | null = null;

  constructor(
    private readonly told: Told,
    play: HTMLElement,
    private readonly grow: HTMLElement,
  ) {
    this.module = Uint8Array.from(atob(document.getElementById("playground-module")!.textContent!), (c) =>
      c.charCodeAt(0),
    );
    document.head.append(element("style", "", style));
    for (const { name, summary } of told.scenarios) {
      const option = element("option", "", summary ? `${name}: ${summary}` : name);
      option.value = name;
      this.choice.append(option);
    }
    const label = element("label", "", "Begin with ");
    label.append(this.choice);
    this.choice.id = "scenario";
    this.runButton.id = "run";
    this.stopButton.id = "stop";
    this.messages.id = "messages";
    this.messages.setAttribute("aria-label", "Messages");
    this.hash.id = "hash";
    this.status.setAttribute("role", "status");
    this.help.id = "help";
    this.cost.id = "cost";
    this.help.setAttribute("aria-live", "polite");
    this.runButton.type = this.stopButton.type = "button";
    this.stopButton.disabled = this.runButton.disabled = true;
    const tools = element("div", "tools"),
      editors = element("div", "editors"),
      line = element("p", "note", "State hash ");
    tools.append(label, this.runButton, this.stopButton, this.saves);
    editors.append(this.editor.box, this.dna.box);
    line.append(this.hash, element("br"), "The same bits outside: ", this.command);
    play.replaceChildren(tools, editors, this.help, this.messages, this.cost, this.status, line, this.chart.box);
    this.grow.replaceChildren(element("p", "note", "The organism is shown here while it grows."));
    this.choice.addEventListener("change", () => this.begin(this.choice.value));
    this.runButton.addEventListener("click", () => this.run());
    this.stopButton.addEventListener("click", () => this.end("Stopped.", "warn", "!"));
    for (const editor of [this.editor, this.dna]) editor.onChange = () => this.edited();
    this.editor.onCaret = () => {
      this.help.textContent =
        helpAt(told.schema, this.editor.path()) || "The schema's help stands here, for the key at which the caret is.";
    };
    this.editor.onCaret();
    const why = whyNot();
    if (why) {
      this.say(`${why[0].toUpperCase()}${why.slice(1)}: nothing can be checked or run here.`, "bad", "✗");
      return;
    }
    this.begin(told.scenarios.find(({ name }) => name.endsWith("unique-four"))?.name ?? told.scenarios[0].name);
  }

  private say(text: string, mark = "", sign = ""): void {
    this.status.replaceChildren(...(mark ? [element("span", `mark ${mark}`, sign), " "] : []), text);
  }

  private begin(name: string): void {
    const scenario = this.told.scenarios.find((one) => one.name === name)!;
    this.choice.value = name;
    this.runButton.disabled = true;
    this.editor.value = scenario.text;
    this.files = scenario.files;
    const dna = this.files.find(([role]) => role === "dna");
    this.dna.box.hidden = !dna;
    this.dna.value = dna?.[2] ?? "";
    this.check();
  }

  private written(): Written {
    const name = `${this.choice.value.split("/").pop()}.yaml`;
    return {
      name,
      text: this.editor.value,
      files: this.files.map(([role, path, content]) => [role, path, role === "dna" ? this.dna.value : content]),
    };
  }

  private edited(): void {
    this.runButton.disabled = true;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.check(), 200);
  }

  private worker(hear: (news: News) => void): Worker {
    const worker = new Worker(URL.createObjectURL(new Blob([PLAYGROUND_WORKER], { type: "text/javascript" })));
    worker.onmessage = (event: MessageEvent<News>) => hear(event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      hear({ kind: "failed", why: event.message || "the worker could not be started" });
    };
    return worker;
  }

  private check(): void {
    const isFirst = !this.reader,
      order: Order = { number: ++this.number, written: this.written(), runs: false };
    this.reader ??= this.worker((news) => {
      if (news.kind === "failed") this.say(news.why, "bad", "✗");
      else if (news.kind === "read" && news.number === this.number) this.show(news.read, news.mistakes);
    });
    this.reader.postMessage(isFirst ? { ...order, module: this.module } : order);
  }

  private show(read: Read | null, mistakes: string[]): void {
    this.read = read;
    const { name } = this.written(),
      lines = new Set<number>();
    this.messages.dataset.number = String(this.number);
    this.messages.replaceChildren(
      ...[...mistakes, ...(read?.warnings ?? [])]
        .filter((text) => text)
        .map((text, i) => {
          const item = element("li"),
            place = text.startsWith(`${name}:`) ? /^(\d+):(\d+):/.exec(text.slice(name.length + 1)) : null;
          item.append(
            element("span", `mark ${i < mistakes.length ? "bad" : "warn"}`, i < mistakes.length ? "✗" : "!"),
            " ",
          );
          if (!place) {
            item.append(text);
            return item;
          }
          const button = element("button", "", text);
          button.type = "button";
          button.addEventListener("click", () => this.editor.goTo(Number(place[1]), Number(place[2])));
          if (i < mistakes.length) lines.add(Number(place[1]));
          item.append(button);
          return item;
        }),
    );
    if (!read && mistakes.length === 0) this.messages.append(element("li", "", "It cannot be read."));
    this.editor.mark(lines);
    this.runButton.disabled = !read || this.runner !== null;
    this.command.textContent = `morula run ${name}`;
    this.saves.replaceChildren(
      "Save ",
      ...[["", name, this.editor.value], ...this.written().files].map(([, path, content]) => {
        const link = element("a", "", path);
        link.download = path.split("/").pop()!;
        link.href = `data:text/plain;charset=utf-8,${encodeURIComponent(content)}`;
        return link;
      }),
    );
    this.foresee();
  }

  /** Shows the predicted cost of a run. */
  private foresee(): void {
    if (!this.read) {
      this.cost.textContent = `${counted(this.messages.children.length, "mistake")}.`;
      return;
    }
    const { cells, isMore, vertexSteps, steps, memory } = this.read.cost,
      seconds = vertexSteps * this.nanoseconds * 1e-9;
    const size =
      `${isMore ? "More than " : ""}${counted(cells, "cell")}, ${Math.round(steps)} steps or more: ` +
      `${secondsText(seconds)} and ${Math.ceil(memory / 1e6)} MB here.`;
    const tooLarge = isMore || memory > 1.5e9 || seconds > 1800;
    this.cost.replaceChildren(
      ...(tooLarge ? [element("span", "mark warn", "! Too large for a page."), " "] : []),
      `Fine. ${size}${tooLarge ? " The program itself is faster, and has more memory." : ""}`,
    );
  }

  private run(): void {
    const read = this.read!,
      began = performance.now();
    let run: LiveRun | null = null,
      measures: Measures | null = null;
    this.hash.textContent = "…";
    this.runButton.disabled = true;
    this.stopButton.disabled = false;
    this.say("Starting");
    this.runner = this.worker((news) => {
      if (news.kind === "failed") this.end(`The run ended: ${news.why}`, "bad", "✗");
      else if (news.kind === "begun") {
        measures = news.measures;
        run = new LiveRun(read, measures);
        this.chart.begin(measures, read.end);
      } else if (news.kind === "snapshot" && run) {
        run.add(news.snapshot);
        this.chart.add(news.snapshot.time, news.snapshot.world ?? []);
        if (run.times.length === 1) this.lookAt(run, measures!);
        else this.explorer!.grow();
        this.say(
          `Time ${Number(news.snapshot.time.toPrecision(4))}` +
            `${read.end === null ? "" : ` of ${Number(read.end.toPrecision(4))}`}, ` +
            `step ${news.snapshot.step}, ${counted(news.snapshot.cells?.length ?? 0, "cell")}`,
        );
      } else if (news.kind === "end") {
        if (read.cost.vertexSteps > 1e6) this.nanoseconds = (news.seconds * 1e9) / read.cost.vertexSteps;
        this.end(
          `Done after ${news.steps} steps, in ${((performance.now() - began) / 1000).toFixed(2)} s.`,
          "good",
          "✓",
          news.hash,
        );
      }
    });
    this.runner.postMessage({ module: this.module, number: 0, written: this.written(), runs: true } satisfies Order);
  }

  private end(text: string, mark: string, sign: string, hash = "–"): void {
    this.runner?.terminate();
    this.runner = null;
    this.hash.textContent = hash;
    this.stopButton.disabled = true;
    this.runButton.disabled = !this.read;
    this.say(text, mark, sign);
    this.foresee();
  }

  private lookAt(run: LiveRun, measures: Measures): void {
    this.explorer?.leave();
    const root = element("div");
    this.grow.replaceChildren(root);
    const data: Data = {
      runs: [run],
      units: measures.units,
      scale: this.told.scale,
      series: this.told.series,
      clones: this.told.clones,
      forces: [],
    };
    this.explorer = new LiveExplorer(root, data, run);
  }
}

const write = document.getElementById("write"),
  grow = document.getElementById("grow");
if (write && grow) new Playground(JSON.parse(document.getElementById("data")!.textContent!), write, grow);
