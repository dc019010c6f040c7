# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's panels offer is what the C++ classes take: the same properties, ranges and defaults."""

import pathlib
import re
import sys
import xml.etree.ElementTree

import pytest

vtkink = pytest.importorskip("vtkink")

ROOT = pathlib.Path(__file__).resolve().parents[2]
SERVER_MANAGER = ROOT / "Plugin" / "ServerManager"
sys.path.insert(0, str(ROOT / "Styles" / "Core"))
import filter_properties  # noqa: E402
import generate_parameters  # noqa: E402
import paraview_properties  # noqa: E402

INTEGERS = ("IntVectorProperty", "InkIntVectorProperty")
PROPERTIES = (*INTEGERS, "DoubleVectorProperty", "InkDoubleVectorProperty")
# Of the classes' own properties, those that the panels reach in another way or not at all: iso-values have
# a property of their own kind; ParaView offers only arrays of one component.
ELSEWHERE = {"Value", "NumberOfContours", "ArrayComponent"}
# What "Stipple" decides by itself, or has under another name.
STIPPLE_ELSEWHERE = {"SurfaceFromInput", "PassScalars", "OutputPointsPrecision"}
# What only the representations have; TestContours.py, TestLineArt.py, TestStipple.py and TestSplattingLines.py look at it.
OWN = {"SetMapScalars", "SetPaper", "SetPointsWhileMoving"}
# Of splatting lines: what its panel sets for all hidden layers together, or decides by itself.
LINES_ELSEWHERE = {
    "LayerColor", "LayerStrength", "LayerLineWidth", "LayerDashLength", "InkColorMode", "PointFraction",
}  # fmt: skip
# Sliders that offer what is useful; what C++ takes beyond can be typed in.
NARROWER = {"StippleSize", "PixelsPerStipple"}
# A filter in ParaView has no camera: its eye is a direction at first, or a position.
NO_CAMERA = {"Eye"}
# What the strokes' mapper takes beyond is for the world's units, which the style does not have.
NARROWER_STROKES = {"ContoursLineWidth", "ContoursDashLength", "ContoursGapLength", "ContoursTextureLength", "LineArtContourWidth"}
# The style sets them: by LeastGradient, a share of the greatest, by ValueRange; and other styles by what they draw.
CONTOURS_ELSEWHERE = {"LeastGradientMagnitude", "LowestValue", "HighestValue", "SharpCreasesOnly", "ImageComponent"}
STYLES = {"Contours": "vtkInkContoursStyle", "LineArt": "vtkInkLineArtStyle", "SplattingLines": "vtkInkSplattingLinesStyle", "Stipple": "vtkInkStippleStyle"}


def table_of(style):
    return generate_parameters.read(ROOT / "Styles" / style / "parameters.json")


def proxy_of(file, kind):
    path = SERVER_MANAGER / file
    if path.exists():
        text = path.read_text(encoding="utf-8")
    else:
        # As CMake makes it.
        template = (SERVER_MANAGER / f"{file}.in").read_text(encoding="utf-8")
        table = path.with_suffix(".json")
        if table.exists():
            text = filter_properties.xml(filter_properties.read(str(table)), template)
        else:
            text = paraview_properties.xml(table_of(path.stem.removesuffix("Panel")), template)
    return xml.etree.ElementTree.fromstring(text).find(f".//{kind}")


def representation_of(file, kind):
    """With what it has from its base."""
    proxy = proxy_of(file, kind)
    base = proxy_of("Representation.xml", f"RepresentationProxy[@name='{proxy.get('base_proxyname')}']")
    proxy.extend([element for element in base if element.tag != "Documentation"])
    return proxy


def sampler():
    return proxy_of("IsoSurfaceSampler.xml", "SourceProxy"), [vtkink.vtkInkIsoSurfaceSampler()]


def gradient():
    return proxy_of("Gradient.xml", "SourceProxy"), [vtkink.vtkInkGradient()]


