// Selects and sorts the faces to draw for a place of the eye. Faces that look away or are hidden are left out, because
// without graphics hardware every vertex costs time. Solid cells go from near to far, so that hidden pixels cost no
// light. Translucent faces go from far to near, so that they blend correctly. Faces that cut through each other have no
// such order, but faces of cells hardly do.
import { Occlusion, type Cells, type Sight } from "./occlusion";

/** A stable sort of the numbers 0 to keys.length - 1 by key, with keys rounded to 1 part in 65536 of their range. */
export class Sorter {
  private places = new Uint32Array(65537);
  private coarse = new Uint16Array(0);

  /** Writes the sorted numbers into `order`, of length `count`. O(count + 65536) */
  sort(keys: Float32Array, count: number, order: Uint32Array): void {
    let low = Infinity,
      high = -Infinity;
    for (let i = 0; i < count; ++i) {
      low = Math.min(low, keys[i]);
      high = Math.max(high, keys[i]);
    }
    const scale = high > low ? 65535 / (high - low) : 0,
      { places } = this;
    if (this.coarse.length < count) this.coarse = new Uint16Array(count);
    const { coarse } = this;
    places.fill(0);
    for (let i = 0; i < count; ++i) {
      coarse[i] = (keys[i] - low) * scale;
      ++places[coarse[i] + 1];
    }
    for (let k = 0; k < 65536; ++k) places[k + 1] += places[k];
    for (let i = 0; i < count; ++i) order[places[coarse[i]]++] = i;
  }
}

/** Numbers of vertices in the list; vertices of solid cells come first. */
export interface DrawCounts {
  solid: number;
  all: number;
}

export class DrawList {
  private readonly plane: Float32Array; // four per face: normal (not of unit length), and its product with a corner
  private readonly middle: Float32Array; // three times the middle of each face
  private readonly cellMiddle: Float32Array;
  private readonly keys: Float32Array;
  private readonly facing: Uint8Array;
  private readonly chosen: Uint32Array;
  private readonly order: Uint32Array;
  private readonly sorter = new Sorter();
  private readonly occlusion: Occlusion;

  constructor(private readonly cells: Cells) {
    const { corners, firstFace, positions: p } = cells,
      faces = corners.length / 3,
      count = firstFace.length - 1;
    this.plane = new Float32Array(4 * faces);
    this.middle = new Float32Array(3 * faces);
    this.cellMiddle = new Float32Array(3 * count);
    this.keys = new Float32Array(Math.max(faces, count));
    this.facing = new Uint8Array(faces);
    this.chosen = new Uint32Array(faces);
    this.order = new Uint32Array(Math.max(faces, count));
    for (let f = 0; f < faces; ++f) {
      const a = 3 * corners[3 * f],
        b = 3 * corners[3 * f + 1],
        c = 3 * corners[3 * f + 2];
      const ux = p[b] - p[a],
        uy = p[b + 1] - p[a + 1],
        uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a],
        vy = p[c + 1] - p[a + 1],
        vz = p[c + 2] - p[a + 2];
      const nx = uy * vz - uz * vy,
        ny = uz * vx - ux * vz,
        nz = ux * vy - uy * vx;
      this.plane[4 * f] = nx;
      this.plane[4 * f + 1] = ny;
      this.plane[4 * f + 2] = nz;
      this.plane[4 * f + 3] = nx * p[a] + ny * p[a + 1] + nz * p[a + 2];
      for (let k = 0; k < 3; ++k) this.middle[3 * f + k] = p[a + k] + p[b + k] + p[c + k];
    }
    for (let i = 0; i < count; ++i) {
      const n = firstFace[i + 1] - firstFace[i] || 1;
      for (let f = firstFace[i]; f < firstFace[i + 1]; ++f)
        for (let k = 0; k < 3; ++k) this.cellMiddle[3 * i + k] += this.middle[3 * f + k] / (3 * n);
    }
    this.occlusion = new Occlusion(cells);
  }

  /** Fills `list`, which has room for all corners. `all`: includes faces that look away or are hidden. */
  fill(sight: Sight, seeThrough: Uint8Array, all: boolean, list: Uint16Array | Uint32Array): DrawCounts {
    const { plane, cellMiddle, keys, order, facing, occlusion } = this,
      { corners, firstFace } = this.cells,
      { eye, forward } = sight,
      cells = firstFace.length - 1;
    for (let i = 0; i < cells; ++i)
      keys[i] = cellMiddle[3 * i] * forward.x + cellMiddle[3 * i + 1] * forward.y + cellMiddle[3 * i + 2] * forward.z;
    this.sorter.sort(keys, cells, order);
    for (let f = 0, k = 0; f < facing.length; ++f, k += 4)
      facing[f] = plane[k] * eye.x + plane[k + 1] * eye.y + plane[k + 2] * eye.z > plane[k + 3] ? 1 : 0;
    if (!all) occlusion.look(sight, seeThrough, facing);
    const isDrawn = (f: number) =>
      all || (facing[f] === 1 && !occlusion.hides(corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]));
    let at = 0;
    for (let k = 0; k < cells; ++k) {
      const i = order[k];
      if (seeThrough[i]) continue;
      for (let f = firstFace[i]; f < firstFace[i + 1]; ++f)
        if (isDrawn(f)) for (let c = 3 * f; c < 3 * f + 3; ++c) list[at++] = corners[c];
    }
    const solid = at,
      { middle, chosen } = this;
    let n = 0;
    for (let i = 0; i < cells; ++i) {
      if (!seeThrough[i]) continue;
      for (let f = firstFace[i]; f < firstFace[i + 1]; ++f)
        if (isDrawn(f)) {
          keys[n] = -(middle[3 * f] * forward.x + middle[3 * f + 1] * forward.y + middle[3 * f + 2] * forward.z);
          chosen[n++] = f;
        }
    }
    if (n > 0) this.sorter.sort(keys, n, order);
    for (let k = 0; k < n; ++k) for (let c = 3 * chosen[order[k]], end = c + 3; c < end; ++c) list[at++] = corners[c];
    return { solid, all: at };
  }
}
