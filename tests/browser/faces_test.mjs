// Which faces the explorer draws, and in which order, against brute force: faces_test.mjs FOLDER-OF-PACKAGES EXPLORER-SOURCES.
// A run has no cells in cells, so they are made here: balls within balls and beside one another, as of twenty faces each.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [packages, sources] = process.argv.slice(2).map((p) => resolve(p));
const { buildSync } = createRequire(join(packages, "package.json"))("esbuild");
const built = join(packages, "faces_test_built.mjs");
buildSync({ stdin: { contents: 'export * from "./faces"; export * from "./occlusion"; export * from "./shell";', resolveDir: sources, loader: "ts" }, outfile: built, bundle: true, format: "esm", logLevel: "warning" });
const { DrawList, Sorter, facesAcross, insideShell } = await import(pathToFileURL(built).href);

let failures = 0;
function check(what, holds, found = "") {
  if (holds) return;
  ++failures;
  console.log(`FAILED: ${what}${found === "" ? "" : `; found: ${found}`}`);
}

let state = 1;
function random() { // [0, 1), the same in every run [Park & Miller 1988]
  state = (state * 48271) % 2147483647;
  return state / 2147483647;
}
const sub = (a, b) => a.map((x, k) => x - b[k]), dot = (a, b) => a.reduce((s, x, k) => s + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

function ball(middle, radius, times) { // an octahedron, its faces cut into four so many times
  let faces = [];
  for (const x of [1, -1]) for (const y of [1, -1]) for (const z of [1, -1]) {
    const corners = [[x, 0, 0], [0, y, 0], [0, 0, z]];
    faces.push(x * y * z > 0 ? corners : [corners[0], corners[2], corners[1]]);
  }
  for (; times > 0; --times)
    faces = faces.flatMap(([a, b, c]) => {
      const half = (p, q) => unit(p.map((x, k) => x + q[k])), [d, e, f] = [half(a, b), half(b, c), half(c, a)];
      return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]];
    });
  return faces.map((face) => face.map((p) => p.map((x, k) => middle[k] + radius * x)));
}

// Balls in balls, beside one another and behind one another, far enough for some to be hidden whole.
const balls = [
  ball([0, 0, 0], 1, 3), ball([0, 0, 0], 0.7, 3), ball([0.1, 0.1, 0], 0.4, 3), ball([1.6, 0.2, 0.1], 0.5, 2), ball([-1.9, 0, 0.3], 0.8, 3), ball([-1.9, 0.1, 0.3], 0.3, 1),
  ball([0, 1.9, 0.2], 0.8, 3), ball([0.2, -2, 0.1], 0.9, 3), ball([0, 0.2, 1.9], 0.8, 3), ball([0.1, 0.1, -1.9], 0.8, 3),
];
const faces = balls.flat(), firstFace = Uint32Array.from([0, ...balls.map((_, i) => balls.slice(0, i + 1).reduce((n, b) => n + b.length, 0))]);
const positions = Float32Array.from(faces.flat(2)), corners = Uint32Array.from({ length: 3 * faces.length }, (_, i) => i);
// Corners that lie in one place are one: then a face knows those beside it.
const one = (ball) => { const known = new Map(); return Uint32Array.from(ball.flat().map((p) => { const key = p.map((x) => x.toFixed(9)).join(); if (!known.has(key)) known.set(key, known.size); return known.get(key); })); };
const draws = new DrawList({ corners, firstFace, positions, across: balls.map((b) => facesAcross(one(b))) }), list = new Uint16Array(corners.length);
const cellOf = (face) => firstFace.findLastIndex((first) => first <= face);
const looksAt = (face, eye) => { const [a, b, c] = faces[face]; return dot(cross(sub(b, a), sub(c, a)), sub(eye, a)) > 0; };
const edgeOn = (k, eye) => { const [a, b, c] = faces[k]; return Math.abs(dot(unit(cross(sub(b, a), sub(c, a))), sub(eye, a))) < 1e-5; }; // numbers of 32 bits decide otherwise
const xyz = ([x, y, z]) => ({ x, y, z });

/** Faces that look at the eye and that a ray meets, the nearest first: [distance, face]. */
function hitsOf(eye, ray, among) {
  const hits = [];
  for (const k of among) {
    const [a, b, c] = faces[k], p = cross(ray, sub(c, a)), d = dot(sub(b, a), p), s = sub(eye, a), u = dot(s, p) / d, q = cross(s, sub(b, a)), v = dot(ray, q) / d;
    if (u > 0 && v > 0 && u + v < 1) hits.push([dot(sub(c, a), q) / d, k]);
  }
  return hits.sort((x, y) => x[0] - y[0]);
}

