# SPDX-License-Identifier: BSD-3-Clause
"""How long ParaView takes for a volume: its first picture, then a slider, the iso slider, a turn of the camera, by the clock
and in processor time (all threads), of each representation that draws surfaces of images.

    . Utilities/env.sh paraview && xvfb-run -a pvpython Testing/Benchmarks/paraview_interaction.py VOLUME ISO [NAME ...]

The volume is anything that ParaView opens; a file's reading counts as part of the first picture.
"""

import sys
import time

from paraview.simple import *

SIZE = [1024, 768]
# Of each representation a slider that changes what is drawn of the marks that are there, and the start of its iso-value's name.
NAMES = {
    "Splatting Lines": ("Phi", "Lines"),
    "Stipple": ("PixelsPerStipple", "Stipple"),
    "Illustration": ("IllustrationPhi", "Illustration"),
}


class Clock:
    def __init__(self):
        self.wall, self.used = time.perf_counter(), time.process_time()

    def __str__(self):
        return f"{time.perf_counter() - self.wall:8.2f} ({time.process_time() - self.used:.2f})"


def draw(view):
    Render(view)
    view.GetRenderWindow().WaitForCompletion()


def measure(path, name, iso_value):
    view = CreateRenderView(ViewSize=SIZE)
    view.OrientationAxesVisibility = 0
    clock = Clock()
    source = OpenDataFile(path)
    source.UpdatePipeline()
    texts = [f"reading{clock}"]
    clock = Clock()
    display = Show(source, view)
    display.SetRepresentationType(name)
    ResetCamera(view)
    draw(view)
    texts.append(f"first picture{clock}")
    slider, prefix = NAMES[name]

    def change(what, **properties):
        clock = Clock()
        for key, value in properties.items():
            setattr(display, key, value)
        draw(view)
        texts.append(f"{what}{clock}")

    clock = Clock()
    view.GetActiveCamera().Azimuth(5)
    draw(view)
    texts.append(f"turn{clock}")
    before = getattr(display, slider)
    change("slider", **{slider: 0.8 * before})
    change("slider again", **{slider: before})
    given = {prefix + "AutomaticIsoValue": 0} if prefix + "AutomaticIsoValue" in display.ListProperties() else {}
    change("iso slider", **given, **{prefix + "IsoValue": iso_value})
    change("iso slider again", **{prefix + "IsoValue": iso_value + 20})
    print(f"{name}: " + ", ".join(texts), flush=True)
    Delete(display)
    Delete(source)
    Delete(view)


if __name__ == "__main__":
    for representation in sys.argv[3:] or NAMES:
        measure(sys.argv[1], representation, float(sys.argv[2]))
