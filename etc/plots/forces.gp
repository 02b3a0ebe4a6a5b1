# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# Forces of a slide on walls against time, and what they have summed up to.
#
#     gnuplot -c etc/plots/forces.gp <output.png> <x|y|z> <title>=<force.dat> ...
#
# One curve for each file, for example of two barriers
#
#     gnuplot -c etc/plots/forces.gp forces.png x \
#         left=postProcessing/landslideRunout/0/force_left.dat \
#         right=postProcessing/landslideRunout/0/force_right.dat

plots = system("dirname '".ARG0."'")
if (ARGC < 3) {
    printerr "Usage: gnuplot -c forces.gp <output.png> <x|y|z> <title>=<force.dat> ..."
    exit status 1
}
load plots."/style.gp"

argument(i) = value(sprintf("ARG%d", i))
titleOf(i) = argument(i)[1:strstrt(argument(i), "=") - 1]
fileOf(i) = argument(i)[strstrt(argument(i), "=") + 1:*]
last = ARGC
axis = ARG2
capital = axis eq "x" ? "X" : axis eq "y" ? "Y" : "Z"

set terminal pngcairo size 1400,800 font "DejaVu Sans,16" noenhanced
set output ARG1
set lmargin at screen 0.11
set rmargin at screen 0.97
set multiplot layout 2,1
set format x ""
set autoscale xfixmax
set key top right

set ylabel "force along ".axis." (kN)"
plot for [i = 3:last] rows("time F".axis, fileOf(i)) \
    using 1:($2/1000) with lines lt i - 2 title titleOf(i)

set format x "%g"
set xlabel "sliding time (s)"
set ylabel "impulse along ".axis." (kN s)"
plot for [i = 3:last] rows("time impulse".capital, fileOf(i)) \
    using 1:($2/1000) with lines lt i - 2 notitle

unset multiplot
unset output
