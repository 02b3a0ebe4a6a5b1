#------------------------------------------------------------------------------
# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#------------------------------------------------------------------------------
# File
#     vary.awk
#
# Description
#     Variants of a dictionary given as lines 'path/of/key value': each key and
#     each dictionary in turn is left out, misspelled or given another value.
#
#     awk -v seed=1 -v base=name -v folder=constant -f vary.awk name.entries
#
#     writes <folder>/<base>_<n> and prints a line a variant, separated by tabs:
#     its file, the key, what it has become.
#------------------------------------------------------------------------------

/^#/ || !NF { next }

{
    path[++n] = $1
    sub(/^[^ ]+ +/, "")
    value[n] = $0
}

# Uniform in 0..1, the same with every awk
function random()
{
    seed = (seed*16807) % 2147483647
    return seed/2147483647
}

function isNumber(v)
{
    return v ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/
}

# The list with each number replaced
function each(v, by)
{
    gsub(/[-+]?[0-9.]+([eE][-+]?[0-9]+)?/, by, v)
    return v
}

# Open and close dictionaries between two paths; returns the last name
function nest(from, to, file,    a, b, na, nb, common, i)
{
    na = split(from, a, "/") - 1
    nb = split(to, b, "/") - 1
    common = 0
    while (common < na && common < nb && a[common + 1] == b[common + 1])
    {
        ++common
    }
    for (i = na; i > common; --i)
    {
        print "}" > file
    }
    for (i = common + 1; i <= nb; ++i)
    {
        print b[i] " {" > file
    }
    return b[nb + 1]
}

# Write the variant in which 'changed' (a key or a dictionary) has this name
# and value; no name: it is left out; no value: it keeps its own
function variant(changed, name, text, what,    file, i, at, p, last, key, done)
{
    file = folder "/" base sprintf("_%04d", ++nVariants)
    print "FoamFile { version 2.0; format ascii; class dictionary;" \
        " object mpmProperties; }" > file
    last = ""
    done = 0
    for (i = 1; i <= n; ++i)
    {
        p = path[i]
        at = (p == changed || index(p, changed "/") == 1)
        if (at && (name == "" || (text != "" && done++)))
        {
            continue
        }
        if (at)
        {
            p = name (text == "" ? substr(p, length(changed) + 1) : "")
        }
        key = nest(last, p, file)
        print key " " (at && text != "" ? text : value[i] ";") > file
        last = p
    }
    nest(last, "", file)
    close(file)
    print base sprintf("_%04d", nVariants) "\t" changed "\t" what
}

function change(key, text)
{
    variant(key, key, text ";", text)
}

END {
    variant("none", "none", "", "as it is")

    for (i = 1; i <= n; ++i)
    {
        key = path[i]
        v = value[i]
        variant(key, "", "", "left out")
        variant(key, key "x", "", "misspelled")
        variant(key, key, ";", "nothing")
        variant(key, key, "{ }", "an empty dictionary")
        variant(key, key, "{ a 1; }", "a dictionary")
        change(key, "nan")
        change(key, "oops")
        change(key, "(1)")
        change(key, "(1 2 3 4 5)")
        change(key, "()")
        change(key, "\"two words\"")
        if (isNumber(v))
        {
            change(key, "-" (v == 0 ? 1 : v < 0 ? -v : v))
            change(key, "0")
            change(key, "1e-30")
            change(key, "-1e30")
            change(key, "1e30")
            change(key, "1e400")
            change(key, "7.5")
            change(key, "2147483648")
            # Plausible, and far from it
            change(key, sprintf("%.6g", v*exp(2.3*(2*random() - 1))))
            change(key, sprintf("%.6g", v*exp(2.3*(8 + 20*random()))))
            change(key, sprintf("%.6g", v*exp(-2.3*(8 + 20*random()))))
        }
        else if (v ~ /^\(.*[0-9]/)
        {
            change(key, each(v, "0"))
            change(key, each(v, "1e30"))
            change(key, each(v, "-1e30"))
            change(key, each(v, "1e-30"))
            change(key, each(v, "nan"))
            change(key, each(v, "-1"))
            change(key, "1")
        }
        else
        {
            change(key, "7")
            change(key, "-1e30")
        }

        # The dictionaries that begin here
        m = split(key, part, "/")
        d = ""
        for (j = 1; j < m; ++j)
        {
            d = d (j > 1 ? "/" : "") part[j]
            if (!(d in seen))
            {
                seen[d] = 1
                variant(d, "", "", "left out")
                variant(d, d "x", "", "misspelled")
                variant(d, d, "{ }", "an empty dictionary")
                change(d, "7")
                change(d, "(1 2)")
                change(d, "oops")
            }
        }
    }
}
