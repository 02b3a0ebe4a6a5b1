#------------------------------------------------------------------------------
# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#------------------------------------------------------------------------------
# Script
#     gnuplot -c chart.gp <mpmSpeed.csv> <mpmSpeed.png>
#
# Description
#     Particle-steps a second over the number of points, with what other codes
#     reached on the same column (one core, double precision, measured on a
#     2-core AMD Zen 3 machine), and where the time of a step goes
#     (mpmSpeedStages.csv beside the table).
#------------------------------------------------------------------------------
if (ARGC != 2) {
    printerr "Usage: gnuplot -c chart.gp <mpmSpeed.csv> <mpmSpeed.png>"
    exit status 1
}
table = ARG1
stages = table[1:strlen(table) - 4]."Stages.csv"

set terminal pngcairo size 1000,900 font ",10"
set output ARG2
set datafile separator ","
set datafile commentschars "#"
set multiplot layout 2,1

set title system("sed -n '1,2s/^# //p' ".table." | paste -sd ';'") noenhanced
set logscale xy
set xlabel "points"
set ylabel "million particle-steps a second"
set xrange [700:1.5e6]
set yrange [0.3:100]
set grid
set key outside right

# Lowest and highest of a peer, with the numbers of points
$peers << EOD
1e4,0.6,1e5,0.85
1e4,1.7,1e5,2.7
1e4,2.5,1e5,3.0
2.16e5,0.42,2.16e5,0.50
EOD

rows(d, t) = "< awk -F, '$1 == ".d." && $4 == ".t."' ".table
plot for [d = 2:3] for [t = 1:2] rows(d, t) using 2:5 \
        with linespoints lc d dt t pt 5 + t \
        title sprintf("%d-D, %d core%s", d, t, t > 1 ? "s" : ""), \
    "$peers" using (2e4):(sqrt($2*$4)):2:4 every ::0::0 \
        with yerrorbars lc 1 pt 1 title "cb-geo/mpm, 2-D", \
    "$peers" using (3e4):(sqrt($2*$4)):2:4 every ::1::1 \
        with yerrorbars lc 4 pt 1 title "MPM3D-F90, slab", \
    "$peers" using (4e4):(sqrt($2*$4)):2:4 every ::2::2 \
        with yerrorbars lc 5 pt 1 title "matter, 2-D", \
    "$peers" using (2.16e5):(sqrt($2*$4)):2:4 every ::3::3 \
        with yerrorbars lc 5 pt 2 title "matter, 3-D", \
    30 lc 2 dt 3 title "goal 2-D, one core", \
    12 lc 3 dt 3 title "goal 3-D, one core"

set title system("sed -n '3s/^# //p' ".stages) noenhanced
unset logscale
set xlabel "dimension: points"
set ylabel "ns a point and step"
set xrange [*:*]
set yrange [0:*]
set style data histograms
set style histogram rowstacked
set style fill solid 0.8
set boxwidth 0.7
plot for [i = 5:10] stages using i:xtic(stringcolumn(1)."-D: ".stringcolumn(2)) \
    title system(sprintf("grep -v '^#' %s | head -n 1 | cut -d , -f %d", \
        stages, i)) noenhanced
unset multiplot

#------------------------------------------------------------------------------
