# Frame time against lights, triangles, pixels and meshes, each with the driver's floor.
# SPDX-License-Identifier: MIT
series(name) = "< awk -F, 'NR == 1 || $1 == \"".name."\"' '".csv."'"
# What the fit says, from the part's JSON next to the CSV.
fit(name, unit) = system("awk -F'\"' -v a='".name.": per ".unit."' -v b='".name.": exponent of the upper half' \
    '$2 == \"name\" { n = $4 } $2 == \"value\" { v = $3; gsub(/[:, ]/, \"\", v); if (n == a) x = v; if (n == b) y = v } \
    $2 == \"unit\" && n == a { u = $4 } END { printf \"%.3g %s per ".unit.", x^%.2f\", x, u, y }' '".csvs."/scaling.json'")
set multiplot layout 2,2 title 'How a frame grows (512x512 unless said, lit by the lecture''s three lights unless said)' noenhanced
set logscale xy
set format x '10^{%L}'
set format y '%g'
set ylabel 'ms per frame'
set key top left
set offsets graph 0, graph 0, graph 0.3, graph 0  # room for the key
set xlabel 'point lights (k = 2), knot of 51,200 triangles'
plot series('lights without end') using 2:3 with linespoints ls 1 title 'without end: '.fit('lights without end', 'light'), \
     series('lights with a reach of 1/40') using 2:3 with linespoints ls 3 title 'reach 1/40: '.fit('lights with a reach of 1/40', 'light'), \
     series('lights without end') using 2:4 with linespoints ls 5 title 'floor: flat colour, by hand'
set xlabel 'triangles'
plot series('triangles') using 2:3 with linespoints ls 1 title 'lit: '.fit('triangles', 'triangle'), \
     series('triangles') using 2:4 with linespoints ls 5 title 'floor: flat colour, by hand'
set xlabel 'pixels of the picture (64x64 to 4096x4096)'
plot series('pixels') using 2:3 with linespoints ls 1 title 'lit: '.fit('pixels', 'pixel'), \
     series('pixels') using 2:4 with linespoints ls 5 title 'floor: flat colour, by hand'
set xlabel 'meshes (boxes, a draw call each)'
plot series('meshes') using 2:3 with linespoints ls 1 title 'lit: '.fit('meshes', 'mesh'), \
     series('meshes') using 2:4 with linespoints ls 5 title 'floor: flat colour, by hand'
unset multiplot
