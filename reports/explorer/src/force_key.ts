// The key of force arrows: the kinds shown, their colours, the scale, and the meaning of an arrow.
import { Vector3 } from "three";
import { rgbOf } from "./colours";
import { numberText, type Data } from "./data";
import { cellWithVertexForces, ForcesOfRun, isWished, kindsOf } from "./forces";
import type { State } from "./state";
import { element } from "./tools";
import type { View } from "./view";

const keyLength = 70; // [pixel] max length of the key's arrow

export class ForceKey {
  readonly box = element("div", "bar forces");
  private readonly colours = new Map<string, string>();
  private readonly chips = new Map<string, { box: HTMLInputElement; swatch: HTMLElement; none: HTMLElement }>();
  private readonly key = element("span", "arrow");
  private readonly amount = element("span");
  private readonly text = element("span", "note");
  private perForce = 1; // [length/force]

  constructor(
    private readonly data: Data,
    private readonly state: State,
  ) {
    this.box.setAttribute("role", "group");
    this.box.setAttribute("aria-label", "Arrows of forces");
    for (const { name, meaning } of kindsOf(data)) {
      const label = element("label", "chip"),
        box = element("input"),
        swatch = element("i"),
        none = element("span", "note");
      box.type = "checkbox";
      box.name = `force-${name}`;
      box.addEventListener("change", () => this.choose(name, box.checked));
      label.title = meaning;
      label.append(box, swatch, name, none);
      this.chips.set(name, { box, swatch, none });
      this.box.append(label);
    }
    this.key.setAttribute("aria-hidden", "true");
    this.box.append(this.key, this.amount, this.text);
    this.takePaper();
  }

  private choose(kind: string, wished: boolean): void {
    const names = [...this.chips.keys()].filter((name) => (name === kind ? wished : isWished(this.state.choice, name)));
    this.state.set({ kinds: names.length === this.chips.size ? "all" : names.join(",") });
  }

  /** Chooses colours that are visible on the page's paper, light or dark. */
  takePaper(): void {
    const isDark =
      Math.max(...rgbOf(getComputedStyle(document.documentElement).getPropertyValue("--paper").trim() || "#ffffff")) <
      0.5;
    for (const { name, colour } of kindsOf(this.data)) {
      this.colours.set(name, isDark && Math.max(...rgbOf(colour)) < 0.25 ? "#e8e8e4" : colour);
      this.chips.get(name)!.swatch.style.background = this.colours.get(name)!;
    }
  }

  /** Updates the arrows of all views, on one scale: the longest force of this time fills the room. */
  update(views: View[]): void {
    const { choice } = this.state;
    this.box.hidden = !choice.forces || views.length === 0;
    for (const [name, { box }] of this.chips) box.checked = isWished(choice, name);
    if (this.box.hidden) {
      for (const view of views) view.arrows.show([], 1);
      return;
    }
    const all = views.map((view) => new ForcesOfRun(view.run, choice, this.colours, view.size, view.centres));
    const longest = Math.max(...all.map((of) => of.longest)),
      room = Math.min(...all.map((of) => of.room)),
      seen = new Set<string>();
    this.perForce = longest > 0 ? room / longest : 0;
    views.forEach((view, i) => {
      const arrows = this.perForce > 0 ? all[i].arrows(this.perForce, (at) => view.isThere(new Vector3(...at))) : [];
      arrows.forEach((arrow) => seen.add(arrow.kind));
      view.arrows.show(arrows, (all[i].ofVertices ? 0.06 : 0.035) * room);
      view.draw();
    });
    for (const [name, { none }] of this.chips)
      none.textContent = isWished(choice, name) && !seen.has(name) ? "– none" : "";
    this.text.textContent = this.meaning(
      views,
      all.some((of) => of.ofVertices),
    );
    this.measure(views[0]);
  }

  private meaning(views: View[], ofVertices: boolean): string {
    const { choice } = this.state;
    if (!(this.perForce > 0)) return "There are no such forces at this time.";
    if (ofVertices) {
      const view = views.find((v) => cellWithVertexForces(v.run, choice) >= 0)!;
      return `Arrows: the forces on each vertex of ${view.run.byPath.get(choice.selected!)!.label}.`;
    }
    const shown = views.some((v) => v.run.hasVertexForces) ? "; at the last time a selected cell shows them on its vertices" : "";
    return `Arrows: the net force of each kind on a cell, from its middle. Springs and pressure of a closed cell add up to none${shown}.`;
  }

  /** Draws the key's arrow in the scale of this view. */
  measure(view: View | undefined): void {
    if (this.box.hidden || !view) return;
    const perPixel = view.eye.lengthPerPixel() / (this.perForce || 1),
      most = keyLength * perPixel; // [force]
    const power = 10 ** Math.floor(Math.log10(most)),
      force = [5, 2, 1].map((x) => x * power).find((x) => x <= most) ?? power;
    const shown = this.perForce > 0 && Number.isFinite(force),
      text = shown ? `${numberText(force)} [force]` : "",
      width = shown ? `${(force / perPixel).toFixed(1)}px` : "0";
    if (this.amount.textContent !== text) this.amount.textContent = text;
    if (this.key.style.width !== width) this.key.style.width = width;
    this.key.hidden = !shown;
  }
}
