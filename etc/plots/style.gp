# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# The look of all charts and the way to their data; loaded by the scripts
# beside it, which set `plots` to this folder first.

set encoding utf8
set border 3 lc rgb '#404040'
set tics nomirror textcolor rgb '#404040'
set grid ytics lc rgb '#e0e0e0' lt 1
set key textcolor rgb '#404040' samplen 2 spacing 1.15

set linetype 1 lc rgb '#2166ac' lw 2.5     # water
set linetype 2 lc rgb '#b2182b' lw 2.5     # danger
set linetype 3 lc rgb '#1b7837' lw 2.5     # soil
set linetype 4 lc rgb '#e08214' lw 2.5
set linetype 5 lc rgb '#762a83' lw 2.5
set linetype cycle 5

# rows("time rain", files): columns of one or several tables
rows(names, files) = sprintf("< awk -v names='%s' -f '%s/columns.awk' %s", \
    names, plots, files)

# The same for the rows where a column has a value
rowsWhere(names, column, value, files) = sprintf( \
    "< awk -v names='%s' -v where=%s -v is='%s' -f '%s/columns.awk' %s", \
    names, column, value, plots, files)

# The files of a pattern in the order of their start times
files(pattern) = system("ls -d ".pattern." 2>/dev/null \
    | awk -F/ '{ print $(NF - 1) \"\\t\" $0 }' | sort -g | cut -f 2 \
    | tr '\n' ' '")

