# Plan area, and water that stands, of the faces of the patch top whose centres
# lie above the lines middle and aslant, within the line round, and of all:
#     'name area volume' a line, from points, faces, boundary and the depths

FNR == 1 { ++file }

file == 1 && /^\([-0-9.]/ {
    gsub(/[()]/, " ")
    split($0, p, " ")
    x[n] = p[1]
    y[n++] = p[2]
}

file == 2 && /^[0-9]+\([0-9]/ {
    gsub(/[()]/, " ")
    face[m++] = $0
}

file == 3 && $1 == "top" { top = 1 }
file == 3 && top && $1 == "nFaces" { nTop = $2 + 0 }
file == 3 && top && $1 == "startFace" { start = $2 + 0; top = 0 }

file == 4 { depth[k++] = $1 }

function add(name, area, volume)
{
    areas[name] += area
    volumes[name] += volume
}

END {
    for (f = 0; f < nTop; ++f) {
        nv = split(face[start + f], v, " ") - 1
        area = cx = cy = 0
        for (i = 2; i <= nv + 1; ++i) {
            j = i == nv + 1 ? 2 : i + 1
            cross = x[v[i]]*y[v[j]] - x[v[j]]*y[v[i]]
            area += cross/2
            cx += cross*(x[v[i]] + x[v[j]])/6
            cy += cross*(y[v[i]] + y[v[j]])/6
        }
        cx /= area
        cy /= area
        area = area < 0 ? -area : area
        volume = area*depth[f]
        add("all", area, volume)
        if (cx < 197) add("middle", area, volume)
        if (cx < 150 + 2.5*cy) add("aslant", area, volume)
        if (cx > 50 && cx < 320 && cy > 10 && cy < 30)
            add("round", area, volume)
    }
    for (name in areas)
        printf "%s %.17g %.17g\n", name, areas[name], volumes[name]
}
