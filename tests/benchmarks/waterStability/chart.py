"""Chart of waterStability.csv: a map of iterations for each scheme.

Usage: chart.py <waterStability.csv> <waterStability.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import plt, run, where  # noqa: E402

MAPS = {
    "soil": ("n", "initial head [m]"),
    "layers": ("cell height [m]", "contrast of Ks"),
    "overland": ("slope", "step [s]"),
    "cycles": ("half period [s]", "rain [mm/h]"),
}


def draw(rows):
    """One panel a map and scheme; white: rejected steps, crosses: did not finish."""
    pairs = list(dict.fromkeys((row["map"], row["scheme"]) for row in rows))
    columns = 4
    figure, panels = plt.subplots(-(-len(pairs) // columns), columns, figsize=(14, 11))
    for axes in panels.flat[len(pairs):]:
        axes.axis("off")
    for axes, (name, scheme) in zip(panels.flat, pairs):
        chosen = where(rows, map=name, scheme=scheme)
        second = "z" if name == "overland" else "y"
        xs = list(dict.fromkeys(row["x"] for row in chosen))
        ys = list(dict.fromkeys(row[second] for row in chosen))
        grid = [[0.0] * len(xs) for _ in ys]
        rejected = {}
        failed = []
        for row in chosen:
            place = xs.index(row["x"]), ys.index(row[second])
            if row["finished"] == "1":
                grid[place[1]][place[0]] = max(
                    grid[place[1]][place[0]], float(row["nonlinearIterations"])
                )
                rejected[place] = max(rejected.get(place, 0), int(row["rejectedSteps"]))
            else:
                failed.append(place)
        image = axes.imshow(grid, origin="lower", aspect="auto", cmap="viridis")
        for place, steps in rejected.items():
            if steps:
                axes.text(*place, steps, color="white", fontsize=7, ha="center", va="center")
        if failed:
            axes.plot(*zip(*failed), "rx", markersize=10, markeredgewidth=2)
        axes.set_xticks(range(len(xs)), xs, fontsize=6, rotation=30)
        axes.set_yticks(range(len(ys)), ys, fontsize=6)
        axes.set_xlabel(MAPS[name][0], fontsize=7)
        axes.set_ylabel(MAPS[name][1], fontsize=7)
        axes.set_title(f"{name}: {scheme}, iterations; white: steps rejected", fontsize=8)
        figure.colorbar(image, ax=axes)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
