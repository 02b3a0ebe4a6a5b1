# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#
# Columns of the tables that a run leaves, by name, one row a line, NaN where a
# field is empty: what gnuplot wants. Rows of a restart replace those of the
# earlier start from its first time on.
#
#     awk -v names='time rain' [-v where=method -v is=bishop] -f columns.awk \
#         table.dat ...
#
# Fields are separated by tabs if there is one in the header, else by commas,
# else by blanks. The header is the first line that names the first column,
# with or without #.

function fields(line)
{
    sub(/^#[ \t]*/, "", line)
    sub(/\r$/, "", line)
    if (separator == "")
    {
        separator = index(line, "\t") ? "[ ]*\t[ ]*" \
            : index(line, ",") ? " *, *" : "blanks"
    }
    if (separator == "blanks")
    {
        sub(/^ +/, "", line)
        return split(line, field, / +/)
    }
    return split(line, field, separator)
}

BEGIN { nWanted = split(names, wanted, / +/) }

FNR == 1 { header = 0; separator = ""; first = 1 }

!header && $0 ~ "(^|[# \t])" wanted[1] "([ \t,]|$)" {
    n = fields($0)
    for (i = 1; i <= n; i++) place[field[i]] = i
    for (k = 1; k <= nWanted; k++)
    {
        if (!(wanted[k] in place))
        {
            printf "columns.awk: %s has no column %s\n", FILENAME, wanted[k] \
                > "/dev/stderr"
            exit 1
        }
    }
    header = 1
    next
}

/^[ \t]*#/ || !header || /^[ \t]*$/ { next }

{
    fields($0)
    if (where != "" && field[place[where]] != is) next

    row = ""
    for (k = 1; k <= nWanted; k++)
    {
        value = field[place[wanted[k]]]
        row = row (value == "" ? "NaN" : value) " "
    }

    time = field[place[wanted[1]]] + 0
    if (first)
    {
        while (nRows && times[nRows] >= time - 1e-9*(time + 1)) nRows--
        first = 0
    }
    nRows++
    times[nRows] = time
    rows[nRows] = row
}

END { for (i = 1; i <= nRows; i++) print rows[i] }
