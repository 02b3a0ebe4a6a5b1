set terminal pngcairo size 900,620 font "DejaVu Sans,12"
set output "results/infiltrationColumn.png"
set key bottom left
set xlabel "water content (-)"
set ylabel "depth (m)"
set yrange [1:0]
set xrange [0.1:0.22]
set grid lc rgb "#dddddd"
set title "A wetting front, every 6 hours"
file(t) = sprintf("postProcessing/profile/%d/column_psi_theta.xy", t)
set style data lines
plot file(21600) using 3:(1 - $1) lw 2 lc rgb "#9ecae1" title "6 h", \
     file(43200) using 3:(1 - $1) lw 2 lc rgb "#6baed6" title "12 h", \
     file(64800) using 3:(1 - $1) lw 2 lc rgb "#3182bd" title "18 h", \
     file(86400) using 3:(1 - $1) lw 2 lc rgb "#08519c" title "24 h"
