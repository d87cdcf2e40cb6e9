// One organism in three dimensions. All cells are one mesh, so that many of them are one call to the graphics; what is dimmed
// or transparent stands behind in its list of faces, far cells first, and shows what lies behind it.
import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Mesh, PerspectiveCamera, Plane, Raycaster, Scene, Vector2,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Colouring } from "./colours";
import { isWithin, type Frame, type Run } from "./data";
import { edgesOf, normalLines, shellLines } from "./lines";
import { cellMaterial, drawsInSoftware, insideMaterial } from "./shading";
import type { State } from "./state";

const dimmed = 0.1; // opacity

export const standpoints: Record<string, [number, number, number]> = {
  iso: [0.35, -1, 0.45], front: [0, -1, 0], back: [0, 1, 0], left: [-1, 0, 0], right: [1, 0, 0], top: [0, -0.0001, 1], bottom: [0, -0.0001, -1],
};

export class View {
  readonly canvas: HTMLCanvasElement;
  readonly camera = new PerspectiveCamera(30, 1, 0.01, 1000);
  readonly controls: OrbitControls;
  onCamera: (view: View) => void = () => {};
  onPick: (path: string | null) => void = () => {};
  onHover: (path: string | null, x: number, y: number) => void = () => {};
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly geometry = new BufferGeometry();
  private readonly materials = [cellMaterial(false), cellMaterial(true)];
  private readonly mesh = new Mesh(this.geometry, this.materials);
  private readonly inside = new Mesh(this.geometry, [insideMaterial()]); // of solid cells, where they are cut
  private readonly wires = this.lines(0x000000, 0.35);
  private readonly outline = this.lines(0x0b62b5, 1);
  private readonly arrows = this.lines(0x3366cc, 0.9);
  private readonly held = this.lines(0xd55e00, 1);
  private readonly shell = this.lines(0x888888, 0.5);
  private readonly plane = new Plane(new Vector3(-1, 0, 0), 0);
  private frame!: Frame;
  private order: number[] = [];
  private seeThrough: boolean[] = [];
  private centres!: Float32Array;
  size = 1; // [length] of the farthest point that is ever seen
  private waiting = false;
  private drawn = false;
  private gone = false; // a frame that is still asked for is not drawn
  private readonly edges: Uint32Array[] = [];
  private readonly key = { frame: -1, run: -1 };

