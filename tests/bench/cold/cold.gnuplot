# The bars of cold.csv and cold_frames.csv, as cold.png and cold.svg in the same folder.
# SPDX-License-Identifier: MIT
set datafile separator ","
set style data histograms
set style histogram rowstacked
set style fill solid 1.0 border rgb "white"
set boxwidth 0.62
set yrange [0:*]
set grid ytics lc rgb "#d8d8d8"
set border 3
set tics nomirror
set xtics rotate by -18 left
set bmargin 7
set key outside right reverse Left invert
set linetype 1 lc rgb "#4c566a"
set linetype 2 lc rgb "#b0b7c3"
set linetype 3 lc rgb "#8fbcbb"
set linetype 4 lc rgb "#5e81ac"
set linetype 5 lc rgb "#b48ead"
set linetype 6 lc rgb "#ebcb8b"
set linetype 7 lc rgb "#d08770"
set linetype 8 lc rgb "#bf616a"
set linetype 9 lc rgb "#88c0d0"
set linetype 10 lc rgb "#a3be8c"
set linetype 11 lc rgb "#e5e9f0"

do for [kind in "png svg"] {
    if (kind eq "png") {
        set terminal pngcairo size 1400,640 font "sans,11"
    } else {
        set terminal svg size 1400,640 font "sans,11"
    }
    set output "cold.".kind
    set multiplot layout 1,2
    set title "Cold process to 512x512 PNG, by phases"
    set ylabel "ms"
    plot for [i = 2:12] "cold.csv" using i:xtic(1) title columnheader(i)
    set title "100 frames of 64x64 to PNG"
    plot for [i = 2:5] "cold_frames.csv" using i:xtic(1) title columnheader(i)
    unset multiplot
    unset output
}
