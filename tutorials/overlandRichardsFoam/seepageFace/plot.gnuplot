set terminal pngcairo size 900,760 font "DejaVu Sans,12"
set output "results/seepageFace.png"
set title "Pressure head in the dam when the flow is steady"
set xlabel "distance from the headwater (m)"
set ylabel "height (m)"
set xrange [0:10]
set yrange [0:12]
set size ratio 1.2
set cblabel "pressure head (m)"
set cbrange [-4:10]
set palette defined (-4 "#f7e8d0", -0.001 "#fdf8ee", 0 "#deebf7", 10 "#08519c")
set key top right box opaque

plot "results/heads" using 1:2:3 with image notitle, \
     "results/waterTable" with lines lw 3 lc rgb "#d7301f" \
         title "water table, psi = 0", \
     sqrt(100 - 9.6*x) with lines lw 2 dt 2 lc rgb "#333333" \
         title "Dupuit's parabola between the levels"
