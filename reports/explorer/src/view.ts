// A canvas that shows one organism in three dimensions.
import { Color, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { Arrows } from "./arrows";
import type { Colouring } from "./colours";
import type { Run } from "./data";
import { Eye, standpoints } from "./eye";
import { Marks } from "./marks";
import { whatDraws } from "./shading";
import type { State } from "./state";
import { Surface } from "./surface";
import { element } from "./tools";

const maxNames = 100;

export class View {
  readonly canvas: HTMLCanvasElement;
  readonly eye: Eye;
  onCamera: (view: View) => void = () => {};
  onResize: () => void = () => {};
  onPick: (path: string | null) => void = () => {};
  onHover: (path: string | null, x: number, y: number) => void = () => {};
  size = 1; // [length] distance of the farthest point at any time
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly surface: Surface;
  private readonly marks: Marks;
  readonly arrows = new Arrows();
  private readonly plane = new Plane(new Vector3(-1, 0, 0), 0);
  private frame = -1;
  private waiting = false;
  private drawn = false;
  private readonly names = element("div", "names");
  private naming = 0; // timer
  private gone = false; // a pending frame is not drawn any more

  constructor(
    private readonly parent: HTMLElement,
    readonly run: Run,
    private readonly state: State,
    private readonly colouring: Colouring,
  ) {
    const by = whatDraws(),
      software = by === "software";
    if (by === "nothing") throw new Error("there is no WebGL");
    this.renderer = new WebGLRenderer({ antialias: !software, powerPreference: "low-power" });
    this.renderer.setPixelRatio(software ? 1 : Math.min(2, devicePixelRatio));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.names.setAttribute("aria-hidden", "true");
    parent.append(this.canvas, this.names);
    this.eye = new Eye(this.canvas, () => {
      this.draw();
      this.onCamera(this);
    });
    this.surface = new Surface(software);
    this.marks = new Marks(run, this.surface);
    this.scene.add(this.surface.object, this.marks.object, this.arrows.object);
    this.size = this.farthest();
    this.look(standpoints.iso);
    this.takePaper();
    this.listen();
    new ResizeObserver(() => {
      if (!this.gone) this.resize();
    }).observe(parent);
    this.resize();
  }

  private farthest(): number {
    const { run } = this;
    let squares = 0;
    for (const number of [0, run.times.length - 1]) {
      const { positions } = run.frame(number);
      for (let k = 0; k < positions.length; k += 3)
        squares = Math.max(squares, positions[k] ** 2 + positions[k + 1] ** 2 + positions[k + 2] ** 2);
    }
    return Math.max(Math.sqrt(squares) || 1, ...(run.shell?.axes ?? []));
  }

  look(direction: readonly number[]): void {
    this.eye.look(direction, this.size);
  }

  /** Moves the camera to a place of another view or of the address. */
  putAt(place: readonly number[]): void {
    if (this.eye.putAt(place)) this.draw();
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.parent;
    if (!w || !h) return;
    this.renderer.setSize(w, h);
    this.eye.resize(w, h);
    this.onResize();
    this.draw();
  }

  /** The middles of the shown cells, [3 i]. */
  get centres(): ArrayLike<number> {
    return this.surface.centres;
  }

  /** Returns true if a point is not cut away. */
  isThere(point: Vector3): boolean {
    return this.state.choice.clip === "" || this.plane.distanceToPoint(point) >= 0;
  }

  /** Returns the path of the cell under a place of the canvas; null if there is none. */
  private pick(event: { offsetX: number; offsetY: number }): string | null {
    const { clientWidth: w, clientHeight: h } = this.canvas,
      ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * event.offsetX) / w - 1, 1 - (2 * event.offsetY) / h), this.eye.camera);
    const i = this.surface.hit(ray, (point) => this.isThere(point));
    return i < 0 ? null : (this.run.cells[this.surface.frame.cell[i]]?.path ?? null);
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

  /** Updates the picture from the state. */
  update(): void {
    const { choice } = this.state,
      { run, surface } = this,
      number = run.frameNumber(choice.time);
    if (number !== this.frame) {
      this.frame = number;
      surface.takeShape(run, run.frame(number));
    }
    surface.takeColours(run, choice, this.colouring);
    surface.object.visible = choice.surface;
    this.clip();
    this.marks.update(choice);
    const n = surface.frame.count;
    const time = Number(surface.frame.time.toPrecision(5));
    this.canvas.setAttribute(
      "aria-label",
      `${run.title}: ${n} ${n === 1 ? "cell" : "cells"} at time ${time}, in three dimensions`,
    );
    this.draw();
  }

  private clip(): void {
    const { clip, clipAt } = this.state.choice;
    if (clip) {
      this.plane.normal.set(clip === "x" ? -1 : 0, clip === "y" ? 1 : 0, clip === "z" ? -1 : 0);
      this.plane.constant = (clip === "y" ? -1 : 1) * clipAt * this.size;
    }
    this.surface.cut(clip ? this.plane : null, 0.06 * this.run.radius);
    this.marks.cut(clip ? [this.plane] : []);
    this.renderer.localClippingEnabled = clip !== "";
  }

  /** Takes the page's colours, light or dark. */
  takePaper(): void {
    const style = getComputedStyle(document.documentElement),
      paper = new Color(style.getPropertyValue("--paper").trim() || "#fafaf8");
    this.renderer.setClearColor(paper);
    this.marks.takePaper(paper, style.getPropertyValue("--accent").trim());
    this.draw();
  }

  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  private drawNow(): void {
    if (this.frame < 0 || this.gone) return;
    this.surface.arrange(this.eye.sight());
    this.renderer.render(this.scene, this.eye.camera);
    if (!this.drawn) performance.mark("morula-first-frame");
    this.drawn = true;
    this.names.replaceChildren();
    clearTimeout(this.naming);
    if (this.state.choice.names) this.naming = window.setTimeout(() => this.name(), 150); // when it comes to rest
  }

  /** Writes the names of cells whose middles are seen, the nearest first and none over another. */
  private name(): void {
    if (this.gone) return;
    const { clientWidth: w, clientHeight: h } = this.canvas,
      { frame, centres } = this.surface,
      ray = new Raycaster(),
      taken: DOMRect[] = [];
    const middles = Array.from({ length: frame.count }, (_, i) => new Vector3().fromArray(centres, 3 * i));
    const away = (i: number) => middles[i].distanceToSquared(this.eye.camera.position);
    for (const i of middles.map((_, i) => i).sort((a, b) => away(a) - away(b)).slice(0, maxNames)) {
      const at = middles[i].clone().project(this.eye.camera),
        cell = this.run.cells[frame.cell[i]];
      ray.setFromCamera(new Vector2(at.x, at.y), this.eye.camera);
      if (!cell || this.surface.hit(ray, (point) => this.isThere(point)) !== i) continue;
      const label = element("span", "", cell.label);
      label.style.left = `${(0.5 + at.x / 2) * w}px`;
      label.style.top = `${(0.5 - at.y / 2) * h}px`;
      this.names.append(label);
      const box = label.getBoundingClientRect();
      if (taken.some((b) => b.left < box.right && box.left < b.right && b.top < box.bottom && box.top < b.bottom))
        label.remove();
      else taken.push(box);
    }
  }

  dispose(): void {
    this.gone = true;
    this.eye.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
