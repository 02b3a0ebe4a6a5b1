"""Chart of waterStability.csv: for each scheme a map of iterations, and where it fails.

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


# What is marked on a place of a map, over all runs there: label, marker, colour
MARKS = {
    "unfinished": ("did not finish", "x", "red"),
    "wrong": ("wrong answer", "o", "orange"),
    "stopped": ("did not finish without rescue", "v", "white"),
}


def survey(rows, second):
    """Places of the map with their most iterations, rejected steps and marks."""
    xs = list(dict.fromkeys(row["x"] for row in rows))
    ys = list(dict.fromkeys(row[second] for row in rows))
    grid = [[0.0] * len(xs) for _ in ys]
    rejected = {}
    marks = {name: set() for name in MARKS}
    for row in rows:
        i, j = xs.index(row["x"]), ys.index(row[second])
        finished = row["finished"] == "1"
        if row["rescue"] == "no":
            if not finished:
                marks["stopped"].add((i, j))
            continue
        if not finished:
            marks["unfinished"].add((i, j))
            continue
        grid[j][i] = max(grid[j][i], float(row["nonlinearIterations"]))
        rejected[i, j] = max(rejected.get((i, j), 0), int(row["rejectedSteps"]))
        if row["wrong"] == "1":
            marks["wrong"].add((i, j))
    return xs, ys, grid, rejected, marks


def draw(rows):
    """One panel a map and scheme; numbers: rejected steps."""
    pairs = list(dict.fromkeys((row["map"], row["scheme"]) for row in rows))
    columns = 4
    figure, panels = plt.subplots(-(-len(pairs) // columns), columns, figsize=(14, 11))
    for axes in panels.flat[len(pairs):]:
        axes.axis("off")
    for axes, (name, scheme) in zip(panels.flat, pairs):
        second = "z" if name == "overland" else "y"
        xs, ys, grid, rejected, marks = survey(where(rows, map=name, scheme=scheme), second)
        image = axes.imshow(grid, origin="lower", aspect="auto", cmap="viridis")
        for (i, j), steps in rejected.items():
            if steps:
                axes.text(i, j + 0.25, steps, color="white", fontsize=6, ha="center", va="center")
        for kind, (label, marker, colour) in MARKS.items():
            if marks[kind]:
                faces = "none" if marker == "o" else colour
                axes.scatter(*zip(*sorted(marks[kind])), marker=marker, s=60 if marker == "o" else 18,
                             edgecolors=None if marker == "x" else colour, facecolors=faces,
                             label=label)
        axes.set_xticks(range(len(xs)), xs, fontsize=6, rotation=30)
        axes.set_yticks(range(len(ys)), ys, fontsize=6)
        axes.set_xlabel(MAPS[name][0], fontsize=7)
        axes.set_ylabel(MAPS[name][1], fontsize=7)
        axes.set_title(f"{name}: {scheme}, iterations; numbers: steps rejected", fontsize=8)
        figure.colorbar(image, ax=axes)
    legend = [
        plt.Line2D([], [], linestyle="", marker=marker, color=colour, markeredgecolor="black"
                   if colour == "white" else colour, markerfacecolor="none" if marker == "o"
                   else colour, label=label)
        for label, marker, colour in MARKS.values()
    ]
    panels.flat[0].legend(handles=legend, loc="lower left", fontsize="small")
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
