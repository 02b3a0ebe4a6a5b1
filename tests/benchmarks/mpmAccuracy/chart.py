"""Chart of mpmAccuracy.csv: error against processor time, with the front.

Usage: chart.py <mpmAccuracy.csv> <mpmAccuracy.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import plt, run, where  # noqa: E402


COLOURS = {
    "APIC": "tab:blue",
    "TPIC": "tab:cyan",
    "AFLIP": "tab:green",
    "FLIP": "tab:orange",
    "XPIC": "tab:red",
    "PIC": "tab:gray",
}
MARKERS = {
    "quadraticBSpline": "o",
    "cubicBSpline": "s",
    "linear": "x",
    "uGIMP": "^",
    "cpGIMP": "v",
}


def front(points):
    """Those points that no other beats in both time and error."""
    best = []
    for time, error, name in sorted(points):
        if not best or error < best[-1][1]:
            best.append((time, error, name))
    return best


def draw(rows):
    """One panel a case."""
    cases = list(dict.fromkeys(row["case"] for row in rows))
    figure, panels = plt.subplots(2, 4, figsize=(19, 9))
    for axes, case in zip(panels.flat, cases):
        points = []
        for row in where(rows, case=case, failed="0"):
            time = max(float(row["cpu_s"]), 1e-4)
            error = float(row["error"])
            name = f"{row['shape']} {row['transfer']} {row['update']}"
            points.append((time, error, name))
            axes.scatter(
                time,
                error,
                color=COLOURS[row["transfer"]],
                marker=MARKERS[row["shape"]],
                s=22,
                alpha=0.7,
            )
        best = front(points)
        axes.plot([p[0] for p in best], [p[1] for p in best], "k-", lw=1)
        axes.annotate(best[-1][2], best[-1][:2], fontsize=7)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(case + (" (against finer cells)" if case == "collapse" else ""))
        axes.set_xlabel("processor seconds")
        axes.set_ylabel("error")
    for axes in panels.flat[len(cases):]:
        axes.axis("off")
    legend = panels.flat[-1]
    for transfer, colour in COLOURS.items():
        legend.scatter([], [], color=colour, label=transfer)
    for shape, marker in MARKERS.items():
        legend.scatter([], [], color="k", marker=marker, label=shape)
    legend.plot([], [], "k-", label="front of the best choices")
    legend.legend(loc="center")
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
