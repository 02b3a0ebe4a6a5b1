"""What the charts of the benchmarks share.

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)

FLUXES = ("monotone", "integralMean", "integralUpwind", "upwind", "arithmetic", "geometric")
BENCHMARKS = pathlib.Path(__file__).resolve().parent
COLOURS = dict(zip(FLUXES, plt.rcParams["axes.prop_cycle"].by_key()["color"]))


def read(path):
    """Rows of a table, and what its comments say."""
    with open(path, encoding="utf-8") as table:
        lines = table.read().splitlines()
    notes = [line[2:] for line in lines if line.startswith("#")]
    return notes, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def numbers(rows, name):
    """A column as numbers; an empty field is not a number."""
    return [float(row[name]) if row[name] else float("nan") for row in rows]


def where(rows, **values):
    """The rows in which these columns have these values."""
    return [row for row in rows if all(row[k] == v for k, v in values.items())]


def draw_peers(axes, case, measure):
    """Other codes' points of peers.csv, as a grey band where no CPU time is known."""
    rows = where(read(BENCHMARKS / "peers.csv")[1], case=case, errorMeasure=measure)
    for marker, code in zip("*PdXs", dict.fromkeys(row["code"] for row in rows)):
        points = where(rows, code=code)
        times = numbers(points, "cpu_s")
        lows, highs = numbers(points, "errorLow"), numbers(points, "errorHigh")
        if any(time == time for time in times):
            axes.loglog(times, highs, "--", marker=marker, color="black", linewidth=0.7, label=code)
        else:
            axes.axhspan(min(lows), 1.01 * max(highs), color="grey", alpha=0.5,
                         label=f"{code}, time not known")


def save(figure, notes, target):
    """Title, layout and file of a figure."""
    figure.suptitle("; ".join(notes), fontsize=7)
    figure.tight_layout()
    figure.savefig(target, dpi=110)


def run(draw, description):
    """The command line of a chart: table and picture."""
    if len(sys.argv) != 3:
        raise SystemExit(description)
    notes, rows = read(sys.argv[1])
    save(draw(rows), notes, sys.argv[2])
