"""Chart of waterAccuracy.csv: error over CPU seconds, a panel a measure.

Usage: chart.py <waterAccuracy.csv> <waterAccuracy.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import COLOURS, FLUXES, numbers, plt, run, where  # noqa: E402

# Errors of other codes, of which no CPU time is known, from lowest to highest:
# ParFlow's OverlandFlow on the tilted V is 8 % below 3.946 m3/s after 45 min; in the
# hillside the codes of the comparison differ by 5 to 20 % of the peak of 1.201
# m3/min
PEERS = {
    "tiltedV": ("ParFlow OverlandFlow, 45 min", 0.316, 0.316),
    "saturationExcess": ("between published codes", 0.060, 0.240),
}


def draw(rows):
    """A panel for each case and measure of its error."""
    measures = list(dict.fromkeys((row["case"], row["errorMeasure"]) for row in rows))
    figure, panels = plt.subplots(2, (len(measures) + 1) // 2, figsize=(14, 8))
    for axes, (case, measure) in zip(panels.flat, measures):
        chosen = where(rows, case=case, errorMeasure=measure)
        for flux in ("-", *FLUXES):
            for scheme, line in (("BDF2", "-"), ("BDF1", ":")):
                points = where(chosen, faceMean=flux, timeScheme=scheme)
                if points:
                    axes.loglog(numbers(points, "cpu_s"), numbers(points, "error"), line,
                                marker="o", markersize=3, color=COLOURS.get(flux, "black"),
                                label=f"{flux}, {scheme}")
        if case in PEERS:
            label, low, high = PEERS[case]
            axes.axhspan(low, high * 1.01, color="grey", alpha=0.5, label=label)
            axes.legend(fontsize=6)
        axes.set_title(f"{case}, {measure}", fontsize=8)
        axes.set_xlabel("CPU seconds")
    for axes in panels.flat[len(measures):]:
        axes.axis("off")
    panels.flat[0].legend(fontsize=6, ncol=2)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
