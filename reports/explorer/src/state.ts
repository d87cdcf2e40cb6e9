// The user's choices, which all parts of the explorer read; the address holds them.

export interface Choice {
  time: number;
  selected: string | null; // path
  hovered: string | null;
  scaleNow: boolean; // a measure's colours span the present values, not those of all times
  colour: string; // "substance", "generation", "clone" or a measure
  names: boolean;
  surface: boolean;
  wireframe: boolean;
  normals: boolean;
  connections: boolean;
  forces: boolean;
  kinds: string; // kinds of forces: "all", or names with commas
  shell: boolean;
  opacity: number; // 0.1 to 1
  clip: "" | "x" | "y" | "z";
  clipAt: number; // -1 to 1, relative to the farthest point
  left: number; // run
  right: number; // run; -1: none
  camera: number[] | null; // eye, target, zoom
}

type Listener = (changed: Set<keyof Choice>) => void;

export class State {
  choice: Choice;
  private readonly listeners: Listener[] = [];
  private timer = 0;
  private written = "";

  constructor(
    private readonly initial: Choice,
    private readonly most: { runs: number; time: number; isCell: (path: string) => boolean },
  ) {
    this.choice = { ...initial, ...this.fromAddress() };
    addEventListener("hashchange", () => {
      if (location.hash !== this.written) this.set({ ...this.initial, ...this.fromAddress() });
    });
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  set(changes: Partial<Choice>): void {
    const changed = new Set<keyof Choice>();
    for (const key of Object.keys(changes) as (keyof Choice)[])
      if (this.choice[key] !== changes[key]) {
        (this.choice as any)[key] = changes[key];
        changed.add(key);
      }
    if (changed.size === 0) return;
    for (const listener of this.listeners) listener(changed);
    if (changed.size > 1 || !changed.has("hovered")) this.writeSoon();
  }

  /** Writes the address later, because browsers refuse many changes in a row. */
  private writeSoon(): void {
    if (this.timer) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.written = this.toAddress();
      if (location.hash !== this.written) history.replaceState(null, "", this.written);
    }, 250);
  }

  private toAddress(): string {
    const parts: string[] = [];
    for (const key of Object.keys(this.initial) as (keyof Choice)[]) {
      const value = this.choice[key];
      if (key === "hovered" || value === this.initial[key] || value === null) continue;
      const text = Array.isArray(value)
        ? value.map((x) => Number(x.toPrecision(9))).join(",")
        : typeof value === "number"
          ? String(Number(value.toPrecision(8)))
          : String(value);
      parts.push(`${key}=${encodeURIComponent(text)}`);
    }
    return "#" + parts.join("&");
  }

  /** Reads the choices in the address, and ignores invalid ones. */
  private fromAddress(): Partial<Choice> {
    const found: any = {};
    for (const part of location.hash.slice(1).split("&")) {
      const cut = part.indexOf("=");
      const key = part.slice(0, cut) as keyof Choice;
      if (cut < 1 || !(key in this.initial) || key === "hovered") continue;
      let text: string;
      try {
        text = decodeURIComponent(part.slice(cut + 1));
      } catch {
        continue;
      }
      const number = Number(text),
        finite = text !== "" && Number.isFinite(number);
      if (key === "selected") {
        if (this.most.isCell(text)) found.selected = text;
      } else if (key === "camera") {
        const numbers = text.split(",").map(Number);
        if (numbers.length === 7 && numbers.every(Number.isFinite)) found.camera = numbers;
      } else if (key === "clip") {
        if (["", "x", "y", "z"].includes(text)) found.clip = text;
      } else if (key === "colour" || key === "kinds") found[key] = text;
      else if (typeof this.initial[key] === "boolean") found[key] = text === "true";
      else if (finite) {
        if (key === "time") found.time = Math.min(this.most.time, Math.max(0, number));
        if (key === "opacity") found.opacity = Math.min(1, Math.max(0.1, number));
        if (key === "clipAt") found.clipAt = Math.min(1, Math.max(-1, number));
        if (key === "left" && Number.isInteger(number) && number >= 0 && number < this.most.runs) found.left = number;
        if (key === "right" && Number.isInteger(number) && number >= -1 && number < this.most.runs)
          found.right = number;
      }
    }
    return found;
  }
}
