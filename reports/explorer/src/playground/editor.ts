// A text editor with coloured syntax, marks at wrong lines, and the schema's help for the key at the caret.
import { element } from "../tools";

const parts = [
  /(#.*)/, // comment
  /("(?:[^"\\]|\\.)*"|'(?:[^']|'')*')/, // string
  /(^\s*(?:- )?[A-Za-z_*][\w*-]*|(?<=[{,]\s*)[A-Za-z_*][\w*-]*)(?=\s*:)/, // key
  /(?<![\w.])([-+]?\d[\d_.]*(?:e[-+]?\d+)?)(?![\w.])/, // number
];
const token = new RegExp(parts.map((part) => part.source).join("|"), "gim");
const kinds = ["y-comment", "y-string", "y-key", "y-number"];

export class Editor {
  readonly box = element("div", "editor");
  readonly text = element("textarea");
  onChange: () => void = () => {};
  onCaret: () => void = () => {};
  private readonly shown = element("pre");
  private wrong = new Set<number>();

  constructor(id: string, label: string) {
    this.text.id = id;
    this.text.spellcheck = false;
    this.text.wrap = "off";
    this.text.setAttribute("aria-label", label);
    this.shown.setAttribute("aria-hidden", "true");
    this.box.append(this.shown, this.text);
    this.text.addEventListener("input", () => {
      this.show();
      this.onChange();
    });
    this.text.addEventListener("scroll", () => {
      this.shown.scrollTop = this.text.scrollTop;
      this.shown.scrollLeft = this.text.scrollLeft;
    });
    for (const event of ["keyup", "click", "focus"]) this.text.addEventListener(event, () => this.onCaret());
  }

  get value(): string {
    return this.text.value;
  }
  set value(text: string) {
    this.text.value = text;
    this.wrong.clear();
    this.show();
  }

  mark(lines: Set<number>): void {
    this.wrong = lines;
    this.show();
  }

  goTo(line: number, column: number): void {
    const before = this.value.split("\n").slice(0, line - 1),
      at = before.reduce((sum, l) => sum + l.length + 1, 0) + column - 1;
    this.text.focus();
    this.text.setSelectionRange(at, at);
    this.text.scrollTop = Math.max(0, (line - 5) * parseFloat(getComputedStyle(this.text).lineHeight));
    this.onCaret();
  }

  private show(): void {
    this.shown.replaceChildren(
      ...this.value.split("\n").map((line, i) => {
        const row = element("span", this.wrong.has(i + 1) ? "line wrong" : "line");
        let from = 0;
        for (const found of line.matchAll(token)) {
          row.append(
            line.slice(from, found.index),
            element("span", kinds[[1, 2, 3, 4].findIndex((k) => found[k] !== undefined)], found[0]),
          );
          from = found.index! + found[0].length;
        }
        row.append(line.slice(from) + "\n");
        return row;
      }),
    );
  }

  /** Returns the path of keys at the caret, outermost first: keys by indentation, then the key in an open flow map. */
  path(): string[] {
    const before = this.value.slice(0, this.text.selectionStart),
      rows = before.split("\n"),
      last = rows.length - 1;
    rows[last] = this.value.split("\n")[last];
    const keys: string[] = [];
    let indent = Infinity;
    for (let i = last; i >= 0; --i) {
      const found = /^(\s*(?:- )?)([\w*-]+)\s*:/.exec(rows[i]);
      if (!found || found[1].length >= indent) continue;
      indent = found[1].length;
      keys.unshift(found[2]);
    }
    const word = /^[\w-]*\s*:?/.exec(this.value.slice(this.text.selectionStart))![0]; // the caret may stand in a key
    const inside = before.slice(before.lastIndexOf("\n") + 1) + word,
      open = inside.lastIndexOf("{");
    const inner = open > inside.lastIndexOf("}") ? /(?:^|,)\s*([\w-]+)\s*:[^,]*$/.exec(inside.slice(open + 1)) : null;
    return inner ? [...keys, inner[1]] : keys;
  }
}

/** Returns the schema's description of a key; "" if there is none. */
export function helpAt(schema: any, path: string[]): string {
  let at = schema,
    text = "";
  for (const key of path) {
    const parts = [at, ...(at?.oneOf ?? []), ...(at?.anyOf ?? [])].map((one) => (one?.items ? one.items : one));
    at = parts
      .map(
        (one) =>
          one?.properties?.[key] ??
          (typeof one?.additionalProperties === "object" ? one.additionalProperties : undefined),
      )
      .find((one) => one);
    if (!at) break;
    if (at.description)
      text =
        `${path.slice(0, path.indexOf(key) + 1).join(".")}: ${at.description}` +
        `${at.default !== undefined ? ` [${JSON.stringify(at.default)}]` : ""}`;
  }
  return text;
}
