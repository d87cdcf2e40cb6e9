// The camera: its position and its controls.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Sight } from "./occlusion";

export const standpoints: Record<string, [number, number, number]> = {
  iso: [0.35, -1, 0.45],
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  top: [0, -0.0001, 1],
  bottom: [0, -0.0001, -1],
};

export class Eye {
  readonly camera = new PerspectiveCamera(30, 1, 0.01, 1000);
  private readonly controls: OrbitControls;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    moved: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", moved);
  }

  /** Looks from a direction at everything within `size` [length] of the origin. */
  look(direction: readonly number[], size: number): void {
    const { camera } = this,
      away = ((size / Math.sin((camera.fov * Math.PI) / 360)) * 1.12) / Math.min(1, camera.aspect);
    this.controls.target.set(0, 0, 0);
    camera.position.set(direction[0], direction[1], direction[2]).setLength(away);
    camera.zoom = 1;
    camera.near = away / 100;
    camera.far = away * 10;
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  place(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom];
  }

  /** Moves the camera to a place of another view or of the address. Returns false if it was there already. */
  putAt(place: readonly number[]): boolean {
    const { camera, controls } = this,
      now = this.place();
    if (place.every((x, i) => Math.abs(x - now[i]) < 1e-9)) return false;
    camera.position.set(place[0], place[1], place[2]);
    controls.target.set(place[3], place[4], place[5]);
    camera.zoom = place[6];
    camera.updateProjectionMatrix();
    camera.lookAt(controls.target);
    controls.update();
    return true;
  }

  turn(right: number, up: number): void {
    const from = this.camera.position.clone().sub(this.controls.target),
      r = from.length();
    const around = Math.atan2(from.y, from.x) + right,
      height = Math.min(1.55, Math.max(-1.55, Math.asin(from.z / r) + up));
    from.set(r * Math.cos(height) * Math.cos(around), r * Math.cos(height) * Math.sin(around), r * Math.sin(height));
    this.camera.position.copy(from.add(this.controls.target));
    this.controls.update();
  }

  /** Adapts the camera to the canvas's shape, with the same part of space in view. */
  resize(width: number, height: number): void {
    const { camera } = this,
      before = Math.min(1, camera.aspect);
    camera.aspect = width / height;
    const far = camera.position
      .clone()
      .sub(this.controls.target)
      .multiplyScalar(before / Math.min(1, camera.aspect));
    camera.position.copy(far.add(this.controls.target));
    camera.updateProjectionMatrix();
  }

  /** Returns the length of a pixel at the middle. */
  lengthPerPixel(): number {
    const { camera } = this,
      away = camera.position.distanceTo(this.controls.target);
    return (2 * away * Math.tan((camera.fov * Math.PI) / 360)) / (camera.zoom * Math.max(1, this.canvas.clientHeight));
  }

  sight(): Sight {
    const { camera } = this,
      [right, up, back] = [new Vector3(), new Vector3(), new Vector3()];
    camera.updateMatrixWorld();
    camera.matrixWorld.extractBasis(right, up, back);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return {
      eye: camera.position.clone(),
      forward: back.negate(),
      right,
      up,
      width,
      height,
      perTangent: (camera.zoom * height) / 2 / Math.tan((camera.fov * Math.PI) / 360),
    };
  }

  dispose(): void {
    this.controls.dispose();
  }
}
