// Runs the simulator beside the page: makes the world of a scene, steps, and reports. Ending the worker stops the run.
import { give, make, said as saidBy, verticesOf, type Simulator } from "./module";
import type { Order, News } from "./talk";

const port = self as unknown as {
  onmessage: (event: MessageEvent<Order>) => void;
  postMessage(news: News, pass?: Transferable[]): void;
};

async function work({ module: bytes, scene, every, frames }: Order): Promise<void> {
  const module = await make<Simulator>(bytes),
    said = () => saidBy(module);
  const demand = (outcome: number) => {
    if (outcome !== 0) throw new Error(said());
  };
  give(module, scene);
  demand(module.open());
  let told = 0,
    link = 0,
    frame = 0;
  const look = () => {
    const step = module.stepNumber();
    if (frames[frame] === step) {
      ++frame;
      const vertices = verticesOf(module),
        cells = new Uint32Array(module.memory.buffer, module.lineageNumbers(), module.cellCount()).slice();
      port.postMessage({ kind: "frame", step, time: module.timeNow(), cells, vertices }, [
        cells.buffer,
        vertices.buffer,
      ]);
    }
    if (every && (step === link || module.isFinished())) {
      link += every;
      demand(module.nextHash());
      port.postMessage({ kind: "link", step, hash: said() });
    }
    const now = performance.now();
    if (now - told < 100 && !module.isFinished()) return;
    told = now;
    port.postMessage({ kind: "step", step, time: module.timeNow(), cells: module.cellCount() });
  };
  const began = performance.now();
  look();
  for (let steps = 1; !module.isFinished();) {
    const step = module.stepNumber(),
      next = Math.min(every ? link : Infinity, frames[frame] ?? Infinity);
    const from = performance.now();
    demand(module.run(Math.max(1, Math.min(steps, next - step))));
    if (performance.now() - from < 40) steps *= 2;
    else steps = Math.max(1, steps >> 1);
    look();
  }
  demand(module.hash());
  port.postMessage({ kind: "end", hash: said(), seconds: (performance.now() - began) / 1000 });
}

port.onmessage = (event) => {
  work(event.data).catch((error) => port.postMessage({ kind: "failed", why: String(error?.message ?? error) }));
};
