// The cells' surfaces as one mesh, so that one graphics call draws many cells.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  Mesh,
  type Plane,
  type Raycaster,
  type Vector3,
} from "three";
import type { Colouring } from "./colours";
import { isWithin, type Frame, type Run } from "./data";
import { DrawList } from "./faces";
import type { Sight } from "./occlusion";
import { cellMaterial, insideMaterial } from "./shading";
import { insideShell } from "./shell";
import type { Choice } from "./state";

const dimmed = 0.1; // opacity

export class Surface {
  readonly object = new Group();
  readonly geometry = new BufferGeometry();
  frame!: Frame;
  centres = new Float32Array(0); // [3 i] mean of each cell's vertices
  marked: number[] = []; // cells that are hovered over or selected
  private readonly materials = [cellMaterial(false), cellMaterial(true)];
  private readonly mesh = new Mesh(this.geometry, this.materials);
  private readonly inside = new Mesh(this.geometry, [insideMaterial()]); // the inner side of cut solid cells
  private seeThrough = new Uint8Array(0);
  private isDimmed = new Uint8Array(0);
  private list!: DrawList;
  private colours = new Uint8Array(0);
  private drawnFrom = ""; // the sight of the present order of faces

  /** `frugal`: passes on only visible faces, because a processor draws. */
  constructor(private readonly frugal: boolean) {
    this.object.add(this.mesh, this.inside);
    this.mesh.frustumCulled = this.inside.frustumCulled = false;
  }

  takeShape(run: Run, frame: Frame): void {
    this.frame = frame;
    const firstFace = new Uint32Array(frame.count + 1);
    for (let i = 0; i < frame.count; ++i) firstFace[i + 1] = firstFace[i] + run.meshes[frame.mesh[i]].length / 3;
    const corners = new Uint32Array(3 * firstFace[frame.count]),
      vertices = frame.firstVertex[frame.count],
      positions = insideShell(run.shell, frame);
    this.centres = new Float32Array(3 * frame.count);
    for (let i = 0, at = 0; i < frame.count; ++i) {
      const first = frame.firstVertex[i],
        n = frame.firstVertex[i + 1] - first,
        faces = run.meshes[frame.mesh[i]];
      for (let k = 0; k < faces.length; ++k) corners[at++] = faces[k] + first;
      for (let v = first; v < first + n; ++v)
        for (let axis = 0; axis < 3; ++axis) this.centres[3 * i + axis] += frame.positions[3 * v + axis] / n;
    }
    this.geometry.dispose();
    this.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.geometry.setIndex(new BufferAttribute(corners, 1));
    this.geometry.deleteAttribute("normal");
    this.geometry.computeVertexNormals();
    this.list = new DrawList({
      corners,
      firstFace,
      positions,
      across: Array.from(frame.mesh, (mesh) => run.across[mesh]),
    });
    const index = new BufferAttribute(
      vertices < 65536 ? new Uint16Array(corners.length) : new Uint32Array(corners.length),
      1,
    );
    index.setUsage(DynamicDrawUsage);
    this.geometry.setIndex(index);
    this.colours = new Uint8Array(4 * vertices);
    this.geometry.setAttribute("color", new BufferAttribute(this.colours, 4, true));
    this.drawnFrom = "";
  }

  takeColours(run: Run, choice: Choice, colouring: Colouring): void {
    const { frame, colours } = this;
    const selected = choice.selected === null ? null : (run.byPath.get(choice.selected) ?? null);
    const isChosen = (i: number) => selected !== null && isWithin(run.cells[frame.cell[i]]?.path ?? "-", selected.path);
    let chosen = 0;
    if (selected) for (let i = 0; i < frame.count; ++i) chosen += isChosen(i) ? 1 : 0;
    const dims = chosen > 0 && selected!.daughters.length > 0;
    this.seeThrough = new Uint8Array(frame.count);
    this.isDimmed = new Uint8Array(frame.count);
    this.marked = [];
    for (let i = 0; i < frame.count; ++i) {
      const hovered = choice.hovered !== null && run.cells[frame.cell[i]]?.path === choice.hovered,
        mine = isChosen(i);
      const opacity =
        (dims && !mine ? dimmed : 1) * (mine && chosen > 0 ? Math.max(choice.opacity, 0.85) : choice.opacity);
      const rgb = colouring.ofCell(run, frame, i, choice.colour, choice.scaleNow ? choice.time : null);
      const [r, g, b] = rgb.map((x) => Math.round(255 * (hovered ? 0.75 * x + 0.25 : x))),
        a = Math.round(255 * opacity);
      this.seeThrough[i] = a < 254 ? 1 : 0;
      this.isDimmed[i] = dims && !mine ? 1 : 0;
      for (let k = 4 * frame.firstVertex[i]; k < 4 * frame.firstVertex[i + 1]; k += 4) {
        colours[k] = r;
        colours[k + 1] = g;
        colours[k + 2] = b;
        colours[k + 3] = a;
      }
      if (hovered || (mine && !dims)) this.marked.push(i);
    }
    this.geometry.getAttribute("color").needsUpdate = true;
    this.drawnFrom = "";
  }

  /** Cuts the surfaces by a plane; null: no cut. `lift` [length]: shift of the inside (shading.ts). */
  cut(plane: Plane | null, lift: number): void {
    for (const material of [...this.materials, ...this.inside.material]) material.clippingPlanes = plane ? [plane] : [];
    this.inside.material[0].uniforms.lift.value = lift;
    if (this.inside.visible !== (plane !== null)) this.drawnFrom = "";
    this.inside.visible = plane !== null;
  }

  /** Arranges the faces in drawing order for a sight. */
  arrange(sight: Sight): void {
    const seen = this.frugal || this.seeThrough.includes(1) ? JSON.stringify(sight) : "anywhere";
    if (seen === this.drawnFrom) return;
    this.drawnFrom = seen;
    const index = this.geometry.index!;
    const { solid, all } = this.list.fill(
      sight,
      this.seeThrough,
      this.inside.visible || !this.frugal,
      index.array as Uint16Array,
    );
    this.geometry.clearGroups();
    this.geometry.addGroup(0, solid, 0);
    if (solid < all) this.geometry.addGroup(solid, all - solid, 1);
    index.clearUpdateRanges();
    index.addUpdateRange(0, all);
    index.needsUpdate = true;
  }

  /** Returns the first undimmed cell along a ray; -1: none. `within` tells if a point is not cut away. */
  hit(ray: Raycaster, within: (point: Vector3) => boolean): number {
    // The mesh changes at every frame, so its bounds are recomputed.
    this.geometry.boundingSphere = this.geometry.boundingBox = null;
    for (const hit of ray.intersectObject(this.mesh, false)) {
      const i = this.cellOfVertex(hit.face!.a);
      if (within(hit.point) && !this.isDimmed[i]) return i;
    }
    return -1;
  }

  private cellOfVertex(vertex: number): number {
    const first = this.frame.firstVertex;
    let low = 0,
      high = this.frame.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (first[middle] <= vertex) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}
