// The style of the playground, in addition to that of all pages.
export const style = `
.editors { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: .6rem; }
.editor { position: relative; height: 26rem; border: 1px solid var(--line); border-radius: 6px;
  background: var(--paper); overflow: hidden; }
.editor pre, .editor textarea { position: absolute; inset: 0; margin: 0; padding: .6rem .7rem; border: 0;
  width: 100%; height: 100%; overflow: auto; max-height: none;
  font: .82rem/1.45 "DejaVu Sans Mono", monospace; white-space: pre; tab-size: 2; background: none; resize: none;
  letter-spacing: 0; overflow-wrap: normal; }
.editor textarea { color: transparent; caret-color: var(--ink); }
.editor textarea::selection { background: color-mix(in srgb, var(--accent) 30%, transparent); }
.editor pre { pointer-events: none; overflow: hidden; color: var(--ink); }
.editor .line { display: block; min-width: max-content; }
.editor .wrong { background: var(--bad-back); }
.y-comment { color: var(--quiet); }
.y-key { color: var(--accent); }
.y-string { color: var(--good); }
.y-number { color: var(--warn); }
#messages { list-style: none; margin: .5rem 0; padding: 0; max-height: 14rem; overflow: auto; }
#messages button { background: none; border: 0; padding: 0; text-align: left; cursor: pointer;
  overflow-wrap: anywhere; }
.tools a { margin-right: .6rem; }
.measured select { background: var(--paper); border: 1px solid var(--line); border-radius: 5px; padding: .15rem .5rem; }
`;
