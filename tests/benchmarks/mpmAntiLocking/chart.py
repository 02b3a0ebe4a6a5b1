"""Safety factor over cell size for each average against locking.

Usage: chart.py <mpmAntiLocking.csv> <mpmAntiLocking.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from chartTools import numbers, plt, read, save, where  # noqa: E402


def main(source, target):
    """A panel for each state and flow rule."""
    notes, rows = read(source)
    figure, panels = plt.subplots(2, 2, figsize=(9, 7), sharex=True)
    for i, dilation in enumerate(("none", "associated")):
        for j, state in enumerate("ab"):
            axes = panels[i][j]
            for average in ("none", "node", "cell"):
                here = where(
                    rows, state=state, dilation=dilation, antiLocking=average
                )
                axes.plot(
                    numbers(here, "cellSize_m"),
                    numbers(here, "safetyFactorCrest"),
                    marker="o",
                    label=f"antiLocking {average}",
                )
            axes.axhline(
                numbers(where(rows, state=state), "bishop")[0],
                color="black",
                linestyle=":",
                label="Bishop",
            )
            axes.set_title(f"state {state}, dilation {dilation}", fontsize=9)
            axes.set_xlabel("cell size [m]")
            axes.set_ylabel("safety factor (crest)")
            axes.set_xlim(left=0)
    panels[0][0].legend(fontsize=7)
    save(figure, notes, target)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
