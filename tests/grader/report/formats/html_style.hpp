// The look of both pages: light and dark, wide and narrow, on screen and paper. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

namespace grader {

inline constexpr const char* pageStyle = R"css(
:root{color-scheme:light dark;--paper:#f4f5f7;--card:#fff;--ink:#1b1f27;--soft:#565e6c;--line:#e0e3e9;--track:#e6e9ee;
--accent:#2b5fc4;--pass:#17734a;--partial:#8a5a00;--fail:#b3261e;--skipped:#59616e;--pass-b:#e3f4ea;--partial-b:#fdf0d3;--fail-b:#fce7e5;
--skipped-b:#eceef2;--note:#eef3fc}
@media(prefers-color-scheme:dark){:root{--paper:#13161b;--card:#1c2027;--ink:#e7eaf0;--soft:#a3acba;--line:#303641;--track:#323945;
--accent:#8fb4ff;--pass:#67d69c;--partial:#f2bd55;--fail:#ff958c;--skipped:#aab3c0;--pass-b:#17352a;--partial-b:#3a2e12;--fail-b:#40201f;
--skipped-b:#2a2f38;--note:#1f2a40}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,"DejaVu Sans",sans-serif;
-webkit-text-size-adjust:100%}
main{max-width:56rem;margin:0 auto;padding:2rem 1.25rem 4rem}
main.wide{max-width:76rem}
h1,h2,h3{line-height:1.25;margin:0;font-weight:650;overflow-wrap:anywhere}
h1{font-size:1.7rem;letter-spacing:-.015em}
h2{font-size:1.15rem}
h3{font-size:.78rem;letter-spacing:.06em;text-transform:uppercase;color:var(--soft);margin:1.4rem 0 .5rem}
p{margin:.5rem 0;overflow-wrap:anywhere}
a{color:var(--accent)}
.eyebrow{color:var(--soft);font-size:.9rem;margin:0 0 .25rem;overflow-wrap:anywhere}
.soft{color:var(--soft)}
.small{font-size:.88rem}
.card{background:var(--card);border:1px solid var(--line);border-radius:14px;padding:1.25rem 1.4rem;margin:1rem 0}
.top{display:flex;gap:1.5rem;align-items:center;padding:1.6rem 1.6rem}
.top>div{min-width:0}
.ring{flex:none;width:116px;height:116px}
.ring text{fill:var(--ink);font-weight:650;text-anchor:middle}
.verdict{font-size:1.1rem;margin:.6rem 0 0}
.notice{border-left:5px solid var(--partial)}
.list{list-style:none;margin:0;padding:.4rem 0}
.list li+li{border-top:1px solid var(--line)}
.list .row{display:flex;gap:.8rem;align-items:baseline;padding:.55rem 1.1rem}
.list .name{flex:1;min-width:0;overflow-wrap:anywhere}.list .name small{display:block;color:var(--soft);font-size:.86rem}
.num{font-variant-numeric:tabular-nums;white-space:nowrap}
.pill{display:inline-flex;gap:.4em;align-items:center;border-radius:99px;padding:.12rem .7rem;font-size:.84rem;font-weight:600;white-space:nowrap}
.list .pill{min-width:7.2rem;justify-content:flex-start}
.pass{color:var(--pass);background:var(--pass-b)}.partial{color:var(--partial);background:var(--partial-b)}
.fail{color:var(--fail);background:var(--fail-b)}.skipped{color:var(--skipped);background:var(--skipped-b)}
.check{border-left:5px solid var(--line);scroll-margin-top:1rem}
.check.is-pass{border-left-color:var(--pass)}.check.is-partial{border-left-color:var(--partial)}.check.is-fail{border-left-color:var(--fail)}
.check header{display:flex;flex-wrap:wrap;gap:.4rem .9rem;align-items:center}
.check h2{flex:1;min-width:0}
.check .message{font-size:1.06rem;margin:.75rem 0 0}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.35rem 1.1rem;margin:.9rem 0 0}
dt{color:var(--soft);font-size:.92rem}dd{margin:0;min-width:0;overflow-wrap:anywhere}
.chip{display:inline-block;border:1px solid var(--line);border-radius:7px;padding:0 .5rem;margin:0 .3rem .2rem 0;font-size:.88rem}
.why{background:var(--note);border-radius:11px;padding:.95rem 1.15rem;margin:1.1rem 0 0}
.why h3{margin:0 0 .25rem}
.why .name{font-weight:600;font-size:1.04rem;margin:0}
.bar{display:block;height:.55rem;border-radius:99px;background:var(--track);overflow:hidden;min-width:4rem;-webkit-print-color-adjust:exact;print-color-adjust:exact}
.bar i{display:block;height:100%;border-radius:99px;background:var(--accent)}
.measure{display:grid;grid-template-columns:minmax(6rem,14rem) auto;gap:.8rem;align-items:center;margin:.55rem 0}
.pictures{display:grid;grid-template-columns:repeat(3,minmax(0,1fr));gap:.9rem;margin:.2rem 0 0}
figure{margin:0}figure img{display:block;width:100%;height:auto;border-radius:9px;background:#000;border:1px solid var(--line);image-rendering:pixelated}
figcaption{font-size:.86rem;color:var(--soft);margin-top:.4rem;overflow-wrap:anywhere}
figcaption b{color:var(--ink);display:block;font-weight:600}
table{border-collapse:collapse;width:100%;font-size:.93rem}
th,td{text-align:left;padding:.38rem .8rem .38rem 0;border-bottom:1px solid var(--line);vertical-align:middle;overflow-wrap:anywhere}
th{font-weight:600}thead th{color:var(--soft);font-size:.84rem}
tbody tr:last-child>*{border-bottom:0}
td.value,th.symbol{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:.88rem;font-weight:400}
.two{display:grid;grid-template-columns:1fr 1fr;gap:.6rem 2rem;align-items:start}.two>*{min-width:0}
.swatch{display:inline-block;width:1.25em;height:1.25em;border-radius:5px;border:1px solid var(--soft);vertical-align:-.28em;margin-right:.55em;
-webkit-print-color-adjust:exact;print-color-adjust:exact}
.share td:nth-child(2){width:42%}.share .num{padding-left:.8rem}.share .num,.share th:last-child,.files .num,.files th:last-child{text-align:right;padding-right:0}
table.sortable th button{font:inherit;color:inherit;background:none;border:0;padding:0;cursor:pointer;text-align:left}
table.sortable th button:hover{text-decoration:underline}
th[aria-sort=ascending] button::after{content:" \25B2"}th[aria-sort=descending] button::after{content:" \25BC"}
table.sortable td,table.sortable thead th{white-space:nowrap}table.sortable tbody th{font-weight:500}
.sign{display:inline-block;width:1.55em;text-align:center;border-radius:6px;font-weight:700}
.stack{display:flex;gap:2px;height:.75rem;border-radius:99px;overflow:hidden;min-width:7rem;-webkit-print-color-adjust:exact;print-color-adjust:exact}
.stack i{display:block;height:100%}
.checks .num{text-align:center}.card>h2{margin-bottom:.7rem}.checks td:nth-child(2){width:34%}.checks tbody th{font-weight:500}
.wrong td:nth-child(3){width:18%}.wrong td:last-child{width:38%}
.scroll{overflow-x:auto}.scroll tbody th{min-width:10rem}
details{border-top:1px solid var(--line);padding:.55rem 0}details:first-of-type{border-top:0}
summary{cursor:pointer;font-weight:600}
pre{margin:.6rem 0 .2rem;padding:.85rem 1rem;background:var(--paper);border:1px solid var(--line);border-radius:9px;overflow:auto;max-height:28rem;
font:.83rem/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace;white-space:pre-wrap;overflow-wrap:anywhere}
footer{color:var(--soft);font-size:.85rem;margin-top:2rem;overflow-wrap:anywhere}
@media(max-width:40rem){main{padding:1rem .75rem 3rem}h1{font-size:1.35rem}.card{padding:1rem}.top{gap:1rem;padding:1.1rem}.ring{width:86px;height:86px}
.list{padding:.2rem 0}.list .row{flex-wrap:wrap;gap:.25rem .7rem;padding:.6rem .9rem}.list .name{flex:1 0 100%;order:-1}.list .num{margin-left:auto}.list .pill{min-width:0}
.check h2{flex:1 0 100%;order:3}.check header .num{margin-left:auto}.share td:nth-child(2){width:34%}
.two{grid-template-columns:1fr}.pictures{grid-template-columns:1fr 1fr}
.pictures figure:nth-child(3n){grid-column:1/-1;display:grid;grid-template-columns:1fr 1fr;gap:.9rem;align-items:center}dl{grid-template-columns:1fr;gap:0}dd{margin-bottom:.5rem}}
@media print{:root{--paper:#fff;--card:#fff;--ink:#000;--soft:#444;--line:#bbb;--note:#f3f3f3}body{font-size:11pt}main{max-width:none;padding:0}
.card{break-inside:avoid-page;border-radius:6px}.check{break-inside:auto}figure,table,.why{break-inside:avoid}pre{max-height:none}.pill,.why{-webkit-print-color-adjust:exact;print-color-adjust:exact}}
)css";

}  // namespace grader
