// Reads scenarios for the playground, or runs one. One worker reads while the page is open; each run has its own.
import { give, make, said, verticesOf, type Simulator } from "../rerun/module";
import type { News, Order, Snapshot } from "./talk";

interface Playground extends Simulator {
  readScenario(): number;
  beginScenario(): number;
  snapshot(): number;
  facesOf(cell: number): number;
  measureNames(): number;
}

const port = self as unknown as {
  onmessage: (event: MessageEvent<Order>) => void;
  postMessage(news: News, pass?: Transferable[]): void;
};
let made: Promise<Playground>;

function run(module: Playground): void {
  const demand = (outcome: number) => {
    if (outcome !== 0) throw new Error(said(module));
    return said(module);
  };
  demand(module.beginScenario());
  port.postMessage({ kind: "begun", measures: JSON.parse(demand(module.measureNames())) });
  const known = new Set<number>(),
    began = performance.now();
  const tell = () => {
    const snapshot: Snapshot = JSON.parse(demand(module.snapshot()));
    snapshot.vertices = verticesOf(module);
    snapshot.meshes = [];
    snapshot.cells?.forEach(([, , , count], i) => {
      if (count === 0 || known.has(count)) return;
      known.add(count);
      snapshot.meshes.push([count, JSON.parse(demand(module.facesOf(i)))]);
    });
    port.postMessage({ kind: "snapshot", snapshot }, [snapshot.vertices.buffer]);
  };
  tell();
  for (let steps = 1, told = performance.now(); !module.isFinished();) {
    const from = performance.now();
    demand(module.run(steps));
    const now = performance.now();
    if (now - from < 25) steps *= 2;
    else steps = Math.max(1, steps >> 1);
    if (now - told < 60) continue;
    told = now;
    tell();
  }
  tell();
  const steps = module.stepNumber();
  demand(module.hash());
  port.postMessage({ kind: "end", hash: said(module), steps, seconds: (performance.now() - began) / 1000 });
}

port.onmessage = async ({ data: { module: bytes, number, written, runs } }) => {
  try {
    if (bytes) made = make<Playground>(bytes);
    const module = await made;
    give(module, JSON.stringify(written));
    const outcome = module.readScenario(),
      text = said(module);
    if (!runs)
      port.postMessage({
        kind: "read",
        number,
        read: outcome === 0 ? JSON.parse(text) : null,
        mistakes: outcome === 0 ? [] : text.split("\n"),
      });
    else if (outcome !== 0) throw new Error(text);
    else run(module);
  } catch (error) {
    port.postMessage({ kind: "failed", why: String((error as Error)?.message ?? error) });
  }
};
