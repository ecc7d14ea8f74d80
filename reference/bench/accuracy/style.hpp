#pragma once

namespace umbral::bench {

/// The page's CSS. Colours of series: M. Okabe, K. Ito. Color Universal Design. 2008; on dark ground the lighter ones
/// of them.
inline constexpr const char* style_sheet = R"css(
:root { --ground: #fcfcfa; --card: #fff; --ink: #1d2126; --soft: #5b6470; --grid: #e3e5e8; --minor: #f1f2f4;
  --edge: #d9dce0; --tip: #1d2126; --tip-ink: #fff;
  --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #b05c8e; --c4: #c98600; --c5: #3a3f46; --knee: #d55e00;
  --knee-ground: #fdf1e8; }
@media (prefers-color-scheme: dark) { :root { --ground: #14171b; --card: #1b1f24; --ink: #e8eaed; --soft: #a0a8b3;
  --grid: #333941; --minor: #262b31; --edge: #333941;
  --tip: #e8eaed; --tip-ink: #14171b; --c0: #56b4e9; --c1: #ee8a3d; --c2: #2bc59a; --c3: #dd94bb; --c4: #f0c03a;
  --c5: #d5d9de; --knee: #ee8a3d; --knee-ground: #33261b; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: .8rem 1.25rem 3rem; max-width: 66rem; background: var(--ground); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 2.1rem; line-height: 1.15; margin: 0 0 1.2rem; letter-spacing: -0.02em; }
h2 { font-size: 1.45rem; line-height: 1.2; margin: 0 0 .5rem; letter-spacing: -0.01em; }
p { max-width: 46rem; }
a { color: var(--c0); text-decoration-thickness: 1px; text-underline-offset: 3px; }
.umbral { margin: 0; color: var(--soft); font-size: .8rem; letter-spacing: .14em; text-transform: uppercase; }
header { width: min(1260px, 100vw - 1.5rem); margin-left: calc(50% - min(1260px, 100vw - 1.5rem) / 2); }
header h1 { font-size: 1.5rem; margin: 0 0 .2rem; }
.legend { margin: 0 0 .5rem; max-width: none; font-size: .8rem; line-height: 1.35; color: var(--soft); }
.overview { display: grid; gap: 7px; grid-template-columns: repeat(auto-fill, minmax(190px, 1fr)); }
.card { display: flex; flex-direction: column; background: var(--card); border: 1px solid var(--edge);
  border-radius: 7px; padding: 5px 8px 5px; color: var(--ink); text-decoration: none; font-size: 11px;
  line-height: 1.3; min-width: 0; }
.card:hover, .card:focus { border-color: var(--c0); outline: 1px solid var(--c0); }
.card b { font-size: 11.5px; white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.card svg { display: block; width: 100%; height: auto; margin: 2px 0; background: var(--ground);
  border-radius: 4px; }
.card svg .line { fill: none; stroke-width: 1.6; }
.card svg .mark { stroke-width: .8; }
.knee-line, .slope { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; min-height: 1.3em; }
.knee-line { color: var(--knee); font-weight: 600; }
.knee-line.none { color: var(--soft); font-weight: 400; }
.slope { color: var(--soft); font-variant-numeric: tabular-nums; }
.slope.differs, .laws .differs { color: var(--c3); }
.laws { margin: 1rem 0 0; padding-left: 1.1rem; font-size: .92rem; }
.up { margin: 0; font-size: .85rem; }
footer, figcaption, .note { color: var(--soft); }
details { max-width: 46rem; margin-top: .8rem; } summary { cursor: pointer; color: var(--soft); }
dl { margin: .6rem 0 0; display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1rem; }
dt { font-weight: 600; } dd { margin: 0; }
.settings { font-size: .9rem; }
section { margin-top: 3rem; }
figure { margin: 1rem 0 0; background: var(--card); border: 1px solid var(--edge); border-radius: 10px;
  padding: 1rem 1rem .8rem; }
figcaption { font-size: .9rem; } figcaption ul { margin: .4rem 0 0; padding-left: 1.1rem; }
.more { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); margin-top: 1rem; }
.more figure { margin: 0; }
.plot { display: block; width: 100%; height: auto; overflow: visible; }
.plot text { font-size: 12px; fill: var(--soft); }
.plot .label, .plot .series { paint-order: stroke; stroke: var(--card); stroke-width: 3px; stroke-linejoin: round; }
.plot .name { font-size: 13px; fill: var(--ink); }
.plot .axis text { font-variant-numeric: tabular-nums; }
.grid path { fill: none; } .major { stroke: var(--grid); } .minor { stroke: var(--minor); }
.zero { stroke: var(--soft); stroke-dasharray: 2 4; }
.s0 { color: var(--c0); } .s1 { color: var(--c1); } .s2 { color: var(--c2); } .s3 { color: var(--c3); }
.s4 { color: var(--c4); } .s5 { color: var(--c5); }
.line { fill: none; stroke: currentColor; stroke-width: 2; stroke-linejoin: round; opacity: .75; }
.mark { fill: currentColor; stroke: var(--card); stroke-width: 1.2; } .mark.quiet { opacity: .3; }
.ring { fill: none; stroke: var(--knee); stroke-width: 2; }
.plot .series { fill: var(--ink); font-weight: 600; } .plot .label.knee { fill: var(--ink); font-weight: 700; }
.words { pointer-events: none; } .hit { fill: transparent; } .target { outline: none; }
.target:hover .hit, .target:focus .hit { fill: none; stroke: var(--ink); stroke-width: 1.5; }
.tip { visibility: hidden; pointer-events: none; } .target:hover .tip, .target:focus .tip { visibility: visible; }
.tip rect { fill: var(--tip); } .plot .tip text { fill: var(--tip-ink); font-size: 12px; }
.plot .tip .first { font-weight: 700; }
.scroll { overflow-x: auto; margin-top: 1.2rem; }
table { border-collapse: collapse; width: 100%; font-size: .88rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: .4rem; }
th, td { padding: .28rem .7rem; border-bottom: 1px solid var(--edge); text-align: right; }
thead th { vertical-align: bottom; color: var(--soft); font-weight: 500; line-height: 1.25; }
th:first-child { text-align: left; } tbody th { font-weight: 500; white-space: nowrap; }
.situation th { padding-top: .9rem; font-weight: 700; }
tr.quiet td, tr.quiet th { color: var(--soft); } tr.knee { background: var(--knee-ground); }
tr.knee .word, tr.knee th { font-weight: 700; }
.word { text-align: left; }
footer { margin-top: 3rem; padding-top: 1rem; border-top: 1px solid var(--edge); font-size: .82rem; }
@media print { body { max-width: none; } figure, tr { break-inside: avoid; } }
)css";

}
