# Milliseconds of the lab and of three.js, from process to pixels and steady.
# SPDX-License-Identifier: MIT
set title 'The same scenes on the same driver: the lab, and three.js in headless Chromium' noenhanced
set lmargin at screen 0.44
set rmargin at screen 0.93
set xlabel 'ms'
set logscale x
set format x '%g'
rows = system("grep -c ',ms,' '".csv."'") + 0
set yrange [rows - 0.5:-0.5]
longest = system("awk -F'\",' '$2 ~ /,ms,/ && $2 + 0 > m { m = $2 + 0 } END { print m }' '".csv."'") + 0
set xrange [*:2.5 * longest] # room for the last label
list(who) = "< awk -F'\",' -v OFS=, '$2 ~ /,ms,/ { n++; if ($1 ~ /".who."$/) print n - 1, $0 }' '".csv."'"
set key at screen 0.02, screen 0.04 left bottom horizontal
plot list('the lab') using 3:1:ytic(strcol(2)) with points ls 1 ps 1.6 title 'the lab', \
     list('three.js r[0-9]*') using 3:1:ytic(strcol(2)) with points ls 2 ps 1.6 title 'three.js', \
     list('') using 3:1:(sprintf($3 < 100 ? '%.3g' : '%.0f', $3)) with labels left offset 1.2,0 font ',9' notitle
