"""Maps of mpmStability.csv: error over CFL number and cells.

Usage: chart.py <mpmStability.csv> <mpmStability.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import plt, read  # noqa: E402


def main(source, target):
    """One small map for each shape function, transfer and order of updates."""
    notes, rows = read(source)
    keys = [
        list(dict.fromkeys(row[key] for row in rows))
        for key in ("shape", "update", "transfer", "cfl", "cells")
    ]
    shapes, updates, transfers, cfls, cells = keys
    value = {
        tuple(row[k] for k in ("shape", "update", "transfer", "cfl", "cells")): row
        for row in rows
    }
    figure, panels = plt.subplots(
        len(shapes) * len(updates), len(transfers), figsize=(12, 24)
    )
    for i, (shape, update) in enumerate(
        (s, u) for s in shapes for u in updates
    ):
        for j, transfer in enumerate(transfers):
            axes = panels[i][j]
            if (shape, update, transfer, cfls[0], cells[0]) not in value:
                axes.axis("off")
                continue
            colours = plt.get_cmap("viridis_r").copy()
            colours.set_bad("black")
            table = [
                [
                    float("nan")
                    if value[shape, update, transfer, c, n]["failed"] == "1"
                    else float(
                        value[shape, update, transfer, c, n]["log10Error"]
                    )
                    for c in cfls
                ]
                for n in cells
            ]
            image = axes.imshow(
                table, cmap=colours, vmin=-4, vmax=0, aspect="auto",
                origin="lower",
            )
            axes.set_xticks(range(len(cfls)), cfls, fontsize=5)
            axes.set_yticks(range(len(cells)), cells, fontsize=5)
            axes.set_title(f"{shape} {transfer} {update}", fontsize=6)
    figure.suptitle(
        "log10 error of the flying bar over CFL number (along) and cells (up); "
        "black: failed. " + "; ".join(notes),
        fontsize=8,
    )
    figure.tight_layout(rect=(0, 0, 1, 0.98))
    figure.colorbar(image, ax=panels, shrink=0.3)
    figure.savefig(target, dpi=80)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
