"""Chart of waterAccuracy.csv, and celia.csv: error over CPU seconds, a panel a measure.

Other codes' points come from ../peers.csv.

Usage: chart.py <waterAccuracy.csv> <waterAccuracy.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import BENCHMARKS, COLOURS, FLUXES, draw_peers, numbers, plt, read, run, where  # noqa: E402

CELIA = BENCHMARKS / "results" / "celia.csv"


def draw(rows):
    """A panel for each case and measure of its error."""
    rows = rows + [
        {**row, "case": "celia", "errorMeasure": "L1theta", "error": row["L1theta"]}
        for row in read(CELIA)[1]
    ]
    measures = list(dict.fromkeys((row["case"], row["errorMeasure"]) for row in rows))
    figure, panels = plt.subplots(2, len(measures) // 2 + 1, figsize=(16, 8))
    lines = {}
    for axes, (case, measure) in zip(panels.flat, measures):
        chosen = where(rows, case=case, errorMeasure=measure)
        for flux in ("-", *FLUXES):
            for scheme, line in (("BDF2", "-"), ("BDF1", ":")):
                points = where(chosen, faceMean=flux, timeScheme=scheme)
                if points:
                    axes.loglog(numbers(points, "cpu_s"), numbers(points, "error"), line,
                                marker="o", markersize=3, color=COLOURS.get(flux, "black"),
                                label=f"{flux}, {scheme}")
        lines.update(zip(*reversed(axes.get_legend_handles_labels())))
        schemes = len(axes.get_legend_handles_labels()[0])
        draw_peers(axes, case, measure)
        peers = [part[schemes:] for part in axes.get_legend_handles_labels()]
        if peers[0]:
            axes.legend(*peers, fontsize=6)
        axes.set_title(f"{case}, {measure}" + " (of celia.csv)" * (case == "celia"), fontsize=8)
        axes.set_xlabel("CPU seconds")
        axes.set_ylabel("error")
        axes.tick_params(which="both", labelsize=6)
    for axes in panels.flat[len(measures):]:
        axes.axis("off")
    panels.flat[len(measures)].legend(lines.values(), lines.keys(), loc="center")
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
