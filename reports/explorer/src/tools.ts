// The controls above the organism.
import type { Colouring } from "./colours";
import type { Data } from "./data";
import type { State } from "./state";
import { standpoints } from "./eye";

export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  className = "",
  text = "",
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** Creates an SVG element. */
export function drawn<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Record<string, string | number> = {},
): SVGElementTagNameMap[K] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

function choiceOf(options: [string, string][], label: string): [HTMLLabelElement, HTMLSelectElement] {
  const made = element("label", "", label + " "),
    select = element("select");
  for (const [value, text] of options) {
    const option = element("option", "", text);
    option.value = value;
    select.append(option);
  }
  made.append(select);
  return [made, select];
}

export class Tools {
  readonly box = element("div", "tools");
  /** Called when the user has chosen a direction to look from. */
  onLook: (direction: readonly number[]) => void = () => {};

  constructor(
    private readonly data: Data,
    private readonly state: State,
    private readonly colouring: Colouring,
    bodies: boolean,
  ) {
    this.box.setAttribute("role", "group");
    this.box.setAttribute("aria-label", "What the explorer shows");
    this.fill(bodies);
  }

  private toggle(
    key: "scaleNow" | "names" | "surface" | "wireframe" | "normals" | "connections" | "forces" | "shell",
    text: string,
  ): HTMLElement {
    const label = element("label"),
      box = element("input");
    box.type = "checkbox";
    box.name = key;
    box.checked = this.state.choice[key];
    box.addEventListener("change", () => this.state.set({ [key]: box.checked }));
    this.state.listen((changed) => {
      if (changed.has(key)) box.checked = this.state.choice[key];
    });
    label.append(box, text);
    return label;
  }

  private range(key: "opacity" | "clipAt", text: string, least: number, most: number): HTMLElement {
    const label = element("label", "", text + " "),
      range = element("input");
    range.type = "range";
    range.name = key;
    range.min = String(least);
    range.max = String(most);
    range.step = "0.01";
    range.value = String(this.state.choice[key]);
    range.addEventListener("input", () => this.state.set({ [key]: Number(range.value) }));
    this.state.listen((changed) => {
      if (changed.has(key)) range.value = String(this.state.choice[key]);
    });
    label.append(range);
    return label;
  }

  private select(key: "colour" | "clip" | "left" | "right", text: string, options: [string, string][]): HTMLElement {
    const [label, select] = choiceOf(options, text);
    select.name = key;
    select.value = String(this.state.choice[key]);
    select.addEventListener("change", () =>
      this.state.set({ [key]: key === "left" || key === "right" ? Number(select.value) : select.value }),
    );
    this.state.listen((changed) => {
      if (changed.has(key)) select.value = String(this.state.choice[key]);
    });
    return label;
  }

  private fill(bodies: boolean): void {
    const { box: tools } = this,
      { runs } = this.data;
    if (runs.length > 1) {
      const names = runs.map((run, i): [string, string] => [String(i), run.title]);
      tools.append(this.select("left", "Left", names), this.select("right", "Right", [["-1", "none"], ...names]));
    }
    const colours = this.colouring.choices();
    if (!colours.includes(this.state.choice.colour)) this.state.set({ colour: "substance" });
    tools.append(
      this.select(
        "colour",
        "Colour",
        colours.map((c) => [c, c.replace(/_/g, " ")]),
      ),
    );
    if (!bodies) return;
    const now = this.toggle("scaleNow", "scale of this time");
    const show = () => (now.hidden = !this.data.runs.some((run) => run.measures.includes(this.state.choice.colour)));
    this.state.listen((changed) => {
      if (changed.has("colour")) show();
    });
    show();
    tools.append(now);
    tools.append(
      this.toggle("names", "names"),
      this.toggle("surface", "surface"),
      this.toggle("wireframe", "wireframe"),
      this.toggle("normals", "normals"),
    );
    if (runs.some((run) => run.forces.length)) tools.append(this.toggle("forces", "forces"));
    if (runs.some((run) => run.connected)) tools.append(this.toggle("connections", "connections"));
    if (runs.some((run) => run.shell)) tools.append(this.toggle("shell", "shell"));
    tools.append(
      this.range("opacity", "Opacity", 0.1, 1),
      this.select("clip", "Clip", [
        ["", "none"],
        ["x", "x"],
        ["y", "y"],
        ["z", "z"],
      ]),
      this.range("clipAt", "at", -1, 1),
    );
    const [label, from] = choiceOf(
      [["", "…"], ...Object.keys(standpoints).map((s): [string, string] => [s, s])],
      "View from",
    );
    from.name = "view";
    from.addEventListener("change", () => {
      if (from.value) this.onLook(standpoints[from.value]);
      from.value = "";
    });
    tools.append(label);
  }
}
