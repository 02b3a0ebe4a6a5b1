"""Chart of celia.csv: errors over CPU seconds, with other codes' points.

Usage: chart.py <celia.csv> <celia.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import COLOURS, FLUXES, numbers, plt, run, where  # noqa: E402

# Other codes on this problem, N = 40, 100, 400: CPU seconds, |error of the
# front| in cm, mean error of theta; measured on a machine of two cores
PEERS = {
    "ParFlow (upwind)": ((0.57, 7.8, 3.3e-3), (1.04, 3.6, 1.5e-3), (3.4, 1.1, 4.1e-4)),
    "groundwaterFoam": ((0.28, 2.6, 8.1e-4), (0.40, 0.75, 2.4e-4), (1.9, 0.14, 4.0e-5)),
    "RichardsFoam3": ((0.85, 2.6, 9.4e-4), (0.96, 0.82, 3.4e-4), (1.3, 0.26, 1.3e-4)),
}


def draw(rows):
    """Error of the front, and of the water content."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 5))
    for axes, column, peer, label in (
        (panels[0], "frontError_cm", 1, "error of the front [cm]"),
        (panels[1], "L1theta", 2, "mean error of the water content"),
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
        for marker, (name, points) in zip("*Pd", PEERS.items()):
            axes.loglog([p[0] for p in points], [p[peer] for p in points],
                        "--", marker=marker, color="black", linewidth=0.7, label=name)
        axes.set_xlabel("CPU seconds, start-up included")
        axes.set_ylabel(label)
    panels[1].legend(fontsize=6, ncol=2)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
