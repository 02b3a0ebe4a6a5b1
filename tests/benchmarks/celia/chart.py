"""Chart of celia.csv: errors over CPU seconds, with other codes' points.

Usage: chart.py <celia.csv> <celia.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import COLOURS, FLUXES, draw_peers, numbers, plt, run, where  # noqa: E402


def draw(rows):
    """Error of the front, and of the water content."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 5))
    for axes, column, label in (
        (panels[0], "frontError_cm", "error of the front [cm]"),
        (panels[1], "L1theta", "mean error of the water content"),
    ):
        for flux in FLUXES:
            for scheme, line in (("BDF2", "-"), ("BDF1", ":")):
                chosen = where(rows, faceMean=flux, timeScheme=scheme)
                axes.loglog(
                    numbers(chosen, "cpu_s"),
                    [abs(e) for e in numbers(chosen, column)],
                    line, marker="o", markersize=3, color=COLOURS[flux],
                    label=f"{flux}, {scheme}",
                )
        draw_peers(axes, "celia", column)
        axes.set_xlabel("CPU seconds, start-up included")
        axes.set_ylabel(label)
    panels[1].legend(fontsize=6, ncol=2)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
