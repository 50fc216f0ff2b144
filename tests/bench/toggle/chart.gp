# Every toggle's first frame beyond a steady one, sorted: the right end is the worst.
# SPDX-License-Identifier: MIT
set title 'First frame after a symbol is toggled, beyond a steady frame' noenhanced
set xlabel 'share of all toggles (sorted)'
set ylabel 'ms (0.1: that or less)'
set logscale y
set yrange [0.1:]
set format y '%g'
set xrange [0:1.02]
set key top left
sorted(cache, group) = "< awk -F, '$1 == \"".cache."\" && $2 == \"\\\"".group."\\\"\" { print $NF }' '".csv."' | sort -g | \
    awk '{ v[NR] = $1 } END { for (i = 1; i <= NR; ++i) print (i - 0.5) / NR \",\" (v[i] < 0.1 ? 0.1 : v[i]) }'"
plot sorted('cold', 'first visit') using 1:2 with linespoints ls 2 title 'never seen before, no shader cache', \
     sorted('warm', 'first visit') using 1:2 with linespoints ls 1 title 'never seen before, Mesa''s shader cache', \
     sorted('cold', 'back') using 1:2 with linespoints ls 3 title 'seen before in this window', \
     16.7 with lines lc rgb '#555555' dt 3 title 'a sixtieth of a second'
