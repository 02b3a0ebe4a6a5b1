# The road's points A and B over time: results/histories.dat holds the hour, the
# depth at A and upstream (m), u_w and cf' at B and just below A (kPa)
set terminal pngcairo size 1000,1100 font "DejaVu Sans,12"
set output "results/histories.png"
set multiplot layout 4,1
set lmargin 10
set rmargin 4
set xrange [0:70]
set xtics 10
set grid lc rgb "#dddddd"
data = "results/histories.dat"

set ylabel "depth (m)"
set yrange [0:*]
set key top left
plot data using 1:2 with lines lw 2 lc rgb "#08519c" title "A, on the road", \
     data using 1:3 with lines lw 2 lc rgb "#6baed6" title "16 m upstream of A"

set ylabel "u_w (kPa)"
set yrange [*:*]
set key bottom right
plot data using 1:4 with lines lw 2 lc rgb "#d95f02" title "B, 1 m below A", \
     data using 1:6 with lines lw 2 lc rgb "#fdae6b" title "5 cm below A"

set ylabel "cf' (kPa)"
set key top right
plot data using 1:5 with lines lw 2 lc rgb "#238b45" title "B, 1 m below A", \
     data using 1:7 with lines lw 2 lc rgb "#a1d99b" title "5 cm below A"

set ylabel "safety factor"
set xlabel "time (h)"
set arrow from 0, 1 to 70, 1 nohead dashtype 2
plot "results/factorOfSafety.dat" using 1:2 with linespoints pt 7 ps 0.5 \
         lc rgb "#b10026" title "embankment, deeper than 1 m", \
     "results/factorOfSafety.dat" using 1:3 with linespoints pt 7 ps 0.5 \
         lc rgb "#fd8d3c" title "embankment, deeper than 2 m", \
     "results/factorOfSafety.dat" using 1:4 with lines lc rgb "#999999" \
         title "with the natural slope below"
unset multiplot
