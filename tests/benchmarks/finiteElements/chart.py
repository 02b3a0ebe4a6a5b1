"""Chart of finiteElements.csv: error and mass errors over CPU seconds.

Usage: chart.py <finiteElements.csv> <finiteElements.png>

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from chartTools import plt, run, where  # noqa: E402

STYLES = {
    "finiteVolume": ("finite volumes", "tab:blue", "o"),
    "finiteElements-consistent": ("P1 elements, consistent mass", "tab:red", "s"),
    "finiteElements-lumped": ("P1 elements, lumped mass", "tab:orange", "^"),
}
CASES = {"celia": "dry column", "slope": "validation slope, rain"}


def draw(rows):
    """A column of panels for each case: water content, then the balances."""
    figure, panels = plt.subplots(2, len(CASES), figsize=(10, 8))
    for (case, title), (error, balance) in zip(CASES.items(), panels.T):
        for method, (label, colour, marker) in STYLES.items():
            line = where(rows, case=case, method=method)
            seconds = [float(r["cpu_s"]) for r in line]
            error.loglog(seconds, [float(r["L1theta"]) for r in line],
                         color=colour, marker=marker, label=label)
            sizes = [float(r["size_m"]) for r in line]
            balance.loglog(sizes, [max(float(r["massErrorGlobal"]), 1e-16) for r in line],
                           color=colour, marker=marker, label=label + ", whole domain")
            local = [(s, float(r["massErrorLocal"])) for s, r in zip(sizes, line)
                     if r["massErrorLocal"]]
            if local:
                balance.loglog(*zip(*local), color=colour, marker=marker, linestyle=":",
                               label=label + ", triangle by triangle")
        error.set_title(title)
        error.set_xlabel("CPU seconds")
        error.set_ylabel("mean error of the water content")
        balance.set_xlabel("size of the triangles [m]")
        balance.set_ylabel("relative error of the water balance")
        balance.legend(fontsize=7)
    panels[0, 0].legend(fontsize=8)
    return figure


if __name__ == "__main__":
    run(draw, __doc__)