def surface_sampler():
    return proxy_of("SurfaceSampler.xml", "SourceProxy"), [vtkink.vtkInkSurfaceSampler()]


def lines_of_curvature():
    return proxy_of("LinesOfCurvature.xml", "SourceProxy"), [vtkink.vtkInkLinesOfCurvature()]


def point_priority():
    return proxy_of("PointPriority.xml", "SourceProxy"), [vtkink.vtkInkPointPriority()]


def contours():
    style = vtkink.vtkInkContoursStyle()
    objects = [style.GetSilhouetteMapper(), style.GetActor(), style.GetActor().GetProperty(), style]
    return representation_of("Contours.xml", "InkContoursRepresentationProxy"), objects


def contours_filter():
    made = vtkink.vtkInkContours()
    made.SetEyeToDirection()
    return proxy_of("ContoursFilter.xml", "SourceProxy"), [made]


def principal_curvature():
    return proxy_of("PrincipalCurvature.xml", "SourceProxy"), [vtkink.vtkInkPrincipalCurvature()]


def line_art():
    style = vtkink.vtkInkLineArtStyle()
    objects = [style.GetActor(), style.GetActor().GetProperty(), style]
    return representation_of("LineArt.xml", "InkLineArtRepresentationProxy"), objects


def splatting_lines():
    style = vtkink.vtkInkSplattingLinesStyle()
    objects = [style.GetLinesMapper(), style.GetActor(), style.GetActor().GetProperty(), style]
    return representation_of("SplattingLines.xml", "InkSplattingLinesRepresentationProxy"), objects


def stipple():
    style = vtkink.vtkInkStippleStyle()
    objects = [style.GetStippleMapper(), style.GetGenerator(), style.GetActor(), style.GetActor().GetProperty(), style]
    return representation_of("Stipple.xml", "InkStippleRepresentationProxy"), objects


def stipple_generator():
    return proxy_of("StippleGenerator.xml", "SourceProxy"), [vtkink.vtkInkStippleGenerator()]


PROXIES = {
    "Contours.xml": contours,
    "ContoursFilter.xml": contours_filter,
    "Gradient.xml": gradient,
    "IsoSurfaceSampler.xml": sampler,
    "LineArt.xml": line_art,
    "LinesOfCurvature.xml": lines_of_curvature,
    "PointPriority.xml": point_priority,
    "PrincipalCurvature.xml": principal_curvature,
    "SplattingLines.xml": splatting_lines,
    "Stipple.xml": stipple,
    "StippleGenerator.xml": stipple_generator,
    "SurfaceSampler.xml": surface_sampler,
}
if hasattr(vtkink, "vtkInkVDBReader"):
    PROXIES["VDBReader.xml"] = lambda: (proxy_of("VDBReader.xml", "SourceProxy"), [vtkink.vtkInkVDBReader()])
    PROXIES["VDBIsoSurfaceSampler.xml"] = lambda: (
        proxy_of("VDBIsoSurfaceSampler.xml", "SourceProxy"), [vtkink.vtkInkVDBIsoSurfaceSampler()]
    )  # fmt: skip


def method_of(element, rows):
    """What a property calls, with the parameter's own method in place of SetParameter."""
    command = element.get("command", "")
    return f"Set{rows[element.get('initial_string')]['method']}" if command.startswith("SetParameter") else command


def rows_of(file):
    style = file.removesuffix(".xml")
    return table_of(style)["rows"] if style in STYLES else {}


