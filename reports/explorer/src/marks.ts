// Lines beside the surfaces: edges, outlines of chosen cells, normals, connections, the shell.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, type Color, type Plane } from "three";
import type { Run } from "./data";
import { edgesOf, normalLines, shellLines } from "./lines";
import { shellThickness } from "./shell";
import type { Choice } from "./state";
import type { Surface } from "./surface";

function lines(colour: number, opacity: number): LineSegments<BufferGeometry, LineBasicMaterial> {
  const made = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: colour, opacity, transparent: true }),
  );
  made.frustumCulled = false;
  return made;
}

function replacePoints(of: LineSegments, points: Float32Array): void {
  of.geometry.dispose();
  of.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
}

export class Marks {
  readonly object = new Group();
  private readonly wires = lines(0x000000, 0.35);
  private readonly outline = lines(0x0b62b5, 1);
  private readonly normals = lines(0x3366cc, 0.9);
  private readonly held = lines(0xd55e00, 1);
  private readonly shell = lines(0x888888, 0.5);
  private readonly edges: Uint32Array[]; // of the run's meshes
  private frame: Surface["frame"] | null = null;

  constructor(
    private readonly run: Run,
    private readonly surface: Surface,
  ) {
    this.object.add(this.wires, this.outline, this.normals, this.held, this.shell);
    this.edges = run.meshes.map(edgesOf);
    this.held.material.depthTest = false; // connections run inside of cells
    this.shell.scale.setScalar(shellThickness);
    replacePoints(this.shell, Float32Array.from(shellLines(run.shell)));
  }

  /** Returns the edges of the cells at these places in the frame. */
  private edgesOfCells(cells: Iterable<number>): Uint32Array {
    const { frame } = this.surface,
      ends: number[] = [];
    for (const i of cells) for (const v of this.edges[frame.mesh[i]]) ends.push(v + frame.firstVertex[i]);
    return Uint32Array.from(ends);
  }

  private takeShape(): void {
    const { geometry, frame } = this.surface;
    this.frame = frame;
    for (const of of [this.wires, this.outline]) {
      of.geometry.dispose();
      of.geometry = new BufferGeometry().setAttribute("position", geometry.getAttribute("position"));
    }
    if (this.wires.visible) this.takeWires();
    for (const of of [this.normals, this.held]) replacePoints(of, new Float32Array(0));
  }

  private takeWires(): void {
    this.wires.geometry.setIndex(new BufferAttribute(this.edgesOfCells(this.surface.frame.cell.keys()), 1));
  }

  update(choice: Choice): void {
    const { surface } = this,
      { frame } = surface,
      isNew = frame !== this.frame;
    this.wires.visible = choice.wireframe;
    if (isNew) this.takeShape();
    else if (choice.wireframe && !this.wires.geometry.index) this.takeWires();
    this.outline.geometry.setIndex(new BufferAttribute(this.edgesOfCells(surface.marked), 1));
    this.outline.visible = surface.marked.length > 0;
    this.shell.visible = choice.shell;
    this.normals.visible = choice.normals;
    if (choice.normals && this.normals.geometry.getAttribute("position").count === 0)
      replacePoints(
        this.normals,
        normalLines(surface.geometry.getAttribute("position").array as Float32Array, surface.geometry.getAttribute("normal").array, 0.08 * this.run.radius),
      );
    this.held.visible = choice.connections;
    if (choice.connections && this.held.geometry.getAttribute("position").count === 0) {
      const points: number[] = [];
      for (const ends of frame.connections)
        for (const i of ends) points.push(...surface.centres.subarray(3 * i, 3 * i + 3));
      replacePoints(this.held, Float32Array.from(points));
    }
  }

  cut(planes: Plane[]): void {
    for (const of of [this.wires, this.outline, this.normals, this.held]) of.material.clippingPlanes = planes;
  }

  /** Chooses colours that are visible on this paper. */
  takePaper(paper: Color, accent: string): void {
    this.wires.material.color.set(paper.r + paper.g + paper.b < 1 ? 0xffffff : 0x000000);
    this.outline.material.color.set(accent || "#0b62b5");
  }
}
