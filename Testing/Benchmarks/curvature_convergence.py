# SPDX-License-Identifier: BSD-3-Clause
"""Draws how the errors of curvature fall with the length of edges: Documentation/images/curvature-convergence.png

    /usr/bin/python3 -E Testing/Benchmarks/curvature_convergence.py build/headless/bin/BenchmarkCurvature

The program measures them on tori (`--convergence`); a dotted line falls with the second power.
"""

import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402

PICTURE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "images" / "curvature-convergence.png"


def measure(program):
    """{mesh: [(points around, k, angle, the paper's k, its angle)]}"""
    output = subprocess.run([program, "--convergence"], check=True, capture_output=True, text=True).stdout
    rows = {}
    for line in output.splitlines()[1:]:
        mesh, points, *errors = line.split()
        rows.setdefault(mesh, []).append((int(points), *map(float, errors)))
    return rows


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    rows = measure(sys.argv[1])
    figure, panels = pyplot.subplots(1, 2, figsize=(9.0, 3.6), dpi=100)
    for axes, column, label in zip(panels, (1, 2), ("k, 1 / world unit", "direction, degrees")):
        for mesh, marker in (("regular", "o"), ("irregular", "s")):
            points = [row[0] for row in rows[mesh]]
            for name, offset in (("jets (default)", 0), ("exponential map", 2)):
                errors = [row[column + offset] for row in rows[mesh]]
                axes.plot(points, errors, marker + ("-" if offset == 0 else "--"), ms=4, lw=0.9, label=f"{name}, {mesh}")
        points = [row[0] for row in rows["regular"]]
        first = 0.4 * rows["regular"][0][column]
        axes.plot(points, [first * (points[0] / n) ** 2 for n in points], "k:", lw=0.9, label="second order")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.xaxis.set_major_locator(ticker.FixedLocator(points))
        axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axes.xaxis.set_minor_locator(ticker.NullLocator())
        axes.set_xlabel("points around the torus", fontsize=8)
        axes.set_ylabel(f"root mean square error of {label}", fontsize=8)
        axes.tick_params(labelsize=7)
        axes.grid(True, lw=0.2)
    panels[1].legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.02, 1), frameon=False)
    figure.tight_layout()
    # Without the version in the file, a repeated run changes no more than the plot.
    figure.savefig(PICTURE, metadata={"Software": None})


if __name__ == "__main__":
    main()
