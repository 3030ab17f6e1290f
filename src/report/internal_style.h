#pragma once

#include <string_view>

namespace smile::report {

/// Style sheet of pages, light and dark. Series of plots differ by color and by position. Contains
/// no letter that HTML would have to escape.
inline constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark;
  --back: #eef1f5; --card: #ffffff; --well: #f1f3f7; --text: #1b2330; --muted: #566176;
  --line: #d9dee7; --accent: #3f51c7; --accent-soft: #e6e9fb; --good: #1b7440;
  --good-soft: #e2f3e8; --bad: #b3261e; --bad-soft: #fbe9e7; --shade: rgb(20 30 50 / 8%);
  --s0: #3f51c7; --s1: #c2570c; --s2: #0f766e; --s3: #a21caf; --s4: #64740b; --s5: #0369a1; }
@media (prefers-color-scheme: dark) { :root {
  --back: #10141a; --card: #1a2029; --well: #141920; --text: #e7ebf2; --muted: #a5b0c1;
  --line: #2d3643; --accent: #a5b1ff; --accent-soft: #2a3157; --good: #7bd79b;
  --good-soft: #173424; --bad: #ff8a80; --bad-soft: #40201f; --shade: rgb(0 0 0 / 35%);
  --s0: #a5b1ff; --s1: #fdba74; --s2: #5eead4; --s3: #f0abfc; --s4: #d3e16b; --s5: #7dd3fc; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--text);
  font: 15px/1.5 system-ui, -apple-system, Segoe UI, Roboto, Noto Sans, Ubuntu, sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 32px 20px 64px; }
header { margin: 0 4px 24px; }
h1 { font-size: 30px; line-height: 1.2; letter-spacing: -0.01em; margin: 4px 0 10px; }
h2 { font-size: 17px; margin: 0 0 12px; }
h3 { font-size: 14px; margin: 20px 0 6px; }
p { margin: 0 0 10px; max-width: 46em; }
.eyebrow { color: var(--accent); font-weight: 600; font-size: 13px; margin: 0; }
.lead { font-size: 17px; color: var(--muted); }
.note { color: var(--muted); font-size: 13px; }
section { background: var(--card); border-radius: 14px; padding: 20px 22px; margin: 0 0 18px;
  box-shadow: 0 1px 2px var(--shade), 0 4px 16px var(--shade); min-width: 0; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr));
  gap: 18px; margin-bottom: 18px; }
.pair section { margin: 0; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 14px 22px;
  margin: 0; }
.facts div { min-width: 0; }
dt { color: var(--muted); font-size: 12.5px; }
dd { margin: 0; overflow-wrap: anywhere; }
.figure dd { font-size: 24px; font-weight: 650; font-variant-numeric: tabular-nums; }
.scroll { overflow-x: auto; margin: 0 -6px; }
.scroll + .scroll { margin-top: 22px; } .scroll + svg { margin-top: 20px; }
table { border-collapse: collapse; width: 100%; font-size: 14px;
  font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: 0 6px 8px; }
caption span { display: inline-block; position: sticky; left: 6px; color: var(--muted);
  font-size: 13px; max-width: min(60em, 100vw - 70px); }
th, td { padding: 6px 10px 6px 6px; text-align: left; vertical-align: top; white-space: nowrap;
  border-bottom: 1px solid var(--line); }
thead th { color: var(--muted); font-weight: 600; font-size: 12.5px; line-height: 1.3;
  vertical-align: bottom; white-space: normal; }
tbody th { white-space: normal; overflow-wrap: anywhere; min-width: 9em; }
tbody th.number { min-width: 3em; }
tbody tr:last-child th, tbody tr:last-child td { border-bottom: 0; }
.number { text-align: right; }
.wide { white-space: normal; min-width: 16em; overflow-wrap: anywhere; }
.good { color: var(--good); } .bad { color: var(--bad); }
.badge { display: inline-block; border-radius: 99px; padding: 1px 10px; font-size: 13px;
  font-weight: 600; }
.badge.good { background: var(--good-soft); } .badge.bad { background: var(--bad-soft); }
a { color: var(--accent); }
code { font: 12.5px/1.5 ui-monospace, DejaVu Sans Mono, monospace; background: var(--well);
  border-radius: 5px; padding: 1px 5px; overflow-wrap: anywhere; white-space: pre-wrap; }
