// The messages between a page and the worker in which the simulator runs.

export interface Order {
  module: Uint8Array; // the simulator, gzipped
  scene: string;
  every: number; // steps between step hashes; 0: none
  frames: number[]; // steps of requested shapes, rising
}

export type News =
  | { kind: "step"; step: number; time: number; cells: number }
  | { kind: "frame"; step: number; time: number; cells: Uint32Array; vertices: Float32Array }
  | { kind: "link"; step: number; hash: string }
  | { kind: "end"; hash: string; seconds: number }
  | { kind: "failed"; why: string };

declare const WORKER: string; // the program of worker.ts (build.mjs)

/** Starts the worker; `end` stops it. Throws if the browser has no workers or the page's policy forbids them. */
export function start(order: Order, hear: (news: News) => void): { end(): void } {
  const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" })),
    worker = new Worker(address);
  const end = () => {
    worker.terminate();
    URL.revokeObjectURL(address);
  };
  worker.onmessage = (event: MessageEvent<News>) => {
    if (event.data.kind === "end" || event.data.kind === "failed") end();
    hear(event.data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    end();
    hear({ kind: "failed", why: event.message || "the worker could not be started" });
  };
  worker.postMessage(order);
  return { end };
}

/** Returns the reason why this browser cannot run the simulator; "" if it can. */
export function whyNot(): string {
  if (typeof WebAssembly !== "object") return "this browser has no WebAssembly, or it is switched off";
  if (typeof Worker !== "function") return "this browser has no workers";
  if (typeof DecompressionStream !== "function")
    return "this browser is too old: it cannot unpack the simulator (DecompressionStream)";
  // The module has one function with the body `v128.const 0; drop`.
  const simd = new Uint8Array([
    0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 23, 1, 21, 0, 253, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 26, 11,
  ]);
  return WebAssembly.validate(simd) ? "" : "this browser's WebAssembly is too old: it has no SIMD";
}
