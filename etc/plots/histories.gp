# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# Water depth, pore pressure and cohesion intercept at a place over the hours.
#
#     gnuplot -c etc/plots/histories.gp <table> <output.png>
#
# The table has the columns time (s), h (m), porePressure and
# cohesionIntercept (Pa).

plots = system("dirname '".ARG0."'")
if (ARGC < 2) {
    printerr "Usage: gnuplot -c histories.gp <table> <output.png>"
    exit status 1
}
load plots."/style.gp"

set terminal pngcairo size 1400,1150 font "DejaVu Sans,16" noenhanced
set output ARG2
set lmargin at screen 0.11
set rmargin at screen 0.97
set multiplot layout 3,1
set autoscale xfixmax
set format x ""
unset key

set ylabel "water depth at A (m)"
set yrange [0:*]
plot rows("time h", ARG1) using ($1/3600):2 with filledcurves y=0 \
    fs solid 1 lc rgb '#bcd4ea', \
    rows("time h", ARG1) using ($1/3600):2 with lines lt 1

set yrange [*:*]
set ylabel "pore pressure at B (kPa)"
plot rows("time porePressure", ARG1) using ($1/3600):($2/1000) \
    with lines lt 2

set format x "%g"
set xlabel "time (h)"
set ylabel "cohesion intercept at B (kPa)"
plot rows("time cohesionIntercept", ARG1) using ($1/3600):($2/1000) \
    with lines lt 3

unset multiplot
unset output
