"""Chart of paperSoil.csv: iterations and infiltration over the cells.

Usage: chart.py <paperSoil.csv> <paperSoil.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import COLOURS, FLUXES, numbers, plt, run, where  # noqa: E402



def draw(rows):
    """Iterations of the default flux; what the others do on 100 cells."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 5))
    cases = sorted({row["case"] for row in rows})
    for case in cases:
        chosen = where(rows, case=case, faceMean="monotone")
        panels[0].loglog(numbers(chosen, "cells"), numbers(chosen, "nonlinearIterations"),
                         marker="o", label=case)
    panels[0].set_xlabel("cells")
    panels[0].set_ylabel("Newton iterations of the default flux")
    panels[0].legend(fontsize=7)
    width = 0.8 / len(FLUXES)
    for i, flux in enumerate(FLUXES):
        for j, case in enumerate(cases):
            for row in where(rows, case=case, faceMean=flux, cells="100"):
                done = row["finished"] == "1"
                panels[1].bar(j + i * width, float(row["cpu_s"]), width, color=COLOURS[flux],
                              hatch="" if done else "xx", edgecolor="black", linewidth=0.3,
                              label=flux if j == 0 else None)
    panels[1].set_yscale("log")
    panels[1].set_xticks([j + 0.4 for j in range(len(cases))], cases, rotation=30, fontsize=7)
    panels[1].set_ylabel("CPU seconds, 100 cells; crossed: not finished")
    panels[1].legend(fontsize=7)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
