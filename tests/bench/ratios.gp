# Ratios and their targets, of a part whose CSV is its list of results: a point for each, a bar where the target is.
# SPDX-License-Identifier: MIT
set title chart_title noenhanced
set lmargin at screen 0.42
set rmargin at screen 0.95
set bmargin at screen 0.12
set xlabel axis
set logscale x
set format x '%g'
rows = system("awk -F, '$(NF-1) != \"\" && $(NF-2) == \"".unit."\"' '".csv."' | wc -l") + 0
set yrange [rows - 0.5:-0.5]
list = "< awk -F, -v OFS=, '$(NF-1) != \"\" && $(NF-2) == \"".unit."\" { print n++, $0 }' '".csv."'"
set key at screen 0.02, screen 0.04 left bottom horizontal
plot list using 3:($1):ytic(strcol(2)) with points ls 1 ps 1.6 title 'measured', \
     list using 5:1:(0):(0.32) with vectors nohead ls 2 lw 3 notitle, \
     list using 5:1:(0):(-0.32) with vectors nohead ls 2 lw 3 title 'target', \
     list using 3:1:(sprintf($3 < 100 ? '  %.3g' : '  %.0f', $3)) with labels left offset 0.8,0 font ',9' notitle
