# SPDX-License-Identifier: BSD-3-Clause
"""The stipple mapper and its controls as a programmer meets them: copies, names, numbers out of range."""

import math

import pytest

vtkink = pytest.importorskip("vtkink")


def parameters(mapper):
    """Names of the class's own properties; another mapper that draws over it is none."""
    own = set(dir(mapper)) - set(dir(vtkink.vtk.vtkPolyDataMapper)) - {"SetOverlay"}
    return sorted(name[3:] for name in own if name.startswith("Set") and f"Get{name[3:]}" in own)


def printed(mapper):
    """What PrintSelf says of the class's own properties."""
    lines = (line.split(": ", 1) for line in str(mapper).splitlines() if ": " in line)
    return {name.strip(): value for name, value in lines if name.strip() in parameters(mapper)}


def change(mapper, name):
    """Gives a property another value than it has."""
    before = getattr(mapper, f"Get{name}")()
    if isinstance(before, bool):
        after = not before
    elif isinstance(before, tuple):
        after = (0.125, 0.25, 0.375)
    else:
        least, most = (getattr(mapper, f"Get{name}{end}Value")() for end in ("Min", "Max"))
        after = least if before != least else most
        if isinstance(before, float) and most < 1e30:
            after = 0.75 * least + 0.25 * most
    getattr(mapper, f"Set{name}")(after)
    assert getattr(mapper, f"Get{name}")() == after != before, name


def messages_of(what):
    messages = []
    for event in ("ErrorEvent", "WarningEvent"):
        what.AddObserver(event, record(messages))
    return messages


def record(messages):
    def observe(_caller, _event, text):
        messages.append(text)

    observe.CallDataType = "string0"
    return observe


def test_shallow_copy_has_every_parameter():
    mapper, copy = vtkink.vtkInkStippleMapper(), vtkink.vtkInkStippleMapper()
    names = parameters(mapper)
    assert len(names) >= 38 and set(printed(mapper)) == set(names)
    surface = vtkink.vtk.vtkSphereSource()
    for name in names:
        change(mapper, name)
    mapper.SetSurfaceConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOn()
    defaults = printed(copy)
    copy.ShallowCopy(mapper)
    assert printed(copy) == printed(mapper)
    assert all(printed(copy)[name] != defaults[name] for name in names)
    assert copy.GetInputConnection(1, 0) == surface.GetOutputPort()
    assert copy.GetScalarVisibility()
    # What another kind of mapper has, and nothing else changes.
    copy.ShallowCopy(vtkink.vtk.vtkPolyDataMapper())
    assert printed(copy) == printed(mapper)


def test_enumerations_have_names():
    mapper = vtkink.vtkInkStippleMapper()
    for name, values in {
        "SmallElements": ["Intensity", "Probability"],
        "PositionPrecision": ["Float", "Quantized"],
    }.items():
        for number, value in enumerate(values):
            getattr(mapper, f"Set{name}To{value}")()
            assert getattr(mapper, f"Get{name}")() == number == getattr(mapper, value.upper())
            assert getattr(mapper, f"Get{name}AsString")() == value == printed(mapper)[name]


def test_numbers_are_kept_in_range_and_no_numbers_refused():
    mapper = vtkink.vtkInkStippleMapper()
    messages = messages_of(mapper)
    colors = 0
    for name in parameters(mapper):
        before = getattr(mapper, f"Get{name}")()
        set_value = getattr(mapper, f"Set{name}")
        if isinstance(before, tuple):
            colors += 1
            set_value(7.0, -1.0, 0.5)
            assert getattr(mapper, f"Get{name}")() == (1.0, 0.0, 0.5)
            set_value(0.1, math.nan, 0.3)
            assert getattr(mapper, f"Get{name}")() == (1.0, 0.0, 0.5)
        elif isinstance(before, float):
            set_value(math.inf)
            assert getattr(mapper, f"Get{name}")() == getattr(mapper, f"Get{name}MaxValue")()
            set_value(-math.inf)
            least = getattr(mapper, f"Get{name}")()
            assert least == getattr(mapper, f"Get{name}MinValue")()
            time = mapper.GetMTime()
            set_value(math.nan)
            assert getattr(mapper, f"Get{name}")() == least and mapper.GetMTime() == time
        else:
            continue
        (message,) = messages
        assert name in message and "expected" in message and "nan" in message
        messages.clear()
    assert colors == 3


def test_presets_have_one_spelling_and_are_found_by_any():
    controls = vtkink.vtkInkStippleControls()
    messages = messages_of(controls)
    names = [controls.GetPresetName(i) for i in range(controls.GetNumberOfPresets())]
    assert names == ["anatomy", "bone", "soft-tissue", "engineering", "plate-white-on-black", "as-published"]
    for name in names:
        getattr(controls, "SetPresetTo" + name.title().replace("-", ""))()
        assert controls.GetPreset() == name
    for text, name in {
        "ANATOMY": "anatomy",
        "Soft Tissue": "soft-tissue",
        "Plate, White on Black": "plate-white-on-black",
        "As Published": "as-published",
        "PlateWhiteOnBlack": "plate-white-on-black",
    }.items():
        assert controls.SetPreset(text) and controls.GetPreset() == name
    assert not messages
    assert not controls.SetPreset("oil") and controls.GetPreset() == "plate-white-on-black"
    assert len(messages) == 1 and all(name in messages[0] for name in names)


def test_the_preset_as_published_leaves_nothing_of_others():
    """All sliders in the middle and every k of Table 1 with them, whatever the mapper had before."""
    controls, mapper = vtkink.vtkInkStippleControls(), vtkink.vtkInkStippleMapper()
    for name in ("BoundaryBase", "BoundaryGain", "BoundaryExponent", "SilhouetteBase", "SilhouetteGain", "SilhouetteExponent", "ResolutionExponent", "SlantExponent", "LightingExponent", "DistanceExponent", "InteriorExponent", "ValueEffect",
                 "PixelsPerStipple", "WarmCool", "DistanceSize", "InteriorSize"):  # fmt: skip
        change(mapper, name)
    for name in ("Boundary", "Silhouette", "Resolution", "Lighting", "Distance", "Interior"):
        getattr(mapper, f"{name}Off")()
    controls.SetPresetToAsPublished()
    controls.Apply(mapper)
    sliders = [getattr(controls, f"Get{name}")() for name in ("Gradient", "Sharpness", "Orientation", "Distance", "Interior")]
    assert sliders == [0.5] * 5 and controls.GetColor() == 0
    expected = dict(BoundaryBase=0.35, BoundaryGain=0.65, BoundaryExponent=0.8, SilhouetteBase=0.3, SilhouetteGain=1.6, SilhouetteExponent=0.5, ResolutionExponent=-2, SlantExponent=1, LightingExponent=1, DistanceExponent=1, InteriorExponent=1,
                    ValueEffect=1, PixelsPerStipple=1, WarmCool=0, DistanceSize=0.5, InteriorSize=0.5,
                    Boundary=True, Silhouette=True, Resolution=True, Lighting=True, Distance=True, Interior=True)  # fmt: skip
    assert {name: getattr(mapper, f"Get{name}")() for name in expected} == expected


def test_actor_copies_are_of_the_same_kind():
    actor, copy = vtkink.vtkInkStippleActor(), vtkink.vtkInkStippleActor()
    actor.SetMapper(vtkink.vtkInkStippleMapper())
    actor.GetProperty().SetOpacity(0.5)
    copy.ShallowCopy(actor)
    assert copy.GetMapper() is actor.GetMapper() and copy.GetProperty() is actor.GetProperty()
