# Each submission's time, stacked; the quickest first.
# SPDX-License-Identifier: MIT
set title 'Grading lesson_05 - attenuation: @count@ submissions, two at a time' noenhanced
set xlabel 'submissions, the quickest first'
set ylabel 's'
set yrange [0:]
set key top left
rest = @rest@
set style fill solid 0.85 noborder
plot csv using 0:($1 + $2 + $3 + rest) with filledcurves y1=0 lc rgb '#555555' title 'the rest (mean): processes, files, reports', \
     csv using 0:($1 + $2 + $3) with filledcurves y1=0 lc rgb '#CC79A7' title 'judging', \
     csv using 0:($1 + $2) with filledcurves y1=0 lc rgb '#009E73' title 'drawing, confined', \
     csv using 0:1 with filledcurves y1=0 lc rgb '#0072B2' title 'building, confined'
