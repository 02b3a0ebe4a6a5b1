"""Chart of waterSpeed.csv: CPU time per cell and hour, linear iterations, ranks.

Usage: chart.py <waterSpeed.csv> <waterSpeed.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import numbers, plt, run, where  # noqa: E402

VARIANTS = (("auto", "1", "k-o"), ("auto", "2", "k:s"), ("DILU", "1", "b-^"), ("GAMG", "1", "r-v"))


def draw(rows):
    """A row of panels a scene: time, linear iterations per Newton iteration."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, panels = plt.subplots(len(scenes), 2, figsize=(11, 4 * len(scenes)), squeeze=False)
    for (left, right), scene in zip(panels, scenes):
        for solver, ranks, style in VARIANTS:
            chosen = where(rows, scene=scene, linearSolver=solver, ranks=ranks, finished="1")
            label = f"{solver}, {ranks} rank{'s' if ranks != '1' else ''}"
            cells = numbers(chosen, "cells")
            left.loglog(cells, numbers(chosen, "cpuPerCellHour_us"), style, label=label)
            right.semilogx(
                cells,
                [linear / newton for linear, newton in zip(
                    numbers(chosen, "linearIterations"), numbers(chosen, "nonlinearIterations"))],
                style, label=label)
        left.set_title(f"{scene}: CPU microseconds per cell and hour", fontsize=9)
        right.set_title(f"{scene}: linear iterations per Newton iteration", fontsize=9)
        left.set_xlabel("cells")
        right.set_xlabel("cells")
        left.legend(fontsize=8)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
