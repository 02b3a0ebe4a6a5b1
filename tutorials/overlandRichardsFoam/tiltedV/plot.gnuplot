set terminal pngcairo size 900,560 font "DejaVu Sans,12"
set output "results/tiltedV.png"
set key top right
set xlabel "time (min)"
set ylabel "discharge (m^3/s)"
set xrange [0:180]
set yrange [0:5.5]
set grid lc rgb "#dddddd"
set title "The tilted V: 90 minutes of rain at 10.8 mm/h"
plot "results/discharge.dat" with lines lw 2 lc rgb "#08519c" \
         title "overlandRichardsFoam", \
     "reference.dat" with points pt 7 ps 1.3 lc rgb "#d95f02" \
         title "kinematic wave, converged"
