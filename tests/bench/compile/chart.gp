# First frames of shaders never used before, by number of lights.
# SPDX-License-Identifier: MIT
set title 'First frame of a shader, beyond a steady frame (knot under point lights that stand still)' noenhanced
set xlabel 'point lights'
set ylabel 'ms (0.1: that or less)'
set yrange [0.1:]
set logscale y
set logscale x 2
set xrange [0.4:300]
set format xy '%g'
set key top left
of(cache, group) = "< awk -F, '$1 == \"".cache."\" && $2 == \"\\\"".group."\\\"\" && / lights/ { gsub(/\"| lights/, \"\", $3); print ($3 == 0 ? 0.5 : $3) \",\" ($4 < 0.1 ? 0.1 : $4) }' '".csv."'"
set xtics ('0' 0.5, 1, 2, 4, 8, 16, 32, 64, 128, 256)
plot of('cold', 'first frame beyond a steady one') using 1:2 with linespoints ls 2 title 'no shader cache', \
     of('cold', 'of which compiling GLSL') using 1:2 with linespoints ls 2 pt 6 dt 2 title 'of which compiling GLSL', \
     of('warm', 'first frame beyond a steady one') using 1:2 with linespoints ls 1 title 'Mesa''s shader cache', \
     of('warm', 'of which compiling GLSL') using 1:2 with linespoints ls 1 pt 4 dt 2 title 'of which compiling GLSL'
