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
BY_HAND = {
    "Stipple": {"StipplePreset": "Bone", "BoundaryBase": 0.35, "SilhouetteGain": 0.7, "StippleInterior": 0.9, "StippleInkColor": [0, 0, 1]},
    "Illustration": {"IllustrationPreset": "Bone", "IllustrationDistance": 0.15, "IllustrationTau": 0.95, "IllustrationStippleSize": 3.3,
                     "IllustrationInkColor": [0, 0, 1], "IllustrationSeeThrough": 1},
    "Contours": {"ContoursPreset": "Glass", "ContoursLineWidth": 2.5, "ContoursTaper": 0.4, "ContoursHiddenLines": "Dashed",
                 "ContoursInkColor": [0, 0, 1], "ContoursFaceted": 1},
    "Line Art": {"LineArtPreset": "Sketch", "LineArtDensity": 0.6, "LineArtTone": 0.7, "LineArtLength": 25.0, "LineArtDepthWidth": 0.6,
                 "LineArtInkColor": [0, 0, 1], "LineArtSeeding": 1},
}
# What range a slider has is no matter of how many lines there are.
FEW_LINES = {"Line Art": {"LineArtDensity": 0, "LineArtLineSpacing": 16, "LineArtSubdivision": 1}}
OWN = {"Stipple": "(?:Stipple|K|Gradient|.*Enhancement|ScalarWindow)", "Illustration": "Illustration", "Contours": "Contours", "Line Art": "LineArt"}

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

# Images of which no array is active: vectors, others, and the distance from the middle.
EXTENT = """
executive = self.GetExecutive()
executive.GetOutputInformation(0).Set(executive.WHOLE_EXTENT(), 0, 20, 0, 20, 0, 20)
"""
INACTIVE = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
image = self.GetOutputDataObject(0)
image.SetExtent(0, 20, 0, 20, 0, 20)
z, y, x = np.mgrid[-10:11, -10:11, -10:11]
for name, values in (("Axes", np.stack((x, y, z), 3).reshape(-1, 3)), ("an other", x.ravel()), ("Distance", np.sqrt(x * x + y * y + z * z).ravel())):
    array = numpy_to_vtk(values.astype("float32"), deep=1)
    array.SetName(name)
    image.GetPointData().AddArray(array)
"""


def values(display):
    # A property compares as its value, but is no key.
    own = next(pattern for style, pattern in OWN.items() if display.Representation == style)
    names = [name for name in display.ListProperties() if re.match(own, name)]
    return {name: repr(getattr(display, name)) for name in names}


def assignments(script):
    """Of the drawing's own properties, by name."""
    return dict(re.findall(r"^\w+Display\.((?:Stipple\w*|Contours\w*|Illustration\w*|LineArt\w*|Lines\w*|\w+(?:Base|Gain|Exponent|Enhancement)|\w*ScalarWindow\w*)) = (.*)$", script, re.M))


