// Finds faces that are certainly hidden behind solid cells; other faces may be hidden too. The picture is cut into
// squares. A solid cell covers a square if its outline does not touch the square and one of its faces covers the
// square's middle. There it hides everything farther than all of its faces that look at the eye.

/** The eye's place and direction; `right`, `up` and `forward` are unit vectors. */
export interface Sight {
  eye: Vec;
  forward: Vec;
  right: Vec;
  up: Vec;
  width: number; // [pixel]
  height: number;
  perTangent: number; // [pixel] of a slope of 1 against `forward`
}
export interface Vec {
  x: number;
  y: number;
  z: number;
}

const side = 4; // [pixel] side of a square

/** Returns the face across each edge of each face, from corner k to the next; the face itself if there is none. */
export function facesAcross(faces: Uint32Array): Uint32Array {
  const across = new Uint32Array(faces.length),
    open = new Map<string, number>();
  for (let k = 0; k < faces.length; ++k) {
    const a = faces[k],
      b = faces[k % 3 === 2 ? k - 2 : k + 1],
      other = open.get(`${b} ${a}`);
    across[k] = Math.floor(k / 3);
    if (other === undefined) open.set(`${a} ${b}`, k);
    else [across[k], across[other]] = [Math.floor(other / 3), Math.floor(k / 3)];
  }
  return across;
}

/** The cells of a DrawList; `across`: facesAcross of each cell's mesh. */
export interface Cells {
  corners: Uint32Array;
  firstFace: Uint32Array;
  positions: Float32Array;
  across: Uint32Array[];
}

export class Occlusion {
  private columns = 0;
  private rows = 0;
  private nearest = new Float32Array(0); // [square] depth beyond which all is hidden
  /** [square] The cell that covers the square's middle, counted from 1; negative if its outline touches the square. */
  private covered = new Int32Array(0);
  private readonly x: Float32Array; // [square] of each vertex
  private readonly y: Float32Array;
  private readonly depth: Float32Array;

  constructor(private readonly cells: Cells) {
    const vertices = cells.positions.length / 3;
    this.x = new Float32Array(vertices);
    this.y = new Float32Array(vertices);
    this.depth = new Float32Array(vertices);
  }

  /** Prepares `hides` for a sight. `facing`: 1 for each face that looks at the eye. */
  look(sight: Sight, seeThrough: Uint8Array, facing: Uint8Array): void {
    this.columns = Math.ceil(sight.width / side);
    this.rows = Math.ceil(sight.height / side);
    if (this.nearest.length !== this.columns * this.rows) {
      this.nearest = new Float32Array(this.columns * this.rows);
      this.covered = new Int32Array(this.columns * this.rows);
    }
    this.nearest.fill(Infinity);
    this.covered.fill(0);
    this.project(sight);
    for (let i = 0; i < seeThrough.length; ++i) if (!seeThrough[i]) this.cover(i, facing);
  }

  private project({ eye, forward: f, right: r, up: u, width, height, perTangent }: Sight): void {
    const scale = perTangent / side,
      middleX = width / side / 2,
      middleY = height / side / 2,
      { x, y, depth } = this,
      p = this.cells.positions;
    for (let v = 0, k = 0; v < x.length; ++v, k += 3) {
      const dx = p[k] - eye.x,
        dy = p[k + 1] - eye.y,
        dz = p[k + 2] - eye.z,
        d = dx * f.x + dy * f.y + dz * f.z;
      depth[v] = d;
      x[v] = middleX + (scale * (dx * r.x + dy * r.y + dz * r.z)) / d;
      y[v] = middleY + (scale * (dx * u.x + dy * u.y + dz * u.z)) / d;
    }
  }

  private cover(cell: number, facing: Uint8Array): void {
    const { corners, firstFace, across } = this.cells,
      { x, y, depth, covered, columns, rows, nearest } = this;
    const first = firstFace[cell],
      last = firstFace[cell + 1],
      others = across[cell];
    let farthest = 0,
      left = columns,
      right = -1,
      low = rows,
      high = -1;
    for (let f = first; f < last; ++f) {
      if (!facing[f]) continue;
      for (let k = 3 * f; k < 3 * f + 3; ++k) {
        const a = corners[k],
          b = corners[k === 3 * f + 2 ? k - 2 : k + 1],
          other = others[k - 3 * first];
        if (!(depth[a] > 0)) return; // the cell is around the eye
        farthest = Math.max(farthest, depth[a]);
        if (facing[first + other] && first + other !== f) continue;
        // The edge is part of the outline: squares that it may touch are not covered.
        const x0 = Math.max(0, Math.floor(Math.min(x[a], x[b]))),
          x1 = Math.min(columns - 1, Math.floor(Math.max(x[a], x[b])));
        const y0 = Math.max(0, Math.floor(Math.min(y[a], y[b]))),
          y1 = Math.min(rows - 1, Math.floor(Math.max(y[a], y[b])));
        for (let row = y0; row <= y1; ++row)
          for (let at = row * columns + x0; at <= row * columns + x1; ++at) covered[at] = -cell - 1;
        left = Math.min(left, x0);
        right = Math.max(right, x1);
        low = Math.min(low, y0);
        high = Math.max(high, y1);
      }
    }
    for (let f = first; f < last; ++f)
      if (facing[f]) this.coverMiddles(corners[3 * f], corners[3 * f + 1], corners[3 * f + 2], cell + 1);
    for (let row = low; row <= high; ++row)
      for (let at = row * columns + left; at <= row * columns + right; ++at)
        if (covered[at] === cell + 1 && farthest < nearest[at]) nearest[at] = farthest;
  }

  /** Covers the squares whose middle lies in a triangle, except those of the outline. */
  private coverMiddles(a: number, b: number, c: number, by: number): void {
    const { x, y, columns, rows, covered } = this,
      ax = x[a],
      ay = y[a],
      bx = x[b],
      by_ = y[b],
      cx = x[c],
      cy = y[c];
    const x0 = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5)),
      x1 = Math.min(columns - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
    const y0 = Math.max(0, Math.ceil(Math.min(ay, by_, cy) - 0.5)),
      y1 = Math.min(rows - 1, Math.floor(Math.max(ay, by_, cy) - 0.5));
    for (let row = y0; row <= y1; ++row)
      for (let column = x0; column <= x1; ++column) {
        const px = column + 0.5,
          py = row + 0.5,
          at = row * columns + column;
        if (covered[at] === -by) continue;
        if (
          (bx - ax) * (py - ay) >= (by_ - ay) * (px - ax) &&
          (cx - bx) * (py - by_) >= (cy - by_) * (px - bx) &&
          (ax - cx) * (py - cy) >= (ay - cy) * (px - cx)
        )
          covered[at] = by;
      }
  }

  /** Returns true if the face with these vertices is certainly hidden, or outside of the picture. */
  hides(a: number, b: number, c: number): boolean {
    const { x, y, depth, nearest, columns } = this,
      from = Math.min(depth[a], depth[b], depth[c]);
    if (!(from > 0)) return false;
    const left = Math.max(0, Math.floor(Math.min(x[a], x[b], x[c]))),
      right = Math.min(columns - 1, Math.floor(Math.max(x[a], x[b], x[c])));
    const low = Math.max(0, Math.floor(Math.min(y[a], y[b], y[c]))),
      high = Math.min(this.rows - 1, Math.floor(Math.max(y[a], y[b], y[c])));
    for (let row = low; row <= high; ++row)
      for (let at = row * columns + left, end = row * columns + right; at <= end; ++at)
        if (nearest[at] >= from) return false;
    return true;
  }
}
