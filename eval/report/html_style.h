#pragma once

namespace honka::eval {

/// The style sheet of report.html: readable on a phone, prints on A4.
inline constexpr const char* kHtmlStyle = R"css(
:root { --ink: #1d2521; --soft: #5c6862; --line: #d9dfdb; --leaf: #1f6b4a; --tint: #f3f7f4;
        --note: #fff7e3; --note-line: #e2b64d; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 68rem; padding: 2rem 1.25rem 4rem; color: var(--ink);
       font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", Roboto, sans-serif;
       background: #fff; }
header { border-bottom: 3px solid var(--leaf); margin-bottom: 1.5rem; padding-bottom: .75rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.35rem; margin: 2.6rem 0 .8rem; color: var(--leaf); }
h3 { font-size: 1.08rem; margin: 1.8rem 0 .2rem; }
p { margin: .4rem 0 .8rem; }
.question { font-size: 1.1rem; color: var(--soft); margin: 0; }
.lead { background: var(--note); border-left: 5px solid var(--note-line); margin: 1rem 0;
        padding: .7rem 1rem; border-radius: 0 6px 6px 0; }
.lead ul { margin: 0; padding-left: 1.1rem; }
.protocol, figcaption, .notes { color: var(--soft); font-size: .9rem; }
.protocol { margin: 0 0 .5rem; }
.scroll { overflow-x: auto; margin: .4rem 0; -webkit-overflow-scrolling: touch; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem;
        min-width: 100%; }
th, td { padding: .38rem .6rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: #fff; }
thead th { vertical-align: bottom; font-weight: 600; }
thead tr:last-child th { border-bottom: 2px solid var(--ink); }
thead .group { border-bottom: 1px solid var(--line); text-align: center; }
.unit { display: block; font-weight: 400; color: var(--soft); font-size: .82em; }
tbody td { border-bottom: 1px solid var(--line); }
tbody tr:hover td { background: var(--tint); }
th.sentence, td.sentence { text-align: left; white-space: normal; min-width: 20rem;
                           overflow-wrap: anywhere; }
td.paper { color: var(--soft); }
td.ours { font-weight: 600; }
td.diff { color: var(--soft); font-size: .9em; }
.first { border-left: 1px solid var(--line); }
figure { margin: 1.6rem 0 2.2rem; break-inside: avoid; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto;
             border: 1px solid var(--line); border-radius: 6px; background: #fff; }
figcaption { margin-top: .5rem; }
.notice { border: 1px dashed var(--note-line); background: var(--note); padding: 1rem;
          border-radius: 6px; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: 0;
     font-size: .92rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
code, pre { font: .87rem/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { background: var(--tint); border: 1px solid var(--line); border-radius: 6px; padding: .8rem;
      overflow-x: auto; }
summary { cursor: pointer; font-weight: 600; color: var(--leaf); }
@media (max-width: 40rem) { body { padding: 1rem .8rem 3rem; font-size: 15px; }
  h1 { font-size: 1.5rem; } dl { grid-template-columns: 1fr; } dt { margin-top: .4rem; } }
@media print { body { max-width: none; padding: 0; font-size: 10pt; }
  .scroll { overflow: visible; } table { font-size: 8.5pt; } th, td { padding: .2rem .35rem; }
  h2, h3 { break-after: avoid; } details > *:not(summary) { display: block; } }
)css";

}  // namespace honka::eval
