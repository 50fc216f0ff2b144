# One chart: lighting cost against error, in floats and in 8 bits. tests/bench/error/charts calls it with dir, scene and heading set.
# SPDX-License-Identifier: MIT
#
#   gnuplot -e "dir='DIR'; scene='S4'; heading='...'" charts.gp      writes DIR/error_S4.png and .svg; scene 'all': DIR/error.png
#
# Marks: the largest error; the thin line below it ends at what 99.9 % of the values keep within (floats), at the mean (8 bits). The
# default is ringed.

set datafile separator ','
rows = dir.'/error_scenes.csv'
front = dir.'/error_front.csv'
name = dir.(scene eq 'all' ? '/error' : '/error_'.scene)

left = 0.02       # costs at or below it stand at the left edge, errors of 0 at the lower one
lowest = 1e-3
lowest_codes = 1e-6
x(cost) = cost > left ? cost : left
e(error) = error > lowest ? error : lowest
c(codes) = codes > lowest_codes ? codes : lowest_codes
mine(number) = strcol(1) eq scene && column(2) == number
other(number) = strcol(1) ne 'S9' && strcol(1) ne 'all' && column(2) == number

count = 16
array shape[count] = [7, 5, 9, 11, 13, 4, 6, 8, 10, 12, 14, 1, 2, 3, 5, 9]
array color[count]
color[1] = 0xD00000; color[2] = 0x0050C0; color[3] = 0xE08000; color[4] = 0x008060; color[5] = 0x000000; color[6] = 0x8030A0
color[7] = 0x00A0D0; color[8] = 0x806020; color[9] = 0xC000A0; color[10] = 0x508000; color[11] = 0x9A9A00; color[12] = 0xC04000
color[13] = 0x4040FF; color[14] = 0x00A000; color[15] = 0xA0A0A0; color[16] = 0x702030
size = 1.3
stats rows using 2 nooutput
count = STATS_max < count ? int(STATS_max) : count
title_of(number) = system(sprintf("awk -F, '$2 == %d { print $4; exit }' \"%s\"", number, rows))

set grid xtics ytics back linetype 1 linecolor rgb '#E4E4E4'
set logscale xy
set xtics ('≤0.02' 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
set xrange [* : *]
set format y '10^{%T}'
set xlabel scene eq 'S9' ? 'frame / flat-colour frame' : 'lighting cost / that of three.js''s order'

do for [kind in 'png svg'] {
    if (kind eq 'png') {
        set terminal pngcairo size 1500,760 font 'DejaVu Sans,11' enhanced
    } else {
        set terminal svg size 1500,760 font 'DejaVu Sans,11' enhanced background '#FFFFFF'
    }
    set output name.'.'.kind
    set multiplot
    set label 1 heading at screen 0.06, 0.96 left font ',15'
    set tmargin at screen 0.86
    set bmargin at screen 0.10
    set key off
    set lmargin at screen 0.06
    set rmargin at screen 0.39
    set title 'floats: largest error; line down to 99.9 % of the values'
    set ylabel 'error, u S'
    set yrange [*:*]
    plot front using (strcol(1) eq scene && strcol(2) eq 'floats' ? x($3) : NaN):(e($4)) with steps linewidth 2 linecolor rgb '#F0A0A0', \
        for [i = 1 : count] rows using (scene eq 'all' && other(i) ? x($5) : NaN):(e($6)) \
            with points pointtype shape[i] pointsize 0.4 linecolor rgb color[i], \
        for [i = 1 : count] rows using (mine(i) ? x($5) : NaN):(e($6)):(e($7)):(e($6)) \
            with yerrorbars pointtype shape[i] pointsize size linewidth 1 linecolor rgb color[i], \
        rows using (mine(1) ? x($5) : NaN):(e($6)) with points pointtype 6 pointsize 2.6 linewidth 2.5 linecolor rgb color[1]
    set lmargin at screen 0.45
    set rmargin at screen 0.78
    unset label 1
    set title '8 bits: largest error; line down to the mean; cross: share of wrong values'
    set ylabel 'error, codes'
    set yrange [lowest_codes * 0.5 : 400]
    set ytics add ('0' lowest_codes)
    set key at screen 0.995, 0.86 right top reverse Left samplen 1 spacing 1.35 noenhanced
    plot front using (strcol(1) eq scene && strcol(2) eq 'codes' ? x($3) : NaN):(c($4)) with steps linewidth 2 linecolor rgb '#F0A0A0' title 'Pareto front', \
        for [i = 1 : count] rows using (scene eq 'all' && other(i) ? x($5) : NaN):(c($8)) \
            with points pointtype shape[i] pointsize 0.4 linecolor rgb color[i] notitle, \
        for [i = 1 : count] rows using (mine(i) ? x($5) : NaN):(c($8)):(c($9)):(c($8)) \
            with yerrorbars pointtype shape[i] pointsize size linewidth 1 linecolor rgb color[i] title title_of(i), \
        for [i = 1 : count] rows using (mine(i) ? x($5) : NaN):(c($10)) \
            with points pointtype 2 pointsize 0.5 linecolor rgb color[i] notitle, \
        rows using (mine(1) ? x($5) : NaN):(c($8)) with points pointtype 6 pointsize 2.6 linewidth 2.5 linecolor rgb color[1] notitle
    unset multiplot
    set ytics autofreq
    unset output
}
