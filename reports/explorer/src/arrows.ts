// Arrows as triangles: a shaft with three sides and a head with four.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Mesh,
  MeshBasicMaterial,
  SRGBColorSpace,
  Vector3,
  type WebGLRenderer,
} from "three";
import type { Rgb } from "./colours";

export interface Arrow {
  from: [number, number, number];
  along: [number, number, number]; // [length] as drawn
  colour: Rgb;
}

const faces = [
  0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5, 6, 7, 10, 7, 8, 10, 8, 9, 10, 9, 6, 10, 7, 6, 8, 9, 8, 6,
];
const corners = 11;

/** Arrows drawn over the cells; nearer arrows hide farther ones. */
export class Arrows {
  readonly object = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({ vertexColors: true, transparent: true, toneMapped: false }),
  );

  constructor() {
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 10;
    this.object.onBeforeRender = (renderer) => (renderer as WebGLRenderer).clearDepth();
  }

  /** `thickness`: radius of a shaft [length]. */
  show(arrows: Arrow[], thickness: number): void {
    this.object.visible = arrows.length > 0;
    const positions = new Float32Array(3 * corners * arrows.length),
      colours = new Float32Array(positions.length);
    const index = new Uint32Array(faces.length * arrows.length),
      along = new Vector3(),
      u = new Vector3(),
      v = new Vector3(),
      shown = new Color();
    arrows.forEach(({ from, along: by, colour }, n) => {
      along.set(...by);
      shown.setRGB(...colour, SRGBColorSpace); // three.js computes in linear light
      const length = along.length(),
        head = Math.min(5 * thickness, 0.6 * length),
        thin = Math.min(1, head / (5 * thickness));
      along.divideScalar(length);
      u.set(Math.abs(along.x) < 0.8 ? 1 : 0, Math.abs(along.x) < 0.8 ? 0 : 1, 0)
        .cross(along)
        .normalize();
      v.crossVectors(along, u);
      let at = 3 * corners * n;
      // Corners lie on both ends of the shaft, on the head's base, and at the tip. One side is darker for shape.
      const put = (distance: number, radius: number, angle: number) => {
        const a = radius * Math.cos(angle),
          b = radius * Math.sin(angle),
          light = 0.8 + 0.2 * Math.cos(angle);
        for (const [k, axis] of (["x", "y", "z"] as const).entries()) {
          positions[at + k] = from[k] + distance * along[axis] + a * u[axis] + b * v[axis];
          colours[at + k] = shown.toArray()[k] * light;
        }
        at += 3;
      };
      for (const distance of [0, length - head])
        for (let k = 0; k < 3; ++k) put(distance, thin * thickness, (2 * Math.PI * k) / 3);
      for (let k = 0; k < 4; ++k) put(length - head, 2.2 * thin * thickness, (Math.PI * k) / 2);
      put(length, 0, 0);
      for (let k = 0; k < faces.length; ++k) index[faces.length * n + k] = faces[k] + corners * n;
    });
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3));
    this.object.geometry.setAttribute("color", new BufferAttribute(colours, 3));
    this.object.geometry.setIndex(new BufferAttribute(index, 1));
  }
}
