# Time of the thread that draws, for every change of a picture, sorted: the right end is the worst.
# SPDX-License-Identifier: MIT
set title 'A change in the window: time of the thread that draws' noenhanced
set xlabel 'share of all changes of a kind (sorted)'
set ylabel 'ms'
set logscale y
set yrange [0.5:200]
set format y '%g'
set xrange [0:1.02]
set key top left
sorted(cache, group) = "< awk -F, '$1 == \"".cache."\" && $0 ~ /^[^,]*,\"".group.", CPU\"/ { print $NF }' '".csv."' | sort -g | \
    awk '{ v[NR] = $1 } END { for (i = 1; i <= NR; ++i) print (i - 0.5) / NR \",\" v[i] }'"
plot sorted('no cache', 'toggle, prepared') using 1:2 with linespoints ls 3 title 'toggle, where Mesa may keep no shader cache', \
     sorted('cold', 'toggle, not prepared') using 1:2 with linespoints ls 2 title 'toggle, empty shader cache, not prepared', \
     sorted('cold', 'toggle, prepared') using 1:2 with linespoints ls 1 title 'toggle, empty shader cache, prepared', \
     sorted('cold', 'drag a light') using 1:2 with linespoints ls 4 title 'a light that is dragged, empty shader cache', \
     50 with lines lc rgb '#555555' dt 3 title 'target'
