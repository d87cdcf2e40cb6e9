// The messages between the playground's page and the workers in which the simulator reads and runs scenarios.

import type { Data } from "../data";

export interface Written {
  name: string;
  text: string;
  files: [string, string, string][]; // role, path, content
}

export interface Order {
  module?: Uint8Array;
  number: number;
  written: Written;
  runs: boolean;
}

/** The strict reader's answer for a scenario without mistakes (runner/input/browser/module.cpp). */
export interface Read {
  name: string;
  seed: number;
  summary: string;
  genes: number;
  warnings: string[];
  hasBodies: boolean;
  end: number | null;
  radius: number;
  shell: { axes?: number[]; vertices?: number[]; faces?: number[] } | null;
  colours: Record<string, string>;
  cellColours: Record<string, string>; // by the text of their cells: "clone ABp"
  cost: { cells: number; isMore: boolean; vertexSteps: number; steps: number; memory: number };
}

export interface Snapshot {
  time: number;
  step: number;
  lineage?: [string, string, number, number, "alive" | "divided" | "died", string, string][]; // substances, own colour or ""
  cells?: [number, string, (number | null)[], number][]; // number in the lineage, substances, measures, vertices
  contacts?: [number, number, number][];
  world?: (number | null)[];
  vertices: Float32Array;
  meshes: [number, number[]][]; // new meshes: number of vertices, faces
}

export interface Measures {
  cell: string[];
  world: string[];
  units: Data["units"];
}

export type News =
  | { kind: "read"; number: number; read: Read | null; mistakes: string[] }
  | { kind: "begun"; measures: Measures }
  | { kind: "snapshot"; snapshot: Snapshot }
  | { kind: "end"; hash: string; steps: number; seconds: number }
  | { kind: "failed"; why: string };
