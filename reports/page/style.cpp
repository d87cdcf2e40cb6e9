// The style sheet of pages: for screens, light or dark, wide or narrow, and for paper.
#include "page/page.h"

namespace morula {

const char* pageStyle() {
  return R"css(:root {
  --paper: #fafaf8; --ink: #1b1f24; --quiet: #565d65; --line: #d9d9d4; --panel: #ffffff; --accent: #0b62b5;
  --good: #17713a; --bad: #b3201a; --warn: #8a5a00; --good-back: #e6f4ea; --bad-back: #fdeae8; --warn-back: #fff3d9;
  color-scheme: light dark;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14171a; --ink: #e8e8e4; --quiet: #a5adb5; --line: #363c42; --panel: #1c2024; --accent: #74b3f2;
    --good: #7ed69b; --bad: #ff9d95; --warn: #f2c266; --good-back: #16301f; --bad-back: #3a1d1b; --warn-back: #352a12;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 "DejaVu Sans", system-ui, sans-serif; }
header, main, footer { max-width: 1280px; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 1.5rem; } footer { padding-bottom: 1.5rem; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 0 0 .7rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 .5rem; overflow-wrap: anywhere; }
p { margin: .4rem 0; max-width: 75ch; overflow-wrap: anywhere; }
a { color: var(--accent); }
.summary { color: var(--quiet); }
section { margin: 1.1rem 0; padding: 1rem 1.1rem; background: var(--panel); border: 1px solid var(--line); border-radius: 8px; }
#verdict { border-left: 6px solid var(--line); }
#verdict:has(.good) { border-left-color: var(--good); }
#verdict:has(.warn) { border-left-color: var(--warn); }
#verdict:has(.bad) { border-left-color: var(--bad); }
.said { font-size: 1.05rem; font-weight: bold; }
ul.findings { list-style: none; margin: .5rem 0 0; padding: 0; }
ul.findings > li { margin: .3rem 0; padding: .35rem .6rem; border-radius: 5px; overflow-wrap: anywhere; }
li.good { background: var(--good-back); } li.bad { background: var(--bad-back); } li.warn { background: var(--warn-back); }
ul.why { margin: .2rem 0 0; padding-left: 1.3rem; font-size: .88rem; }
.mark { font-weight: bold; margin-right: .4rem; }
td .mark { white-space: nowrap; }
.pictures img { max-height: 34rem; }
.mark.good, td.good { color: var(--good); } .mark.bad, td.bad { color: var(--bad); } .mark.warn { color: var(--warn); }
.wide { overflow-x: auto; max-width: 100%; } .wide > table { width: max-content; max-width: max(100%, 46rem); }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
caption { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
th, td { text-align: left; vertical-align: top; padding: .25rem .7rem .25rem 0; border-bottom: 1px solid var(--line); }
thead th { color: var(--quiet); font-weight: normal; white-space: nowrap; }
tbody th { font-weight: normal; }
td { overflow-wrap: break-word; max-width: 34rem; } .long, td code { overflow-wrap: anywhere; }
@media (max-width: 30rem) { td { max-width: 10rem; } }
.long { display: inline-block; min-width: 10rem; } td code { display: inline-block; min-width: 8rem; }
td.number, .whole { white-space: nowrap; overflow-wrap: normal; }
tr.differs td { background: var(--warn-back); }
pre { margin: .4rem 0; padding: .6rem .7rem; overflow: auto; max-height: 26rem; background: var(--paper); border: 1px solid var(--line);
  border-radius: 5px; font: .8rem/1.45 "DejaVu Sans Mono", monospace; white-space: pre-wrap; overflow-wrap: anywhere; }
code { font: .85em "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
.again { margin-top: .8rem; color: var(--quiet); font-size: .82rem; }
.again code { display: block; margin-top: .15rem; padding: .25rem .5rem; background: var(--paper); border-radius: 4px; user-select: all; }
.pictures, .charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); gap: 1rem; }
.double { grid-column: span 2; }
.pictures { margin: .6rem 0; grid-template-columns: repeat(auto-fill, minmax(min(100%, 27rem), 1fr)); }
.key { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; margin: 0 0 .7rem; padding: 0; font-size: .85rem; }
.key i { display: inline-block; width: 1.8rem; margin-right: .35rem; vertical-align: .25em; border-top: 3px solid; } .key i.dashed { border-top-style: dashed; }
.large { overflow-x: auto; } #verdict h2 + .said { margin-top: 0; } #verdict h2 { margin: 1rem 0 .3rem; } #verdict h2:first-child { margin-top: 0; }
figure { margin: 0; min-width: 0; } figure img { display: block; max-width: 100%; height: auto; border-radius: 6px; background: #fafaf8; }
figcaption { color: var(--quiet); font-size: .85rem; margin-top: .25rem; overflow-wrap: anywhere; }
details { margin: .4rem 0; } summary { cursor: pointer; color: var(--accent); overflow-wrap: anywhere; }
.note { color: var(--quiet); font-size: .88rem; }
.downloads a { display: inline-block; margin: 0 1.2rem .3rem 0; }
button, select, input { font: inherit; color: inherit; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
.tools { display: flex; flex-wrap: wrap; gap: .35rem .9rem; align-items: center; margin-bottom: .6rem; font-size: .85rem; }
.tools label { display: inline-flex; gap: .3rem; align-items: center; max-width: 100%; }
.tools select { min-width: 0; max-width: 100%; }
[hidden] { display: none !important; }
.tools select, .tools button, #play, .links button { background: var(--paper); border: 1px solid var(--line); border-radius: 5px; padding: .15rem .5rem; cursor: pointer; }
.tools input[type=range] { width: 6.5rem; accent-color: var(--accent); }
.panes { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: .8rem; }
.views { display: grid; grid-auto-flow: column; grid-auto-columns: minmax(0, 1fr); gap: .4rem; min-width: 0; }
.view { position: relative; min-width: 0; height: 30rem; border: 1px solid var(--line); overflow: hidden; background: var(--paper); }
.view canvas { display: block; touch-action: none; }
.view .caption { position: absolute; left: .5rem; top: .35rem; right: .5rem; font-size: .8rem; pointer-events: none; overflow-wrap: anywhere; }
.view .scale { position: absolute; left: .6rem; bottom: .5rem; font-size: .75rem; pointer-events: none; border-bottom: 2px solid currentColor; text-align: center; }
.names { position: absolute; inset: 0; overflow: hidden; pointer-events: none; font-size: .72rem; }
.names span { position: absolute; transform: translate(-50%, -50%); padding: 0 .2rem; border-radius: 3px; color: #1b1f24; background: #fafaf8cc; }
figure .live, .measured .live { background: #fafaf8; color: #1b1f24; border-radius: 6px; padding: .4rem .3rem .1rem; }
.live .note { color: #565d65; margin: 0 .4rem; min-height: 1.4em; font-variant-numeric: tabular-nums; }
.view > img { width: 100%; height: 100%; object-fit: contain; }
.bar { display: flex; align-items: center; gap: .4rem; font-size: .8rem; margin: .4rem 0; min-height: 1.3rem; flex-wrap: wrap; }
.bar .ramp { width: 10rem; height: .8rem; border-radius: 3px; }
.bar .chip { display: inline-flex; align-items: center; gap: .25rem; margin-right: .5rem; }
.bar .chip i { width: .8rem; height: .8rem; border-radius: 3px; border: 1px solid var(--line); }
.forces label { cursor: pointer; } .forces .note { font-size: inherit; }
.forces .arrow { position: relative; height: 2px; background: currentColor; margin-right: .3rem; }
.forces .arrow::after { content: ""; position: absolute; right: -2px; top: -3px; border-left: 8px solid currentColor; border-top: 4px solid transparent; border-bottom: 4px solid transparent; }
.tree { position: relative; height: 30rem; overflow: auto; border: 1px solid var(--line); border-radius: 6px; background: var(--paper); }
.tree svg { display: block; }
.tree text { font: 11px "DejaVu Sans", sans-serif; fill: var(--ink); }
.tree .axis text { fill: var(--quiet); font-size: 10px; }
.tree .axis line { stroke: var(--line); }
.tree .now { stroke: var(--accent); stroke-width: 1; stroke-dasharray: 3 2; }
.tree [data-path] { cursor: pointer; outline: none; }
.tree [data-path] .hit { stroke: transparent; fill: none; }
.tree [data-path] .life { fill: none; stroke-width: 3; }
.tree [data-path] .fork { fill: none; stroke: var(--quiet); stroke-width: 1; }
.tree [data-path].dim { opacity: .22; }
.tree [data-path].unborn .life { stroke-opacity: .35; }
.tree [data-path].selected .life { stroke-width: 6; }
.tree [data-path].selected text { font-weight: bold; }
.tree [data-path]:hover .life, .tree [data-path].hover .life { stroke-width: 6; }
.tree [data-path]:focus-visible .hit { stroke: var(--accent); stroke-opacity: .45; }
.clock { display: grid; grid-template-columns: auto minmax(0, 1fr) auto; gap: .6rem; align-items: center; margin-top: .7rem; }
.clock .slide { position: relative; }
#time { width: 100%; margin: 0; accent-color: var(--accent); }
.clock svg { display: block; width: 100%; height: 9px; }
.clock svg line { stroke: var(--quiet); stroke-width: 1; vector-effect: non-scaling-stroke; }
.clock output { font-size: .85rem; font-variant-numeric: tabular-nums; min-width: 9.5rem; }
#info { margin-top: .7rem; min-height: 6rem; font-size: .88rem; }
#info h3 { margin: 0 0 .3rem; }
#info table { margin: .3rem 0; }
.links { display: flex; flex-wrap: wrap; gap: .3rem; margin: .3rem 0; align-items: center; }
.links button { font-size: .82rem; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); gap: .3rem 1.5rem; }
.tip { position: absolute; z-index: 5; pointer-events: none; padding: .1rem .45rem; border-radius: 4px; background: var(--ink); color: var(--paper);
  font-size: .8rem; white-space: nowrap; max-width: 20rem; overflow: hidden; text-overflow: ellipsis; }
.tip[hidden] { display: none; }
.swipe { position: relative; display: block; max-width: 40rem; margin-bottom: 1rem; }
.swipe img { display: block; width: 100%; border-radius: 6px; background: #fafaf8; }
.swipe img.over { position: absolute; inset: 0; }
@media screen { .alive img { display: none; } }
@media (max-width: 760px) {
  table { font-size: .8rem; } th, td { padding-right: .45rem; } thead th { white-space: normal; }
  header, main, footer { padding: 0 .6rem; } .large img { max-width: none; width: 52rem; } .double { grid-column: auto; } section { padding: .8rem .7rem; }
  .panes { grid-template-columns: minmax(0, 1fr); } .view { height: 21rem; } .tree { height: 20rem; }
  .clock { grid-template-columns: auto minmax(0, 1fr); } .clock output { grid-column: 1 / -1; }
}
@media (prefers-reduced-motion: reduce) { * { transition: none; } }
@page { margin: 14mm; }
@media print {
  :root { --paper: #fff; --ink: #000; --quiet: #444; --line: #bbb; --panel: #fff; --good: #17713a; --bad: #b3201a; --warn: #8a5a00;
    --good-back: #fff; --bad-back: #fff; --warn-back: #fff; }
  body { font-size: 10pt; } header, main, footer { max-width: none; padding: 0; }
  section { border: 0; padding: 0; margin: .8rem 0; } #verdict { padding-left: .6rem; }
  .wide, .large { overflow: visible; } thead th { white-space: normal; } .wide > table { width: auto; max-width: 100%; font-size: 7pt; } th, td { padding-right: 5pt; }
  #appendix { break-before: page; } figure .live, .names { display: none; }
  td.number { overflow-wrap: normal; } td code { min-width: 0; }
  .long { min-width: 0; } .compare { display: none; }
  .tools, .views, .clock, .tip, .downloads, .swipe-tools, #explorer .bar, #info { display: none !important; }
  .panes { display: block; } .tree { height: auto; overflow: visible; border: 0; } pre { max-height: none; }
  h2, h3 { break-after: avoid; } figure, tr, li { break-inside: avoid; } figure img { max-height: 22cm; width: auto; }
  .pictures, .charts { grid-template-columns: 1fr 1fr; }
}
)css";
}

}  // namespace morula
