// The simulator as a WebAssembly module (core/wasm/module.cpp): creates it, and passes texts in and out.

export interface Simulator {
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

/** Returns the system functions that the module imports: no files, no clock and no random numbers. */
function surroundings(memory: () => WebAssembly.Memory): WebAssembly.Imports {
  const refused = () => 8; // a bad descriptor
  const none = (count: number, size: number) => {
    // There are no environment variables.
    for (const at of [count, size]) new DataView(memory().buffer).setUint32(at, 0, true);
    return 0;
  };
  const wasi: Record<string, Function> = {
    proc_exit(code: number) {
      throw new Error(`the simulator ended with ${code}`);
    },
    fd_write(_file: number, _texts: number, _count: number, written: number) {
      new DataView(memory().buffer).setUint32(written, 0, true);
      return 0;
    },
    environ_sizes_get: none,
    environ_get: () => 0,
  };
  const noFile = () => -44; // ENOENT
  const or = <T extends object>(known: T, other: Function) =>
    new Proxy(known, { get: (of, name) => (of as any)[name] ?? other });
  return {
    env: or({ emscripten_notify_memory_growth() {} }, noFile),
    wasi_snapshot_preview1: or(wasi, refused),
  } as unknown as WebAssembly.Imports;
}

/** Creates the module. `bytes`: gzipped. */
export async function make<Module extends Simulator>(bytes: Uint8Array): Promise<Module> {
  let module: Module;
  const unpacked = new Response(new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip")));
  const made = await WebAssembly.instantiate(
    await unpacked.arrayBuffer(),
    surroundings(() => module.memory),
  );
  module = made.instance.exports as unknown as Module;
  module._initialize();
  return module;
}

export function give(module: Simulator, text: string): void {
  const bytes = new TextEncoder().encode(text);
  new Uint8Array(module.memory.buffer, module.place(bytes.length), bytes.length).set(bytes);
}

export function said(module: Simulator): string {
  return new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), module.textSize()));
}

export function verticesOf(module: Simulator): Float32Array {
  const at = module.vertices();
  return new Float32Array(module.memory.buffer, at, module.vertexNumbers()).slice();
}