def cases():
    for file, make in PROXIES.items():
        proxy, objects = make()
        rows = rows_of(file)
        for element in proxy:
            # Iso-values have no default and UserTransform's is null in C++; MaximumDownsampling has a test of its own.
            left_out = re.fullmatch("ContourValues|[A-Z][A-Za-z]+IsoValue|UserTransform|MaximumDownsampling", element.get("name", ""))
            command = method_of(element, rows)
            if element.tag in PROPERTIES and command and not left_out and command not in OWN:
                name = command[len("Set") :]
                (owner, *_) = [one for one in objects if hasattr(one, f"Get{name}")] or [None]
                row = rows.get(element.get("initial_string"))
                if row:
                    style = next(one for one in objects if isinstance(one, vtkink.vtkInkStyle))
                    # These are not wrapped: what is their own is the style's parameter.
                    if re.search("GetIsoSurface|GetSilhouettes|GetSilhouetteMethod", row["object"]):
                        owner, name = style, row["name"]
                    else:
                        owner = style
                        for step in filter(None, row["object"].split("()->")):
                            owner = getattr(owner, step)()
                yield pytest.param(element, owner, name, id=f"{file}:{name}")


def numbers(text):
    return [float(number) for number in text.split()]


def is_parameter_alone(owner, name):
    """Of what is not wrapped."""
    return isinstance(owner, vtkink.vtkInkStyle) and not hasattr(owner, f"Get{name}")


def value(owner, name):
    if name == "HiddenColor":  # of any number of layers
        return [float(number) for number in owner.GetParameterAsString(name).split(",")]
    if is_parameter_alone(owner, name):
        return [owner.GetParameter(name)] if owner.GetParameterAsString(name) else []
    got = getattr(owner, f"Get{name}")()
    return [float(number) for number in (got if isinstance(got, tuple) else (got,))]


@pytest.mark.parametrize("element, owner, name", list(cases()))
def test_defaults_are_equal(element, owner, name):
    assert owner is not None, f"no class has Get{name}"
    default = numbers(element.get("default_values"))
    # No range is that of all values.
    assert default == (value(owner, name) or [-paraview_properties.ALL_VALUES, paraview_properties.ALL_VALUES])


@pytest.mark.parametrize("element, owner, name", list(cases()))
def test_ranges_are_equal(element, owner, name):
    clamps = hasattr(owner, f"Get{name}MinValue")
    if is_parameter_alone(owner, name) or (isinstance(owner, vtkink.vtkInkStyle) and list(element.iter("Entry")) and not clamps):
        check_range_of_parameter(element, owner, name)
        return
    domain = next(
        (one for kind in ("Double", "Int") for one in element.iter(f"{kind}RangeDomain")), None
    )
    choices = [float(entry.get("value")) for entry in element.iter("Entry")]
    if domain is not None and clamps:
        low, high = domain.get("min"), domain.get("max")
    elif choices:
        assert clamps, f"Set{name} takes any value, the panel only {choices}"
        low, high = min(choices), max(choices)
        assert sorted(choices) == [low + i for i in range(len(choices))]
    else:
        assert not clamps, f"Set{name} clamps, the panel does not"
        return
    default = value(owner, name)[0]
    set_value = getattr(owner, f"Set{name}")
    integer = element.tag in INTEGERS
    for limit, end, beyond in ((low, "Min", -1e9), (high, "Max", 1e9)):
        at_end = getattr(owner, f"Get{name}{end}Value")()
        if limit is None:
            assert abs(at_end) > 1e18, f"the panel gives no {end} for {name}, C++ {at_end}"
            continue
        if (name in NARROWER and element.get("name") == name) or element.get("name") in NARROWER_STROKES | NO_CAMERA:
            assert getattr(owner, f"Get{name}MinValue")() <= float(limit) <= getattr(owner, f"Get{name}MaxValue")()
            continue
        assert float(limit) == at_end
        set_value(int(beyond) if integer else beyond)
        assert value(owner, name) == [at_end]
    set_value(int(default) if integer else default)


class Errors(list):
    def __init__(self, owner):
        owner.AddObserver("ErrorEvent", lambda *_: self.append(owner))


