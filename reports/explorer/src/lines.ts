// Lines for edges, shells and normals, with two points for each.
import type { Run } from "./data";

/** Returns the vertices at both ends of each edge. */
export function edgesOf(faces: Uint32Array): Uint32Array {
  const pairs: number[] = [];
  for (let k = 0; k < faces.length; k += 3)
    for (const [a, b] of [
      [faces[k], faces[k + 1]],
      [faces[k + 1], faces[k + 2]],
      [faces[k + 2], faces[k]],
    ])
      if (a < b) pairs.push(a, b);
  return Uint32Array.from(pairs);
}

/** Returns the ellipses in which a shell meets the planes of its axes. */
function ellipses([a, b, c]: number[]): number[] {
  const points: number[] = [],
    n = 96;
  const at = (k: number, axis: number): number[] => {
    const x = Math.cos((2 * Math.PI * k) / n),
      y = Math.sin((2 * Math.PI * k) / n);
    return axis === 0 ? [0, b * x, c * y] : axis === 1 ? [a * x, 0, c * y] : [a * x, b * y, 0];
  };
  for (let axis = 0; axis < 3; ++axis) for (let k = 0; k < n; ++k) points.push(...at(k, axis), ...at(k + 1, axis));
  return points;
}

export function shellLines(shell: Run["shell"]): number[] {
  if (shell?.axes) return ellipses(shell.axes);
  const points: number[] = [];
  if (shell?.vertices && shell.faces)
    for (const v of edgesOf(Uint32Array.from(shell.faces))) points.push(...shell.vertices.slice(3 * v, 3 * v + 3));
  return points;
}

export function normalLines(positions: Float32Array, normals: ArrayLike<number>, length: number): Float32Array {
  const points = new Float32Array(2 * positions.length);
  for (let k = 0; k < positions.length; k += 3)
    for (let axis = 0; axis < 3; ++axis) {
      points[2 * k + axis] = positions[k + axis];
      points[2 * k + 3 + axis] = positions[k + axis] + length * normals[k + axis];
    }
  return points;
}
