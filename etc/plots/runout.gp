# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# Slides against time: largest displacement, front, kinetic energy.
#
#     gnuplot -c etc/plots/runout.gp <output.png> <title>=<runout.dat> ...
#
# One curve for each file, for example of three states
#
#     gnuplot -c etc/plots/runout.gp states.png \
#         a=postProcessing/stateA/0/runout.dat \
#         b=postProcessing/stateB/0/runout.dat

plots = system("dirname '".ARG0."'")
if (ARGC < 2) {
    printerr "Usage: gnuplot -c runout.gp <output.png> <title>=<runout.dat> ..."
    exit status 1
}
load plots."/style.gp"

argument(i) = value(sprintf("ARG%d", i))
titleOf(i) = argument(i)[1:strstrt(argument(i), "=") - 1]
fileOf(i) = argument(i)[strstrt(argument(i), "=") + 1:*]
last = ARGC

set terminal pngcairo size 1400,1150 font "DejaVu Sans,16" noenhanced
set output ARG1
set lmargin at screen 0.11
set rmargin at screen 0.97
set multiplot layout 3,1
set format x ""
set autoscale xfixmax
set key top left

set ylabel "largest displacement (m)"
plot for [i = 2:last] rows("time maxDisplacement", fileOf(i)) \
    using 1:2 with lines lt i - 1 title titleOf(i)

set ylabel "front (m)"
plot for [i = 2:last] rows("time front", fileOf(i)) \
    using 1:2 with lines lt i - 1 notitle

set format x "%g"
set xlabel "sliding time (s)"
set ylabel "kinetic energy (kJ)"
plot for [i = 2:last] rows("time kineticEnergy", fileOf(i)) \
    using 1:($2/1000) with lines lt i - 1 notitle

unset multiplot
unset output
