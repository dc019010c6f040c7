# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Tradeoff programs of a build and writes what they measure into the documentation.

    tradeoff.py PROGRAM...             writes Documentation/accuracy-and-speed.md and its plots
    tradeoff.py --update PROGRAM...    keeps what the page says of other programs' knobs

Each program prints rows of CSV: a knob's settings with their error in some scenes and their time. The default setting
and the advice come from the program, too, beside the definition of the knob.
"""

import csv
import io
import math
import pathlib
import re
import subprocess
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "Documentation" / "accuracy-and-speed.md"
IMAGES = PAGE.parent / "images"

INTRODUCTION = """<!-- SPDX-License-Identifier: BSD-3-Clause -->
# Accuracy and speed

Where faster means less exact, both ends are offered, and the default sits at the knee: the setting beyond which a little
more accuracy costs much more time, or a little more speed much more error. This page is written by

    make tradeoff

Errors are measured against analytic shapes. Times are processor times on one thread, the least of several runs that take
turns; they are given relative to the default's, because ratios travel to other machines and times do not.
"""


def measure(programs):
    """All knobs, each with its settings in order: {knob: {setting: [row of each scene]}}."""
    knobs = {}
    for program in programs:
        print(f"tradeoff: {pathlib.Path(program).name}", flush=True)
        output = subprocess.run([program], check=True, capture_output=True, text=True).stdout
        for row in csv.DictReader(io.StringIO(output)):
            row["error"], row["ms"] = float(row["error"]), float(row["ms"])
            knobs.setdefault(row["knob"], {}).setdefault(row["setting"], []).append(row)
    return knobs


def default_of(knob, settings):
    names = [name for name, rows in settings.items() if rows[0]["default"] == "yes"]
    if len(names) != 1:
        sys.exit(f"tradeoff: the knob {knob!r} has {len(names)} default settings, expected 1")
    return names[0]


def number(value):
    """Two significant digits, without an exponent where people would not write one."""
    text = f"{value:.2g}"
    return f"{value:.0f}" if "e+" in text else text


def image_name(knob):
    return "tradeoff-" + re.sub(r"[^a-z0-9]+", "-", knob.lower()).strip("-") + ".png"


def spread(places, least):
    """Places in their order, moved apart to at least that distance, as little as possible."""
    order = sorted(range(len(places)), key=places.__getitem__)
    groups = []  # of neighbors that touch: the mean place, and how many
    for i in order:
        groups.append([places[i], 1])
        while len(groups) > 1 and groups[-1][0] - groups[-2][0] < least * (groups[-1][1] + groups[-2][1]) / 2:
            place, count = groups.pop()
            groups[-1][0] = (groups[-1][0] * groups[-1][1] + place * count) / (groups[-1][1] + count)
            groups[-1][1] += count
    apart = [place + least * (n - (count - 1) / 2) for place, count in groups for n in range(count)]
    return [apart[order.index(i)] for i in range(len(places))]


def draw(knob, settings, default):
    scenes = [row["scene"] for row in settings[default]]
    base = settings[default][0]["ms"]
    figure, axes = pyplot.subplots(figsize=(8.0, 3.8), dpi=100)
    for n, scene in enumerate(scenes):
        times = [rows[n]["ms"] / base for rows in settings.values()]
        errors = [rows[n]["error"] for rows in settings.values()]
        order = sorted(range(len(times)), key=times.__getitem__)
        (line,) = axes.plot([times[i] for i in order], [errors[i] for i in order], "o-", ms=4, lw=0.8, label=scene)
        knee = list(settings).index(default)
        axes.plot(times[knee], errors[knee], "o", ms=11, mfc="none", mec=line.get_color(), mew=1.5)
    for rows in settings.values():
        axes.axvline(rows[0]["ms"] / base, color="black", lw=0.3, zorder=0)
    axes.set_xscale("log")
    if all(row["error"] > 0 for rows in settings.values() for row in rows):
        axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)) if axis.get_scale() == "log" else ticker.AutoLocator())
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(ticker.NullFormatter())
    axes.margins(x=0.1, y=0.1)
    axes.set_xlabel("time, default = 1", fontsize=8)
    unit = textwrap.wrap(settings[default][0]["error_unit"], 44)
    axes.set_ylabel("\n".join(unit if len(unit) <= 4 else ["error"]), fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(True, axis="y", lw=0.2)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.02, 1), frameon=False)
    label_times(axes, {name: rows[0]["ms"] / base for name, rows in settings.items()}, default)
    figure.tight_layout()
    path = IMAGES / image_name(knob)
    # Without the version and the date in the file, a repeated run changes no more than the plot.
    figure.savefig(path, metadata={"Software": None})
    pyplot.close(figure)
    return path


def label_times(axes, times, default):
    """The settings' names stand above the plot, tilted and moved apart, so that near neighbors do not cover each other."""
    low, high = (math.log(limit) for limit in axes.get_xlim())
    shares = [(math.log(time) - low) / (high - low) for time in times.values()]
    places = spread(shares, 0.033)
    height = 3 if places == shares else 11
    for name, share, at in zip(times, shares, places):
        label = f"{name} (default)" if name == default else name
        axes.annotate(label, (at, 1), (0, height), "axes fraction", "offset points", rotation=28, fontsize=7)
        if places != shares:
            axes.plot([share, at], [1, 1.04], color="black", lw=0.3, transform=axes.transAxes, clip_on=False)


def section(knob, settings):
    default = default_of(knob, settings)
    base = settings[default][0]["ms"]
    first = settings[default][0]
    scenes = [row["scene"] for row in settings[default]]
    picture = draw(knob, settings, default)
    lines = [
        f"\n## {knob}\n",
        f"**Advice.** {first['advice']}\n",
        f"Error: {first['error_unit']}. Time: {first['work']}, {number(base)} ms at the default.\n",
        "| setting | time | " + " | ".join(scenes) + " |",
        "|---|---|" + "---|" * len(scenes),
    ]
    for name, rows in settings.items():
        mark = "**" if name == default else ""
        title = f"**{name} (default)**" if name == default else name
        cells = [number(row["error"]) for row in rows]
        lines.append(f"| {title} | {mark}{number(rows[0]['ms'] / base)}{mark} | " + " | ".join(cells) + " |")
    lines.append(f"\n![Error against time: {knob}](images/{picture.name})\n")
    return "\n".join(lines)


def updated(sections):
    """All sections that the page has, in its order, the given ones new; those that it lacks follow the one before."""
    parts = re.split(r"(?=\n## )", PAGE.read_text())[1:]
    page = {part.splitlines()[1].removeprefix("## "): part for part in parts}
    before = None
    for knob, text in sections.items():
        if knob not in page:
            names = list(page)
            at = names.index(before) + 1 if before else len(names)
            page = {name: page.get(name, text) for name in [*names[:at], knob, *names[at:]]}
        page[knob] = text
        before = knob
    return page


def main():
    programs = [argument for argument in sys.argv[1:] if argument != "--update"]
    if not programs:
        sys.exit(__doc__)
    knobs = measure(programs)
    IMAGES.mkdir(exist_ok=True)
    sections = {knob: section(knob, settings) for knob, settings in knobs.items()}
    if "--update" in sys.argv:
        sections = updated(sections)
    PAGE.write_text(INTRODUCTION + "".join(sections.values()))
    print(f"tradeoff: {len(knobs)} knobs in {PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