  constructor(private readonly parent: HTMLElement, public run: Run, private readonly state: State, private readonly colouring: Colouring) {
    const software = drawsInSoftware();
    this.renderer = new WebGLRenderer({ antialias: !software, powerPreference: "low-power" });
    this.renderer.setPixelRatio(software ? 1 : Math.min(2, devicePixelRatio));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    parent.append(this.canvas);
    this.scene.add(this.mesh, this.inside, this.wires, this.outline, this.arrows, this.held, this.shell);
    this.mesh.frustumCulled = this.inside.frustumCulled = false;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => { this.draw(); this.onCamera(this); });
    this.setRun(run);
    this.takePaper();
    this.listen();
    new ResizeObserver(() => { if (!this.gone) this.resize(); }).observe(parent);
    this.resize();
  }

  private lines(colour: number, opacity: number): LineSegments {
    const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: colour, opacity, transparent: true }));
    lines.frustumCulled = false;
    return lines;
  }

  setRun(run: Run): void {
    this.run = run;
    this.key.frame = -1;
    this.edges.length = 0;
    for (const faces of run.meshes) this.edges.push(edgesOf(faces));
    let squares = 0;
    const last = run.frame(run.times.length - 1).positions, first = run.frame(0).positions;
    for (const positions of [first, last])
      for (let k = 0; k < positions.length; k += 3) squares = Math.max(squares, positions[k] ** 2 + positions[k + 1] ** 2 + positions[k + 2] ** 2);
    this.size = Math.sqrt(squares) || 1;
    this.drawShell();
    this.look(standpoints.iso);
    this.resize();
  }

  private drawShell(): void {
    const { shell } = this.run;
    this.shell.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(shellLines(shell)), 3));
    if (shell?.axes) this.size = Math.max(this.size, ...shell.axes);
  }

  look(direction: readonly number[]): void {
    const away = this.size / Math.sin((this.camera.fov * Math.PI) / 360) * 1.06 / Math.min(1, this.camera.aspect);
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(direction[0], direction[1], direction[2]).setLength(away);
    this.camera.zoom = 1;
    this.camera.near = away / 100;
    this.camera.far = away * 10;
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  place(): number[] { return [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom]; }

  /** From where another view, or the address, looks. */
  putAt(place: readonly number[]): void {
    if (place.every((x, i) => Math.abs(x - this.place()[i]) < 1e-9)) return;
    this.camera.position.set(place[0], place[1], place[2]);
    this.controls.target.set(place[3], place[4], place[5]);
    this.camera.zoom = place[6];
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(this.controls.target);
    this.controls.update();
    this.draw();
  }

  turn(right: number, up: number): void {
    const from = this.camera.position.clone().sub(this.controls.target), r = from.length();
    const around = Math.atan2(from.y, from.x) + right, height = Math.min(1.55, Math.max(-1.55, Math.asin(from.z / r) + up));
    from.set(r * Math.cos(height) * Math.cos(around), r * Math.cos(height) * Math.sin(around), r * Math.sin(height));
    this.camera.position.copy(from.add(this.controls.target));
    this.controls.update();
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.parent;
    if (!w || !h) return;
    const before = Math.min(1, this.camera.aspect);
    this.renderer.setSize(w, h);
    this.camera.aspect = w / h;
    const far = this.camera.position.clone().sub(this.controls.target).multiplyScalar(before / Math.min(1, this.camera.aspect));
    this.camera.position.copy(far.add(this.controls.target));
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** What lies under a place of the canvas; clipped away is not there. */
  private pick(event: { offsetX: number; offsetY: number }): string | null {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * event.offsetX) / w - 1, 1 - (2 * event.offsetY) / h), this.camera);
    // The mesh is deformed at every frame: its box must be that of now.
    this.geometry.boundingSphere = null;
    this.geometry.boundingBox = null;
    const clips = this.state.choice.clip !== "";
    for (const hit of ray.intersectObject(this.mesh, false)) {
      if (clips && this.plane.distanceToPoint(hit.point) < 0) continue;
      const i = this.cellOfVertex(hit.face!.a);
      if (this.seeThrough[i] && this.state.choice.selected !== null && !this.isChosen(i)) continue; // dimmed: what is behind counts
      return this.run.cells[this.frame.cell[i]]?.path ?? null;
    }
    return null;
  }

  private cellOfVertex(vertex: number): number {
    const first = this.frame.firstVertex;
    let low = 0, high = this.frame.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (first[middle] <= vertex) low = middle; else high = middle - 1;
    }
    return low;
  }

  private listen(): void {
    let down: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (e) => (down = [e.clientX, e.clientY]));
    this.canvas.addEventListener("pointerup", (e) => {
      if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 5) this.onPick(this.pick(e));
      down = null;
    });
    let last = 0;
    this.canvas.addEventListener("pointermove", (e) => {
      if (e.buttons || e.timeStamp - last < 40) return;
      last = e.timeStamp;
      this.onHover(this.pick(e), e.clientX, e.clientY);
    });
    this.canvas.addEventListener("pointerleave", () => this.onHover(null, 0, 0));
  }

  private isChosen(i: number): boolean {
    const { selected } = this.state.choice, cell = this.run.cells[this.frame.cell[i]];
    return selected !== null && cell !== undefined && isWithin(cell.path, selected);
  }

  private pathOf(i: number): string | undefined { return this.run.cells[this.frame.cell[i]]?.path; }

  /** Shows what the state asks for. */
  update(everything = false): void {
    const { choice } = this.state;
    const number = this.run.frameNumber(choice.time);
    if (everything || number !== this.key.frame) {
      this.frame = this.run.frame(number);
      this.key.frame = number;
      this.takeShape();
    }
    this.takeColours();
    this.shell.visible = choice.shell;
    this.mesh.visible = choice.surface;
    this.clip();
    this.wires.visible = choice.wireframe;
    this.arrows.visible = choice.normals;
    this.held.visible = choice.connections;
    if (choice.normals) this.drawNormals();
    if (choice.connections) this.drawConnections();
    const n = this.frame.count;
    this.canvas.setAttribute("aria-label", `${this.run.title}: ${n} ${n === 1 ? "cell" : "cells"} at time ${Number(this.frame.time.toPrecision(5))}, in three dimensions`);
    this.draw();
  }

  private takeShape(): void {
    const { frame, run } = this;
    let faces = 0, edges = 0;
    for (let i = 0; i < frame.count; ++i) (faces += run.meshes[frame.mesh[i]].length), (edges += this.edges[frame.mesh[i]].length);
    const index = new Uint32Array(faces);
    this.centres = new Float32Array(3 * frame.count);
    for (let i = 0, at = 0; i < frame.count; ++i) {
      const first = frame.firstVertex[i], n = frame.firstVertex[i + 1] - first, list = run.meshes[frame.mesh[i]];
      for (let k = 0; k < list.length; ++k) index[at++] = list[k] + first;
      for (let v = first; v < first + n; ++v) for (let axis = 0; axis < 3; ++axis) this.centres[3 * i + axis] += frame.positions[3 * v + axis] / n;
    }
    const position = new BufferAttribute(frame.positions, 3);
    this.geometry.dispose();
    this.geometry.setIndex(new BufferAttribute(index, 1));
    this.geometry.setAttribute("position", position);
    this.geometry.deleteAttribute("normal");
    this.geometry.computeVertexNormals();
    this.order = [];
    for (const lines of [this.wires, this.outline]) {
      lines.geometry.dispose();
      lines.geometry = new BufferGeometry().setAttribute("position", position);
    }
    const wires = new Uint32Array(edges);
    for (let i = 0, at = 0; i < frame.count; ++i) for (const v of this.edges[frame.mesh[i]]) wires[at++] = v + frame.firstVertex[i];
    this.wires.geometry.setIndex(new BufferAttribute(wires, 1));
  }

  private takeColours(): void {
    const { frame, run } = this, { choice } = this.state;
    const colours = new Float32Array(4 * frame.firstVertex[frame.count]);
    const selected = choice.selected === null ? null : run.byPath.get(choice.selected) ?? null;
    let chosen = 0;
    if (selected) for (let i = 0; i < frame.count; ++i) chosen += this.isChosen(i) ? 1 : 0;
    const dims = chosen > 0 && selected!.daughters.length > 0;
    this.seeThrough = [];
    const marked: number[] = [];
    for (let i = 0; i < frame.count; ++i) {
      const path = this.pathOf(i), hovered = choice.hovered !== null && path === choice.hovered, mine = this.isChosen(i);
      const opacity = (dims && !mine ? dimmed : 1) * (mine && chosen > 0 ? Math.max(choice.opacity, 0.85) : choice.opacity);
      const [r, g, b] = this.colouring.ofCell(run, frame, i, choice.colour, choice.scaleNow ? choice.time : null).map((x) => (hovered ? 0.75 * x + 0.25 : x));
      this.seeThrough.push(opacity < 0.995);
      for (let v = frame.firstVertex[i]; v < frame.firstVertex[i + 1]; ++v) colours.set([r, g, b, opacity], 4 * v);
      if (hovered || (mine && !dims)) for (const v of this.edges[frame.mesh[i]]) marked.push(v + frame.firstVertex[i]);
    }
    this.geometry.setAttribute("color", new BufferAttribute(colours, 4));
    this.outline.geometry.setIndex(new BufferAttribute(Uint32Array.from(marked), 1));
    this.outline.visible = marked.length > 0;
    this.order = [];
  }

  /** Solid cells first, then those that one sees through, the farthest first. */
  private sort(): void {
    const { frame, run } = this, eye = this.camera.position, far: number[] = [];
    for (let i = 0; i < frame.count; ++i)
      far.push((this.centres[3 * i] - eye.x) ** 2 + (this.centres[3 * i + 1] - eye.y) ** 2 + (this.centres[3 * i + 2] - eye.z) ** 2);
    const order = far.map((_, i) => i);
    if (this.seeThrough.includes(true)) order.sort((a, b) => (this.seeThrough[a] === this.seeThrough[b] ? (this.seeThrough[a] ? far[b] - far[a] : a - b) : this.seeThrough[a] ? 1 : -1));
    const solid = order.findIndex((i) => this.seeThrough[i]);
    if (order.length === this.order.length && order.every((i, k) => i === this.order[k])) return;
    this.order = order;
    const index = this.geometry.index!;
    let at = 0, firstSeeThrough = index.count;
    order.forEach((i, k) => {
      if (k === solid) firstSeeThrough = at;
      for (const v of run.meshes[frame.mesh[i]]) index.array[at++] = v + frame.firstVertex[i];
    });
    this.geometry.clearGroups();
    this.geometry.addGroup(0, firstSeeThrough, 0);
    if (firstSeeThrough < index.count) this.geometry.addGroup(firstSeeThrough, index.count - firstSeeThrough, 1);
    index.needsUpdate = true;
  }

  private clip(): void {
    const { clip, clipAt } = this.state.choice;
    if (clip) {
      this.plane.normal.set(clip === "x" ? -1 : 0, clip === "y" ? 1 : 0, clip === "z" ? -1 : 0);
      this.plane.constant = (clip === "y" ? -1 : 1) * clipAt * this.size;
    }
    const planes = clip ? [this.plane] : [];
    for (const material of [...this.materials, ...this.inside.material]) material.clippingPlanes = planes;
    this.inside.material[0].uniforms.lift.value = 0.06 * this.run.radius;
    this.inside.visible = clip !== "" && this.mesh.visible;
    this.renderer.localClippingEnabled = planes.length > 0;
    for (const object of [this.wires, this.outline, this.arrows, this.held]) (object.material as LineBasicMaterial).clippingPlanes = planes;
  }

  private drawNormals(): void {
    const points = normalLines(this.frame.positions, this.geometry.getAttribute("normal").array, 0.08 * this.run.radius);
    this.arrows.geometry.dispose();
    this.arrows.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
  }

  private drawConnections(): void {
    const points: number[] = [];
    for (const ends of this.frame.connections) for (const i of ends) points.push(...this.centres.subarray(3 * i, 3 * i + 3));
    this.held.geometry.dispose();
    this.held.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
    (this.held.material as LineBasicMaterial).depthTest = false; // they run inside of cells
  }

  dispose(): void {
    this.gone = true;
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** [length] that a pixel shows at the middle. */
  lengthPerPixel(): number {
    const away = this.camera.position.distanceTo(this.controls.target);
    return (2 * away * Math.tan((this.camera.fov * Math.PI) / 360)) / (this.camera.zoom * Math.max(1, this.canvas.clientHeight));
  }

  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.drawNow(); });
  }

  /** The page's colours, light or dark. */
  takePaper(): void {
    const style = getComputedStyle(document.documentElement), paper = new Color(style.getPropertyValue("--paper").trim() || "#fafaf8");
    this.renderer.setClearColor(paper);
    (this.wires.material as LineBasicMaterial).color.set(paper.r + paper.g + paper.b < 1 ? 0xffffff : 0x000000);
    (this.outline.material as LineBasicMaterial).color.set(style.getPropertyValue("--accent").trim() || "#0b62b5");
    this.draw();
  }

  drawNow(): void {
    if (!this.frame || this.gone) return;
    this.sort();
    this.renderer.render(this.scene, this.camera);
    if (!this.drawn) performance.mark("morula-first-frame");
    this.drawn = true;
  }
}
