# Processor time of the reference and of a bare loop.
# SPDX-License-Identifier: MIT
set title 'The reference in doubles, 64 point lights, 512x512' noenhanced
set ylabel 'ns of processor time per pixel and light'
set yrange [0:*]
set xrange [-0.6:1.6]
set offsets 0, 0, 0.6, 0
plot "< grep ' per pixel' '".csv."'" using 0:2:xtic(strcol(1)) with impulses ls 5 dt 1 lw 2 notitle, \
     '' using 0:2 with points ls 1 ps 1.8 notitle, \
     '' using 0:2:(sprintf('%.2f', $2)) with labels offset 0,1 notitle
