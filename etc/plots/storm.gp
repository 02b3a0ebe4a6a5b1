# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# Rain, safety factor and water of a storm over the hours.
#
#     gnuplot -c etc/plots/storm.gp <case> <output.png> [area [title]]
#
# Reads postProcessing/waterBalance/*/waterBalance.dat and, if there is one,
# postProcessing/slopeStability/*/factorOfSafety.dat of the case. With the plan
# area of the ground (m2) rates are in mm/h and amounts in mm, else in m3/h and
# m3.

case = ARGC > 0 ? ARG1 : "."
output = ARGC > 1 ? ARG2 : "storm.png"
area = ARGC > 2 ? real(ARG3) : 0
heading = ARGC > 3 ? ARG4 : ""
plots = system("dirname '".ARG0."'")
load plots."/style.gp"

water = files(case."/postProcessing/waterBalance/*/waterBalance.dat")
safety = files(case."/postProcessing/slopeStability/*/factorOfSafety.dat")
if (strlen(water) == 0) {
    printerr "No postProcessing/waterBalance/*/waterBalance.dat in ", case
    exit status 1
}

unit = area > 0 ? "mm" : "m³"
scale = area > 0 ? 1000/area : 1
hours(t) = t/3600.0

# A rate from two rows of a cumulative amount
rate(t, v) = (dt = t - lastT, dv = v - lastV, lastT = t, lastV = v, \
    dt > 0 ? 3600*scale*dv/dt : NaN)

panels = strlen(safety) ? 3 : 2
set terminal pngcairo size 1400,(panels == 3 ? 1250 : 900) \
    font "DejaVu Sans,16" noenhanced
set output output

stats rows("time rain", water) using 1 nooutput
set xrange [0:hours(STATS_max)]
set lmargin at screen 0.10
set rmargin at screen 0.97
set multiplot layout panels,1 title heading font ",20"

set format x ""
set ylabel "rate (".unit."/h)"
set yrange [0:*]
set style fill solid 1 noborder
set key top left
lastT = 0; lastV = 0
plot rows("time rain", water) using (hours($1)):(rate($1, $2)) \
         with fillsteps lc rgb "#bcd4ea" title "rain", \
     lastT = 0, lastV = 0, rows("time infiltration", water) \
         using (hours($1)):(rate($1, $2)) with lines lt 3 \
         title "infiltration", \
     lastT = 0, lastV = 0, rows("time surfaceOutflow", water) \
         using (hours($1)):(rate($1, $2)) with lines lt 4 \
         title "surface outflow"

if (panels == 3) {
    set format y "%.4g"
    set ylabel "safety factor"
    set yrange [*:*]
    set key top right
    methods = system("awk -v names='time method' -f '".plots \
        ."/columns.awk' ".safety." | awk '{ print $2 }' | sort -u \
        | tr '\n' ' '")
    set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead \
        dt 2 lc rgb '#404040'
    plot for [m in methods] \
        rowsWhere("time FOS", "method", m, safety) \
        using (hours($1)):2 with linespoints pt 7 ps 0.6 title m
    unset arrow 1
    set format y "%g"
    set yrange [0:*]
}

set format x "%g"
set xlabel "time (h)"
set ylabel "amount (".unit.")"
set key top left
plot rows("time rain", water) using (hours($1)):(scale*$2) \
         with lines lw 7 lc rgb "#bcd4ea" title "rain", \
     rows("time infiltration", water) using (hours($1)):(scale*$2) \
         with lines lt 3 title "infiltration", \
     rows("time surfaceOutflow", water) using (hours($1)):(scale*$2) \
         with lines lt 4 title "surface outflow", \
     rows("time subsurfaceOutflow", water) using (hours($1)):(scale*$2) \
         with lines lt 5 title "subsurface outflow"

unset multiplot
unset output
