"""Chart of mpmScaling.csv: what more ranks bring, and what messages cost.

Usage: chart.py <mpmScaling.csv> <mpmScaling.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)


def read(path):
    """Rows of the table, and what its comments say."""
    with open(path, encoding="utf-8") as table:
        lines = table.read().splitlines()
    notes = [line[2:] for line in lines if line.startswith("#")]
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return notes, [
        {k: v if k == "mode" else float(v) for k, v in row.items()}
        for row in rows
    ]


def best(rows, mode, dim, column):
    """The smallest of the rounds for each number of ranks."""
    found = {}
    for row in rows:
        if row["mode"] == mode and row["dim"] == dim:
            ranks = row["ranks"]
            found[ranks] = min(found.get(ranks, row[column]), row[column])
    return found


def main(source, target):
    """Speed-up of one column, efficiency of columns that grow, messages."""
    notes, rows = read(source)
    figure, (strong, weak, messages) = plt.subplots(1, 3, figsize=(12, 4))
    for dim, colour in ((2, "tab:blue"), (3, "tab:red")):
        for column, line, what in (
            ("wall_s", "o-", "wall clock"),
            ("computeMax_s", "s--", "busiest rank without messages"),
        ):
            label = f"{dim}-D, {what}"
            values = best(rows, "strong", dim, column)
            ranks = sorted(values)
            strong.plot(
                ranks,
                [values[1.0] / values[r] for r in ranks],
                line,
                color=colour,
                label=label,
            )
            values = best(rows, "weak", dim, column)
            weak.plot(
                ranks,
                [values[1.0] / values[r] for r in ranks],
                line,
                color=colour,
                label=label,
            )
        share = best(rows, "strong", dim, "messageWallShare")
        ranks = sorted(share)
        messages.plot(
            ranks,
            [100 * share[r] for r in ranks],
            "o-",
            color=colour,
            label=f"{dim}-D",
        )
    strong.set_ylabel("speed-up of one column")
    weak.set_ylabel("efficiency, points a rank constant")
    messages.set_ylabel("wall clock in messages, waiting included [%]")
    for axes in (strong, weak, messages):
        axes.set_xlabel("ranks")
        axes.set_ylim(bottom=0)
        axes.legend(fontsize=7)
    figure.suptitle("; ".join(notes), fontsize=8)
    figure.tight_layout()
    figure.savefig(target, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
