# What all charts share: colours that colour-blind people tell apart (Okabe and Ito), always with shapes, and who measured.
# SPDX-License-Identifier: MIT
set datafile separator ','
set style line 1 lc rgb '#0072B2' pt 7 lw 1.6 ps 0.9
set style line 2 lc rgb '#D55E00' pt 5 lw 1.6 ps 0.9
set style line 3 lc rgb '#009E73' pt 9 lw 1.6 ps 1.0
set style line 4 lc rgb '#CC79A7' pt 13 lw 1.6 ps 1.0
set style line 5 lc rgb '#555555' pt 4 lw 1.2 ps 0.8 dt 2
set style line 9 lc rgb '#DDDDDD' lw 0.6
set grid ls 9
set bmargin 4.5
set border lc rgb '#555555'
set key noenhanced Left reverse samplen 2 spacing 1.1
set label 100 machine at screen 0.995, screen 0.012 right font ',7' textcolor rgb '#555555' noenhanced
