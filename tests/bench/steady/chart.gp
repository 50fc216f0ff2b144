# Steady frames as ratios to their yardsticks.
# SPDX-License-Identifier: MIT
chart_title = 'Steady frames against hand-written ones (51,200 triangles, 512x512)'
axis = 'time of the lab / time of the yardstick'
unit = 'ratio'
load system("dirname '".ARG0."'")."/../ratios.gp"
