// Unpacks the frames of a run, as runner/publish/report_data/packed_frames.cpp packs them.
import { unzlibSync } from "three/examples/jsm/libs/fflate.module.js";

export interface FrameHead {
  time: number;
  step: number;
  cells: number;
  contacts: number;
  connections: number;
  offset: number; // place in the unpacked bytes
  size: number;
  vertexForces: number; // their place in the frame; 0: none
}

interface Layout {
  measures: string[];
  netForces: string[];
  vertexCounts: number[];
}

/** Returns the bytes of all frames, laid out as runner/publish/report_data/frames.h says. */
export function unpacked(packed: Uint8Array, heads: FrameHead[], layout: Layout): ArrayBuffer {
  const bytes = unzlibSync(packed),
    columns = 7 + layout.measures.length,
    net = 3 * layout.netForces.length;
  const wordsOf = (h: FrameHead) => h.cells * (columns + net) + 3 * h.contacts + 2 * h.connections;
  const last = heads[heads.length - 1],
    whole = new Uint8Array(last.offset + last.size),
    words = new Uint32Array(whole.buffer, 0, whole.length >> 2),
    places = new Uint16Array(whole.buffer, 0, whole.length >> 1);
  const count = heads.reduce((sum, h) => sum + wordsOf(h), 0);
  let from = 0;
  for (const h of heads) {
    let to = h.offset >> 2;
    for (const [rows, across] of [
      [h.cells, columns],
      [h.contacts, 3],
      [h.connections, 2],
      [h.cells, net],
    ]) {
      for (let c = 0; c < across; ++c)
        for (let r = 0; r < rows; ++r, ++from)
          words[to + r * across + c] =
            bytes[from] |
            (bytes[from + count] << 8) |
            (bytes[from + 2 * count] << 16) |
            (bytes[from + 3 * count] << 24);
      to += rows * across;
    }
  }
  const cellsOf = (h: FrameHead) => Array.from({ length: h.cells }, (_, i) => (h.offset >> 2) + i * columns);
  const numbersOf = (at: number) => 3 * layout.vertexCounts[words[at + 1]];
  const all = heads.reduce((sum, h) => sum + cellsOf(h).reduce((more, at) => more + numbersOf(at), 0), 0);
  let before = new Map<number, [row: number, place: number]>();
  from = 4 * count;
  for (const h of heads) {
    const now = new Map<number, [row: number, place: number]>();
    let to = (h.offset >> 1) + 2 * wordsOf(h);
    for (const at of cellsOf(h)) {
      const known = before.get(words[at]),
        n = numbersOf(at),
        isKnown = known && words[known[0] + 6] === words[at + 6] && numbersOf(known[0]) === n;
      for (let k = 0; k < n; ++k, ++from) {
        const code = bytes[from] | (bytes[from + all] << 8),
          by = code & 1 ? -((code + 1) >> 1) : code >> 1;
        places[to + k] = by + (isKnown ? places[known[1] + k] : k >= 3 ? places[to + k - 3] : 0);
      }
      now.set(words[at], [at, to]);
      to += n;
    }
    before = now;
  }
  if (last.vertexForces) whole.set(bytes.subarray(4 * count + 2 * all), last.offset + last.vertexForces);
  return whole.buffer;
}