def check_range_of_parameter(element, style, name):
    """SetParameter of a style, which is what the panel calls, refuses what other classes clamp."""
    if element.find("BooleanDomain") is not None:
        return
    errors = Errors(style)
    default = style.GetParameter(name)
    domain = next((one for kind in ("Double", "Int") for one in element.iter(f"{kind}RangeDomain")), None)
    choices = [float(entry.get("value")) for entry in element.iter("Entry")]
    if domain is None and not choices:
        return  # any number, or those of an array
    low, high = (float(domain.get(end)) for end in ("min", "max")) if domain is not None else (choices[0], choices[-1])
    assert not choices or choices == [low + i for i in range(len(choices))]
    for count, (limit, outwards) in enumerate(((low, -1), (high, 1)), start=1):
        assert style.SetParameter(name, limit) and value(style, name) == [limit]
        assert not style.SetParameter(name, limit + outwards)
        assert value(style, name) == [limit] and len(errors) == count
    assert style.SetParameter(name, default)


@pytest.mark.parametrize("file", STYLES)
def test_parameters_offer_what_their_style_takes(file):
    style = getattr(vtkink, STYLES[file])()
    errors = Errors(style)
    names = [style.GetParameterName(i) for i in range(style.GetNumberOfParameters())]
    proxy, _ = PROXIES[f"{file}.xml"]()
    elements = [element for element in proxy if element.get("command") == "SetParameter"]
    assert len(elements) > 20
    for element in elements:
        name = element.get("initial_string")
        count = int(element.get("number_of_elements"))
        before = style.GetParameterAsString(name)
        limits = [0.0, 1.0]
        if style.GetParameterType(names.index(name)) not in ("color", "colors"):
            style.GetParameterRange(names.index(name), limits)
        domain = next((one for kind in ("Double", "Int") for one in element.iter(f"{kind}RangeDomain")), None)
        for end, limit, outwards in (("min", limits[0], -1), ("max", limits[1], 1)):
            offered = domain.get(end) if domain is not None else None
            if offered is None:
                # Wider than ParaView's integers, or none.
                assert abs(limit) > 2e9 or any(child.tag in ("EnumerationDomain", "BooleanDomain") for child in element), name
                continue
            if name in NARROWER:
                assert len(numbers(offered)) == count and outwards * limit >= outwards * numbers(offered)[0]
            else:
                assert numbers(offered) == [limit] * count, name
            assert not style.SetParameter(name, *[limit + outwards] * count)
            assert style.GetParameterAsString(name) == before and len(errors) == 1, name
            errors.clear()


def is_abstract(cls):
    try:
        cls()
    except TypeError:
        return True
    return False


@pytest.mark.parametrize("file, make", PROXIES.items(), ids=PROXIES.keys())
def test_no_property_is_forgotten(file, make):
    proxy, objects = make()
    offered = {method_of(element, rows_of(file))[len("Set") :] for element in proxy}
    elsewhere = ELSEWHERE | {contours: CONTOURS_ELSEWHERE, contours_filter: {"Camera"}, lines_of_curvature: {"Region"}, stipple: STIPPLE_ELSEWHERE, splatting_lines: LINES_ELSEWHERE}.get(make, set())
    for algorithm in objects:
        if type(algorithm).__name__.startswith("vtkInk") and not isinstance(algorithm, vtkink.vtkInkStyle):
            # With what it has from a base that is nothing by itself, but for that of all mappers.
            bases = [one for one in type(algorithm).__mro__[1:] if one.__name__.startswith("vtkInk") and one.__name__ != "vtkInkMapper"]
            classes = [type(algorithm), *(one for one in bases if is_abstract(one))]
            own = {name[len("Set") :] for one in classes for name in vars(one) if name.startswith("Set")}
            own = {name for name in own if hasattr(algorithm, f"Get{name}")}
            assert own - offered <= elsewhere


