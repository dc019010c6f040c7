# SPDX-License-Identifier: BSD-3-Clause
"""What brings values back (own defaults, states, traces) brings back exactly these; TestUndo.cxx has the others."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from paraview import smstate, smtrace
from paraview.modules import vtkRemotingServerManager as manager
from rendering import *

# By hand after the preset: one that has the default's value again and not Bone's, and others.
BY_HAND = {"StipplePreset": "Bone", "BoundaryBase": 0.35, "SilhouetteGain": 0.7, "StippleInterior": 0.9, "StippleInkColor": [0, 0, 1]}

# A scene without vtkInk's representations, all that ParaView would trace or save of it.
PLAIN_SCENE = """
from paraview import smstate, smtrace
from paraview.simple import *
smtrace.start_trace(preamble="")
view = CreateRenderView(ViewSize=[100, 100])
for source in (Sphere(), Wavelet(), AppendDatasets(Input=[Sphere()]), Plane()):
    Show(source, view)
Render(view)
print(smtrace.stop_trace())
print(smstate.get_state())
"""


def values(display):
    names = [name for name in display.ListProperties() if re.match("Stipple|K|Gradient|.*Enhancement|ScalarWindow", name)]
    return {name: repr(getattr(display, name)) for name in names}


def assignments(script):
    """Of the drawing's own properties, by name."""
    return dict(re.findall(r"^\w+Display\.((?:Stipple\w*|\w+(?:Base|Gain|Exponent|Enhancement)|\w*ScalarWindow\w*)) = (.*)$", script, re.M))


class TestRestoring(TestInOneView):
    def show(self, **properties):
        display = Show(Wavelet(), self.view)
        display.SetRepresentationType("Stipple")
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def test_own_defaults(self):
        display = self.show(**BY_HAND)
        settings = manager.vtkSMSettings.GetInstance()
        settings.AddCollectionFromString("{}", 10.0)
        settings.SetProxySettings(display.SMProxy)
        try:
            self.assertEqual(values(self.show()), values(display))
        finally:
            settings.ClearAllSettings()

    def test_the_defaults(self):
        display = self.show()
        expected = values(display)
        for name, value in BY_HAND.items():
            setattr(display, name, value)
        self.assertNotEqual(values(display), expected)
        for name in expected:
            display.GetProperty(name).ResetToXMLDefaults()
        display.UpdateVTKObjects()
        self.assertEqual(values(display), expected)

    def test_a_script_says_what_differs_and_no_more(self):
        self.assertEqual(assignments(smstate.get_state()), {})
        display = self.show()
        self.assertEqual(assignments(smstate.get_state()), {})
        display.StipplePreset = "Bone"
        display.StipplePreset = "Anatomy"
        self.assertEqual(assignments(smstate.get_state()), {})
        display.BoundaryBase = 0.65
        self.assertEqual(assignments(smstate.get_state()), {"BoundaryBase": "0.65"})

    def test_a_trace_has_numbers_as_they_are_meant(self):
        display = self.show()
        smtrace.start_trace(preamble="")
        item = smtrace.PropertiesModified(display)  # as the panel records
        display.StipplePreset = "Bone"
        item.finalize()
        script = smtrace.stop_trace()
        found = assignments(script)
        self.assertEqual(found["StipplePreset"], "'Bone'")
        self.assertEqual(found["StippleGradient"], "0.65")
        self.assertEqual(found["StippleInterior"], "0.35")
        self.assertEqual([text for text in found.values() if re.search(r"\.\d{9}", text)], [])
        expected = values(display)
        display.StipplePreset = "Engineering"
        exec("from paraview.simple import *\n" + script, {})
        self.assertEqual(values(display), expected)

    def test_a_window_and_an_iso_value_start_within_the_data(self):
        display = self.show()
        display.UseScalarWindow = True
        low, high = display.ScalarWindow
        self.assertAlmostEqual(low, 37.35, delta=0.1)
        self.assertAlmostEqual(high, 276.83, delta=0.1)
        display.StippleSource = "Iso-Surface"
        self.assertTrue(low < display.StippleIsoValue < high)
        # What was chosen stays, 0 too.
        display.StippleSource = "Automatic"
        display.StippleIsoValue = 100.0
        display.StippleSource = "Iso-Surface"
        self.assertEqual(display.StippleIsoValue, 100.0)
        display.StippleIsoValue = 0.0
        self.assertEqual(assignments(smstate.get_state())["StippleIsoValue"], "0.0")

    def test_scenes_without_the_representations_know_nothing_of_the_plugin(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.py"
            states = [pathlib.Path(folder) / f"{name}.pvsm" for name in ("with", "without")]
            texts = []
            for state, plugins in zip(states, (os.environ["PV_PLUGIN_PATH"], "")):
                scene.write_text(PLAIN_SCENE + f"SaveState({str(state)!r})\n", encoding="utf-8")
                texts.append(self.run_pvpython(scene, plugins))
            # Sources come in any order.
            self.assertEqual(sorted(texts[0].splitlines()), sorted(texts[1].splitlines()))
            self.assertIn("sphere", texts[0])
            load = pathlib.Path(folder) / "load.py"
            load.write_text(
                f"from paraview.simple import *\nLoadState({str(states[0])!r})\nRender(GetViews()[0])\n"
                "print(len(GetSources()))\n", encoding="utf-8"
            )
            self.assertEqual(self.run_pvpython(load, "").split(), ["5"])

    def run_pvpython(self, script, plugins):
        environment = {**os.environ, "PV_PLUGIN_PATH": plugins}
        done = subprocess.run(
            ["pvpython", str(script)], env=environment, capture_output=True, text=True, timeout=100, check=False
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout


if __name__ == "__main__":
    unittest.main()