let hidden = 0;
for (let turn = 0; turn < 8; ++turn) {
  const eye = unit([random() - 0.5, random() - 0.5, random() - 0.5]).map((x) => (turn === 7 ? 3.2 : 8) * x), forward = unit(eye.map((x) => -x));
  const right = unit(cross(forward, [0, 0, 1])), up = cross(right, forward);
  const sight = { eye: xyz(eye), forward: xyz(forward), right: xyz(right), up: xyz(up), width: 800, height: 600, perTangent: 300 / Math.tan(Math.PI / 8) };
  const seeThrough = Uint8Array.from(balls, (_, i) => (turn === 0 || (turn + i) % 3 === 0 ? 1 : 0));
  const { solid, all } = draws.fill(sight, seeThrough, false, list), drawn = Array.from({ length: all / 3 }, (_, k) => list[3 * k] / 3), isDrawn = new Set(drawn);
  const facing = faces.map((_, k) => k).filter((k) => looksAt(k, eye));
  check("no face that looks away", drawn.every((k) => edgeOn(k, eye) || looksAt(k, eye)));
  check("each once", isDrawn.size === drawn.length);
  check("solid ones first", drawn.every((k, place) => seeThrough[cellOf(k)] === (3 * place < solid ? 0 : 1)));
  check("if all are wished for, all", draws.fill(sight, seeThrough, true, new Uint16Array(corners.length)).all === corners.length);
  hidden += facing.length - drawn.length;
  // Along rays: what is met up to the first solid face must be drawn, and of two that one sees through the farther one earlier.
  const place = new Map(drawn.map((k, i) => [k, i]));
  let met = 0, wrong = 0, missing = 0;
  for (let r = 0; r < 300; ++r) {
    const [x, y] = [800 * random() - 400, 600 * random() - 300].map((p) => p / sight.perTangent);
    const hits = hitsOf(eye, unit(forward.map((f, k) => f + x * right[k] + y * up[k])), facing);
    const first = hits.findIndex(([, k]) => !seeThrough[cellOf(k)]), seen = first < 0 ? hits : hits.slice(0, first + 1);
    missing += seen.filter(([, k]) => !isDrawn.has(k)).length;
    const through = seen.filter(([, k]) => seeThrough[cellOf(k)]);
    for (let i = 1; i < through.length; ++i) (++met, (wrong += place.get(through[i][1]) > place.get(through[i - 1][1]) ? 1 : 0));
  }
  check("all that is seen is drawn", missing === 0, missing);
  // And of those that are not drawn, near each corner a solid face lies before them, or they are outside of the picture.
  const left = facing.filter((k) => !isDrawn.has(k));
  let seen = 0;
  for (let n = 0; n < 60 && left.length > 0; ++n) {
    const k = left[Math.floor(random() * left.length)], [a, b, c] = faces[k];
    for (const [u, v, w] of [[0.96, 0.02, 0.02], [0.02, 0.96, 0.02], [0.02, 0.02, 0.96]]) {
      const to = sub(a.map((x, i) => u * x + v * b[i] + w * c[i]), eye), depth = dot(to, forward);
      const isInside = Math.abs(dot(to, right) / depth) < 400 / sight.perTangent && Math.abs(dot(to, up) / depth) < 300 / sight.perTangent;
      const before = hitsOf(eye, unit(to), facing).find(([, f]) => f === k || !seeThrough[cellOf(f)]);
      if (isInside && before?.[1] === k) ++seen;
    }
  }
  check("what is not drawn cannot be seen", seen === 0, seen);
  if (turn === 0) check("rays meet several cells that one sees through", met > 10, met);
  check("far faces are drawn before those that they are seen through", wrong === 0, `${wrong} of ${met}`);
}
check("some that are hidden are not drawn", hidden > 500, hidden);

const keys = Float32Array.from({ length: 5000 }, () => random() * 10 - 5), order = new Uint32Array(5000);
new Sorter().sort(keys, 5000, order);
check("numbers are sorted", order.every((n, i) => i === 0 || keys[order[i - 1]] <= keys[n] + 10 / 65535) && new Set(order).size === 5000);
new Sorter().sort(new Float32Array(3), 3, order);
check("equal ones stay in their order", order[0] === 0 && order[1] === 1 && order[2] === 2);

// Three cells of two vertices in an ellipsoid: one that it holds and that stands out a little, one inside, one that is free.
const shell = { axes: [2, 1, 1] };
const places = Float32Array.from([2.1, 0, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1.005, 0, 1.3, 0, 0, 0.9, 0]);
const frame = { count: 3, firstVertex: [0, 2, 4, 6], positions: places };
const drawn = insideShell(shell, frame), expected = [2.02, 0, 0, ...places.slice(3)];
check("a held cell is drawn inside of the wall, others as they are", expected.every((x, k) => Math.abs(drawn[k] - x) < 1e-6), drawn);
check("without an ellipsoid all are drawn as they are", insideShell(null, frame) === places && insideShell({ vertices: [], faces: [] }, frame) === places);
if (failures) process.exit(1);
console.log("faces are drawn in the right order, and cells in their shell");
