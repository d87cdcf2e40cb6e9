// The drawn shell, and the cells that it holds: the rule of reports/organism/shell_wall.h.
import type { Frame, Run } from "./data";

/** The wall is this many times as far from the middle as the shell, held cells at most heldReach times. */
export const shellThickness = 1.02;
const heldReach = 1.01,
  freeReach = 1.2; // a cell with a vertex beyond stands out of the shell

/**
 * Returns the positions at which a frame's cells are drawn. Only an ellipsoid lets vertices stand out: it holds the
 * surface below them.
 */
export function insideShell(shell: Run["shell"], frame: Frame): Float32Array {
  if (!shell?.axes) return frame.positions;
  const [a, b, c] = shell.axes,
    p = frame.positions.slice(),
    reach = (v: number) => Math.hypot(p[3 * v] / a, p[3 * v + 1] / b, p[3 * v + 2] / c);
  for (let i = 0; i < frame.count; ++i) {
    const first = frame.firstVertex[i],
      last = frame.firstVertex[i + 1],
      middle = [0, 0, 0];
    let most = 0;
    for (let v = first; v < last; ++v) {
      most = Math.max(most, reach(v));
      for (let axis = 0; axis < 3; ++axis) middle[axis] += p[3 * v + axis] / (last - first) / shell.axes[axis];
    }
    if (Math.hypot(...middle) > 1 || most > freeReach || most <= heldReach) continue;
    for (let v = first; v < last; ++v) {
      const share = Math.min(1, heldReach / reach(v));
      for (let k = 3 * v; k < 3 * v + 3; ++k) p[k] *= share;
    }
  }
  return p;
}