class TestRestoring(TestInOneView):
    def show(self, style="Stipple", **properties):
        display = Show(Wavelet(), self.view)
        display.SetRepresentationType(style)
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def test_own_defaults(self):
        for style, by_hand in BY_HAND.items():
            with self.subTest(style):
                display = self.show(style, **by_hand)
                settings = manager.vtkSMSettings.GetInstance()
                settings.AddCollectionFromString("{}", 10.0)
                settings.SetProxySettings(display.SMProxy)
                try:
                    self.assertEqual(values(self.show(style)), values(display))
                finally:
                    settings.ClearAllSettings()

    def test_the_defaults(self):
        for style, by_hand in BY_HAND.items():
            with self.subTest(style):
                display = self.show(style)
                expected = values(display)
                for name, value in by_hand.items():
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

    def test_a_script_of_an_illustration_says_what_differs_and_no_more(self):
        display = self.show("Illustration")
        self.assertEqual(assignments(smstate.get_state()), {})
        display.IllustrationPreset = "Vessel"
        self.assertEqual(display.IllustrationTau, 0.995)
        display.IllustrationPreset = "Specimen"
        self.assertEqual(assignments(smstate.get_state()), {})
        # Nor what the slider shows of an automatic value, of what is not seen from within.
        self.view.ResetCamera()
        Render(self.view)
        shown = display.IllustrationIsoValue
        self.assertNotEqual(shown, 0.0)
        self.assertEqual(assignments(smstate.get_state()), {})
        display.IllustrationIsoValue = 200.0
        self.assertEqual(assignments(smstate.get_state()), {"IllustrationAutomaticIsoValue": "0", "IllustrationIsoValue": "200.0"})
        display.IllustrationAutomaticIsoValue = 1
        Render(self.view)
        self.assertEqual(display.IllustrationIsoValue, shown)
        self.assertEqual(assignments(smstate.get_state()), {})
        display.IllustrationTau = 0.95
        self.assertEqual(assignments(smstate.get_state()), {"IllustrationTau": "0.95"})

    def test_a_script_of_contours_says_what_differs_and_no_more(self):
        display = self.show("Contours")
        self.assertEqual(assignments(smstate.get_state()), {})
        display.ContoursPreset = "Brush"
        self.assertEqual(display.ContoursLineWidth, 6.0)
        display.ContoursPreset = "Pen"
        self.assertEqual(assignments(smstate.get_state()), {})
        display.ContoursTaper = 0.5
        self.assertEqual(assignments(smstate.get_state()), {"ContoursTaper": "0.5"})

    def test_a_script_of_line_art_says_what_differs_and_no_more(self):
        display = self.show("Line Art")
        self.assertEqual(assignments(smstate.get_state()), {})
        display.LineArtPreset = "Technical"
        self.assertEqual(display.LineArtDensity, 0.75)
        display.LineArtPreset = "Engraving"
        self.assertEqual(assignments(smstate.get_state()), {})
        display.LineArtTone = 0.7
        self.assertEqual(assignments(smstate.get_state()), {"LineArtTone": "0.7"})

    def test_a_state_brings_a_drawing_back(self):
        for style in ("Illustration", "Contours", "Line Art"):
            with self.subTest(style):
                display = self.show(style, **BY_HAND[style])
                expected = values(display)
                with tempfile.TemporaryDirectory() as folder:
                    file = str(pathlib.Path(folder) / "state.pvsm")
                    SaveState(file)
                    for source in GetSources().values():
                        Delete(source)
                    LoadState(file)
                source = next(iter(GetSources().values()))
                self.view = next(view for view in GetViews() if GetRepresentation(source, view))
                self.assertEqual(values(GetRepresentation(source, self.view)), expected)
                Delete(source)

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
        contours = self.show("Contours", ContoursMethod="Segments Through Voxels")
        self.assertAlmostEqual(contours.ContoursValueRange[0], low, delta=0.1)
        self.assertAlmostEqual(contours.ContoursValueRange[1], high, delta=0.1)
        for style, prefix in (("Illustration", "Illustration"), ("Splatting Lines", "Lines"), ("Contours", "Contours"),
                              ("Line Art", "LineArt")):
            other = self.show(style)
            self.assertEqual(assignments(smstate.get_state()).keys() & {f"{prefix}IsoValue", f"{prefix}Scalars"}, set())
            setattr(other, f"{prefix}AutomaticIsoValue", 0)
            self.assertTrue(low < getattr(other, f"{prefix}IsoValue") < high, style)
            limits = other.GetProperty(f"{prefix}IsoValue").SMProperty.GetDomain("range")
            self.assertAlmostEqual(limits.GetMinimum(0), low, delta=0.1)
            self.assertAlmostEqual(limits.GetMaximum(0), high, delta=0.1)
        display.StippleIsoValue = 0.0
        self.assertEqual(assignments(smstate.get_state())["StippleIsoValue"], "0.0")

    def test_sliders_of_iso_values_have_the_range_of_what_is_drawn(self):
        # Also after a picture, and without an active array: as files of other programs.
        inactive = ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=EXTENT, Script=INACTIVE)
        for source, low, high in ((Wavelet(), 37.35, 276.83), (inactive, 0.0, 17.32)):
            for style, prefix in (("Illustration", "Illustration"), ("Splatting Lines", "Lines"), ("Contours", "Contours"),
                                  ("Line Art", "LineArt")):
                display = Show(source, self.view)
                display.SetRepresentationType(style)
                SetProperties(display, **FEW_LINES.get(style, {}))
                self.view.ResetCamera()
                Render(self.view)
                limits = display.GetProperty(f"{prefix}IsoValue").SMProperty.GetDomain("range")
                self.assertAlmostEqual(limits.GetMinimum(0), low, delta=0.1, msg=style)
                self.assertAlmostEqual(limits.GetMaximum(0), high, delta=0.1, msg=style)
                value = getattr(display, f"{prefix}IsoValue")
                self.assertTrue(low < value < high, (style, value))
                self.assertNotIn(f"{prefix}Scalars", assignments(smstate.get_state()))
                self.assertGreater(ink(picture(self.view)), 100.0, style)
                Hide(source, self.view)

    def test_another_array_is_drawn_with_its_range(self):
        calculator = Calculator(Input=Wavelet(), Function="coordsX * coordsX + coordsY * coordsY", ResultArrayName="Tube")
        for style, prefix in (("Illustration", "Illustration"), ("Splatting Lines", "Lines"), ("Contours", "Contours"),
                              ("Line Art", "LineArt")):
            display = Show(calculator, self.view)
            display.SetRepresentationType(style)
            SetProperties(display, **FEW_LINES.get(style, {}))
            self.view.ResetCamera()
            drawn = {}
            for array, low, high in (("RTData", 37.35, 276.83), ("Tube", 0.0, 200.0), ("RTData", 37.35, 276.83)):
                setattr(display, f"{prefix}Scalars", ["POINTS", array])
                image = picture(self.view)
                self.assertGreater(ink(image), 100.0, style)
                numpy.testing.assert_array_equal(drawn.setdefault(array, image), image)
                limits = display.GetProperty(f"{prefix}IsoValue").SMProperty.GetDomain("range")
                self.assertAlmostEqual(limits.GetMinimum(0), low, delta=0.1, msg=style)
                self.assertAlmostEqual(limits.GetMaximum(0), high, delta=0.1, msg=style)
                value = getattr(display, f"{prefix}IsoValue")
                self.assertTrue(low < value < high, (style, array, value))
            self.assertTrue((drawn["RTData"] != drawn["Tube"]).any(), style)
            self.assertEqual(assignments(smstate.get_state())[f"{prefix}Scalars"], "['POINTS', 'RTData']")
            Hide(calculator, self.view)

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