@pytest.mark.parametrize("file", sorted({path.name.removesuffix(".in") for path in SERVER_MANAGER.glob("*.xml*")} - {"LightingPanel.xml"}))
def test_every_property_gets_a_widget(file):
    """ParaView 5.11 leaves properties of this type out of its panels."""
    assert proxy_of(file, "ProxyGroup").find(".//IdTypeVectorProperty") is None


def test_every_property_is_documented():
    for make in PROXIES.values():
        proxy, _ = make()
        for element in proxy:
            if element.tag.endswith("Property"):
                text = element.findtext("Documentation")
                assert text and text.strip().endswith("."), element.get("name")


def test_stipple_has_the_presets_and_sliders_of_the_controls():
    proxy, _ = stipple()
    elements = {element.get("name"): element for element in proxy}
    controls = vtkink.vtkInkStippleControls()
    plain = [
        entry.get("text").lower().replace(",", "").replace(" ", "-") for entry in elements["StipplePreset"].iter("Entry")
    ]
    assert plain == [controls.GetPresetName(i) for i in range(controls.GetNumberOfPresets())]
    assert elements["StipplePreset"].get("default_values") == "0"
    for slider in ("Gradient", "Sharpness", "Orientation", "Distance", "Interior", "Color"):
        element = elements[f"Stipple{slider}"]
        assert element.get("command") is None, "the proxy sets the mapper's properties"
        assert numbers(element.get("default_values")) == value(controls, slider)
        domain = element.find("DoubleRangeDomain")
        for limit, beyond in (("min", -9.0), ("max", 9.0)):
            getattr(controls, f"Set{slider}")(beyond)
            assert value(controls, slider) == [float(domain.get(limit))]
        controls.Reset()


def test_texels_are_those_of_the_mapper():
    proxy, (mapper, *_) = splatting_lines()
    element = next(element for element in proxy if element.get("name") == "MaximumDownsampling")
    assert int(element.get("default_values")) == mapper.GetMaximumDownsampling()
    offered = sorted(int(entry.get("value")) for entry in element.iter("Entry"))
    taken = set()
    for pixels in range(-2, 20):
        mapper.SetMaximumDownsampling(pixels)
        taken.add(mapper.GetMaximumDownsampling())
    assert offered == sorted(taken)


def test_hidden_lines_have_the_defaults_and_ranges_of_the_second_layer():
    proxy, (mapper, *_) = splatting_lines()
    elements = {element.get("name"): element for element in proxy}
    for name in ("Strength", "LineWidth", "DashLength"):
        element = elements[f"Hidden{name}"]
        get, set_value = getattr(mapper, f"GetLayer{name}"), getattr(mapper, f"SetLayer{name}")
        assert numbers(element.get("default_values")) == [get(1)]
        domain = element.find("DoubleRangeDomain")
        for limit, beyond in (("min", -1e9), ("max", 1e9)):
            set_value(1, beyond)
            assert float(domain.get(limit)) == get(1)


@pytest.mark.parametrize("style", STYLES)
def test_panels_show_every_property_once(style):
    extension = proxy_of(f"{style}Panel.xml", "Extension")
    shown = [element.get("name") for element in extension.findall(".//PropertyGroup/Property")]
    assert len(shown) == len(set(shown))
    proxy = next(iter(proxy_of(f"{style}.xml", "ProxyGroup")))
    own = {element.get("name") for element in proxy if element.tag.endswith("Property")}
    assert set(shown) == own - {"Input"}


def test_properties_that_domains_depend_on_exist():
    for make in PROXIES.values():
        proxy, _ = make()
        names = {element.get("name") for element in proxy}
        for required in proxy.iter("RequiredProperties"):
            assert {element.get("name") for element in required} <= names


def test_properties_that_decide_what_is_shown_exist():
    for make in PROXIES.values():
        proxy, _ = make()
        names = {element.get("name") for element in proxy}
        for decorator in proxy.iter("PropertyWidgetDecorator"):
            if decorator.get("type") == "GenericDecorator":
                assert decorator.get("property") in names
