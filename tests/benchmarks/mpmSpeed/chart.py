"""Chart of mpmSpeed.csv: particle-steps a second over the number of points.

Usage: chart.py <mpmSpeed.csv> <mpmSpeed.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)

GATES = {2: 15, 3: 6}  # million particle-steps a second and core


def read(path):
    """Rows of the table, and what its comments say."""
    with open(path, encoding="utf-8") as table:
        lines = table.read().splitlines()
    notes = [line[2:] for line in lines if line.startswith("#")]
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return notes, [{k: float(v) for k, v in row.items()} for row in rows]


def main(source, target):
    """Draw one line for each dimension and number of threads."""
    notes, rows = read(source)
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for dim, colour in ((2, "tab:blue"), (3, "tab:red")):
        for threads in sorted({row["threads"] for row in rows}):
            line = [
                row
                for row in rows
                if row["dim"] == dim and row["threads"] == threads
            ]
            axes.plot(
                [row["points"] for row in line],
                [row["Mps"] for row in line],
                color=colour,
                marker="o" if threads == 1 else "s",
                linestyle="-" if threads == 1 else "--",
                label=f"{dim}-D, {threads:.0f} thread(s)",
            )
        axes.axhline(GATES[dim], color=colour, linewidth=0.8, linestyle=":")
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("points")
    axes.set_ylabel("million particle-steps a second")
    axes.set_title("; ".join(notes), fontsize=8)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(target, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
