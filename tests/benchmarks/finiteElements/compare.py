"""Figures of the comparison of finite volumes with finite elements.

Usage, in the folder of a case:
    compare.py cells <time>          x,y,area,theta,psi of the cells
    compare.py statistics <cpu s>    name=value pairs of the run
    compare.py row <case> <method> <size> <pairs> <cells.csv> <reference.csv> ...
                                     a line of finiteElements.csv

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import glob
import re
import sys

import numpy as np
from scipy.interpolate import LinearNDInterpolator, NearestNDInterpolator

# Places at which profiles are compared, along the longer side of the domain
RESOLUTION = 400


def field(time, name):
    """Values of an ascii volScalarField."""
    with open(f"{time}/{name}", encoding="ascii") as text:
        content = text.read()
    match = re.search(r"internalField\s+nonuniform[^(]*\(([^)]*)\)", content)
    return np.array(match.group(1).split(), dtype=float)


def cells(time):
    """Print the cells of a one-layer mesh."""
    columns = [field(time, name) for name in ("Cx", "Cy", "V", "theta", "psi")]
    np.savetxt(sys.stdout, np.column_stack(columns), delimiter=",",
               header="x,y,area,theta,psi", comments="")


def table(pattern):
    """Columns of a tab-separated table by name."""
    path = sorted(glob.glob(pattern))[-1]
    with open(path, encoding="ascii") as text:
        lines = [line for line in text if not line.startswith("#")]
    names = lines[0].split("\t")
    rows = [line.rstrip("\n").split("\t") for line in lines[1:]]
    return {name.strip(): [row[i] for row in rows] for i, name in enumerate(names)}


def statistics(cpu):
    """Print the figures of a run of overlandRichardsFoam."""
    solver = table("postProcessing/solverStatistics/0/*.dat")
    balance = table("postProcessing/waterBalance/0/*.dat")
    psi = field("86400", "psi")
    start = field("0", "psi") if re.search(
        "nonuniform", open("0/psi", encoding="ascii").read()) else np.array([-10.0])
    print(
        f"cpu_s={cpu}",
        f"nonlinearIterations={sum(int(n) for n in solver['nonlinearIterations'])}",
        f"massErrorReaction={max(float(e) for e in balance['relativeError'])}",
        f"undershoot={max(0.0, start.min() - psi.min())}",
    )


def compared(own, references):
    """Mean of |theta - reference| over the domain, the worst and the mean of
    the references' own distances included nowhere: each reference counts the
    same."""
    lower = own[:, :2].min(axis=0)
    upper = own[:, :2].max(axis=0)
    spacing = (upper - lower).max() / RESOLUTION
    x, y = np.meshgrid(*(np.arange(a + spacing / 2, b, spacing) for a, b in zip(lower, upper)))
    places = np.column_stack((x.ravel(), y.ravel()))

    def sampled(data):
        linear = LinearNDInterpolator(data[:, :2], data[:, 3])(places)
        nearest = NearestNDInterpolator(data[:, :2], data[:, 3])(places)
        return np.where(np.isfinite(linear), linear, nearest)

    # Places outside the domain: the slope's corner of air
    fine = references[0]
    distance = NearestNDInterpolator(fine[:, :2], np.arange(len(fine)))(places)
    inside = np.linalg.norm(fine[distance.astype(int), :2] - places, axis=1) \
        < 2 * np.sqrt(fine[:, 2].max())
    mean = sum(sampled(reference) for reference in references) / len(references)
    return np.abs(sampled(own) - mean)[inside].mean()


def row(case, method, size, pairs, own_file, *reference_files):
    """Print a line of the table."""
    figures = dict(pair.split("=") for pair in pairs.split())
    own = np.loadtxt(own_file, delimiter=",", skiprows=1)
    references = [np.loadtxt(f, delimiter=",", skiprows=1) for f in reference_files]
    print(
        case, method, size, len(own), figures.get("nodes", len(own)),
        f"{float(figures['cpu_s']):.3g}", figures["nonlinearIterations"],
        f"{compared(own, references):.3e}",
        f"{float(figures['massErrorReaction']):.1e}",
        figures.get("massErrorGradient", ""),
        figures.get("massErrorLocal", ""),
        f"{float(figures['undershoot']):.3g}",
        sep=",",
    )


if __name__ == "__main__":
    command, *arguments = sys.argv[1:]
    {"cells": cells, "statistics": statistics, "row": row}[command](*arguments)