pre { font: 12.5px/1.5 ui-monospace, DejaVu Sans Mono, monospace; background: var(--well);
  border-radius: 8px; padding: 10px 12px; margin: 0 0 10px; white-space: pre-wrap;
  overflow-wrap: anywhere; }
figure { margin: 0; min-width: 0; }
figcaption { color: var(--muted); font-size: 13px; margin-top: 4px; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 220px), 1fr));
  gap: 14px; }
img { display: block; width: 100%; height: auto; border-radius: 8px; background: #000; }
svg { display: block; width: 100%; max-width: 560px; height: auto; }
svg text { font-size: 11px; fill: var(--muted); font-family: inherit; }
svg .name { fill: var(--text); font-weight: 600; } svg .value { fill: var(--text); }
svg .end { text-anchor: end; } svg .middle { text-anchor: middle; }
.rule { stroke: var(--line); stroke-width: 1; } .axis { stroke: var(--muted); stroke-width: 1; }
.track { fill: var(--well); } .whisker { stroke: var(--text); stroke-width: 1.5; }
.halo { stroke: var(--card); stroke-width: 4; stroke-linecap: round; stroke-opacity: 0.8; }
.wanted { fill: none; stroke: var(--text); stroke-width: 1.3; stroke-dasharray: 3 2.5; }
.reached { fill-opacity: 0.75; stroke: var(--text); stroke-width: 0.6; stroke-opacity: 0.55; }
.s0 { --c: var(--s0); } .s1 { --c: var(--s1); } .s2 { --c: var(--s2); }
.s3 { --c: var(--s3); } .s4 { --c: var(--s4); } .s5 { --c: var(--s5); }
.fill { fill: var(--c); } .dot { fill: var(--c); fill-opacity: 0.6; }
.chip { display: inline-block; width: 10px; height: 10px; border-radius: 3px;
  background: var(--c); margin-right: 7px; }
.yes { fill: var(--good); fill-opacity: 0.8; } .no { fill: var(--bad); }
.limit { stroke: var(--text); stroke-width: 1.2; stroke-dasharray: 4 3; }
.subtask { fill: var(--accent-soft); stroke: var(--accent); } .redundant { stroke-dasharray: 4 3; }
.edge { fill: none; stroke: var(--muted); stroke-width: 1.4; }
.legend { white-space: pre-wrap; margin-top: 4px; }
.told { columns: 2 380px; column-gap: 34px; font-size: 14px; }
.told h3 { margin: 0 0 2px; break-after: avoid; } .told ul { margin: 0 0 10px; padding-left: 18px; }
.actions { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 320px), 1fr));
  gap: 22px 18px; }
.actions.plan { grid-template-columns: minmax(0, 1fr) minmax(0, 2fr); }
.plan ol { margin: 0; font-size: 14px; columns: 2 200px; }
.actions h3 { margin: 10px 0 4px; } .actions p { margin: 4px 0; font-size: 13px; }
.seen { position: relative; }
.seen svg { position: absolute; inset: 0; width: 100%; height: 100%; max-width: none; }
.seen polygon { fill: none; stroke-linejoin: round; vector-effect: non-scaling-stroke; }
.expected { stroke: #8a2be2; stroke-width: 2.5; } .found { stroke: #111111; stroke-width: 1.4; }
.expected.moved { stroke-width: 5; } .expected.unseen { stroke-dasharray: 3 3; }
.expected.bad { stroke: #ff2bd6; stroke-width: 5; }
.line { display: inline-block; width: 22px; height: 0; margin-right: 7px; vertical-align: middle;
  border-top: 2.5px solid #8a2be2; }
.line.found { border-top: 1.4px solid var(--text); } .line.bad { border-top: 5px solid #ff2bd6; }
.line.unseen { border-top-style: dashed; }
.cross { stroke: var(--card); stroke-width: 1.6; }
footer { color: var(--muted); font-size: 13px; margin: 22px 4px 0; }
@media (max-width: 560px) { main { padding: 18px 10px 40px; } section { padding: 16px 14px; }
  h1 { font-size: 24px; } }
@media print { body { background: none; } section { box-shadow: none;
  border: 1px solid var(--line); break-inside: avoid; } }
)";
static_assert(kStyle.find_first_of("&<>\"'") == std::string_view::npos);

}  // namespace smile::report
