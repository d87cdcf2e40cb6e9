// The simulator at work, beside the page: makes the world of a scene, steps, and tells of it. Whoever stops it ends the worker.
import type { Order, News } from "./talk";

interface Module {
  memory: WebAssembly.Memory;
  _initialize(): void;
  place(bytes: number): number;
  text(): number;
  textSize(): number;
  open(): number;
  run(steps: number): number;
  isFinished(): number;
  stepNumber(): number;
  timeNow(): number;
  cellCount(): number;
  hash(): number;
  nextHash(): number;
  lineageNumbers(): number;
  vertices(): number;
  vertexNumbers(): number;
}

const port = self as unknown as { onmessage: (event: MessageEvent<Order>) => void; postMessage(news: News, pass?: Transferable[]): void };

/** What the module asks of a system: it has no files, no clock and no chance. */
function surroundings(memory: () => WebAssembly.Memory): WebAssembly.Imports {
  const refused = () => 8; // a bad descriptor
  return {
    env: { emscripten_notify_memory_growth() {} },
    wasi_snapshot_preview1: {
      proc_exit(code: number) { throw new Error(`the simulator ended with ${code}`); },
      fd_write(_file: number, _texts: number, _count: number, written: number) { new DataView(memory().buffer).setUint32(written, 0, true); return 0; },
      fd_close: refused,
      fd_seek: refused,
    },
  };
}

async function make(bytes: Uint8Array): Promise<Module> {
  let module: Module;
  const unpacked = new Response(new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip")));
  const made = await WebAssembly.instantiate(await unpacked.arrayBuffer(), surroundings(() => module.memory));
  module = made.instance.exports as unknown as Module;
  module._initialize();
  return module;
}

async function work({ module: bytes, scene, every, frames }: Order): Promise<void> {
  const module = await make(bytes);
  const said = () => new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), module.textSize()));
  const demand = (outcome: number) => { if (outcome !== 0) throw new Error(said()); };
  const text = new TextEncoder().encode(scene);
  new Uint8Array(module.memory.buffer, module.place(text.length), text.length).set(text);
  demand(module.open());
  let told = 0, link = 0, frame = 0;
  const look = () => {
    const step = module.stepNumber();
    if (frames[frame] === step) {
      ++frame;
      const at = module.vertices(), cells = new Uint32Array(module.memory.buffer, module.lineageNumbers(), module.cellCount()).slice();
      const vertices = new Float32Array(module.memory.buffer, at, module.vertexNumbers()).slice();
      port.postMessage({ kind: "frame", step, time: module.timeNow(), cells, vertices }, [cells.buffer, vertices.buffer]);
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
  for (let steps = 1; !module.isFinished(); ) {
    const step = module.stepNumber(), next = Math.min(every ? link : Infinity, frames[frame] ?? Infinity);
    const from = performance.now();
    demand(module.run(Math.max(1, Math.min(steps, next - step))));
    if (performance.now() - from < 40) steps *= 2; else steps = Math.max(1, steps >> 1);
    look();
  }
  demand(module.hash());
  port.postMessage({ kind: "end", hash: said(), seconds: (performance.now() - began) / 1000 });
}

port.onmessage = (event) => {
  work(event.data).catch((error) => port.postMessage({ kind: "failed", why: String(error?.message ?? error) }));
};
