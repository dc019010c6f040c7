"""What ParaView's panels offer is what the C++ classes take: the same properties, ranges and defaults."""

import pathlib
import xml.etree.ElementTree

import pytest

vtkink = pytest.importorskip("vtkink")

SERVER_MANAGER = pathlib.Path(__file__).resolve().parents[2] / "Plugin" / "ServerManager"
PROPERTIES = ("IntVectorProperty", "DoubleVectorProperty", "IdTypeVectorProperty")
# Of the classes' own properties, those that the panels reach in another way or not at all: iso-values have
# a property of their own kind; ParaView offers only arrays of one component.
ELSEWHERE = {"Value", "NumberOfContours", "ArrayComponent"}


def proxy_of(file, kind):
    return xml.etree.ElementTree.parse(SERVER_MANAGER / file).getroot().find(f".//{kind}")


def sampler():
    return proxy_of("IsoSurfaceSampler.xml", "SourceProxy"), [vtkink.vtkInkIsoSurfaceSampler()]


def gradient():
    return proxy_of("Gradient.xml", "SourceProxy"), [vtkink.vtkInkGradient()]


def surface_sampler():
    return proxy_of("SurfaceSampler.xml", "SourceProxy"), [vtkink.vtkInkSurfaceSampler()]


def point_priority():
    return proxy_of("PointPriority.xml", "SourceProxy"), [vtkink.vtkInkPointPriority()]


def splatting_lines():
    actor = vtkink.vtk.vtkActor()
    objects = [vtkink.vtkInkSplattingLinesMapper(), actor, actor.GetProperty()]
    return proxy_of("SplattingLines.xml", "RepresentationProxy"), objects


def stipple_generator():
    return proxy_of("StippleGenerator.xml", "SourceProxy"), [vtkink.vtkInkStippleGenerator()]


PROXIES = {
    "Gradient.xml": gradient,
    "IsoSurfaceSampler.xml": sampler,
    "PointPriority.xml": point_priority,
    "SplattingLines.xml": splatting_lines,
    "StippleGenerator.xml": stipple_generator,
    "SurfaceSampler.xml": surface_sampler,
}
if hasattr(vtkink, "vtkInkVDBReader"):
    PROXIES["VDBReaders.xml"] = lambda: (
        proxy_of("VDBReaders.xml", "SourceProxy[@name='InkVDBReader']"),
        [vtkink.vtkInkVDBReader()],
    )
    PROXIES["VDBReaders.xml, sampler"] = lambda: (
        proxy_of("VDBReaders.xml", "SourceProxy[@name='InkVDBIsoSurfaceSampler']"),
        [vtkink.vtkInkVDBIsoSurfaceSampler()],
    )


def cases():
    for file, make in PROXIES.items():
        proxy, objects = make()
        for element in proxy:
            # Iso-values have no default and UserTransform's is null in C++.
            if element.tag in PROPERTIES and element.get("name") not in ("ContourValues", "UserTransform"):
                name = element.get("command")[len("Set") :]
                (owner, *_) = [one for one in objects if hasattr(one, f"Get{name}")] or [None]
                yield pytest.param(element, owner, name, id=f"{file}:{name}")


def numbers(text):
    return [float(number) for number in text.split()]


def value(owner, name):
    got = getattr(owner, f"Get{name}")()
    return [float(number) for number in (got if isinstance(got, tuple) else (got,))]


@pytest.mark.parametrize("element, owner, name", list(cases()))
def test_defaults_are_equal(element, owner, name):
    assert owner is not None, f"no class has Get{name}"
    assert numbers(element.get("default_values")) == value(owner, name)


@pytest.mark.parametrize("element, owner, name", list(cases()))
def test_ranges_are_equal(element, owner, name):
    clamps = hasattr(owner, f"Get{name}MinValue")
    domain = next(
        (one for kind in ("Double", "Int", "IdType") for one in element.iter(f"{kind}RangeDomain")), None
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
    integer = element.tag != "DoubleVectorProperty"
    for limit, end, beyond in ((low, "Min", -1e9), (high, "Max", 1e9)):
        at_end = getattr(owner, f"Get{name}{end}Value")()
        if limit is None:
            assert abs(at_end) > 1e18, f"the panel gives no {end} for {name}, C++ {at_end}"
            continue
        assert float(limit) == at_end
        set_value(int(beyond) if integer else beyond)
        assert value(owner, name) == [at_end]
    set_value(int(default) if integer else default)


@pytest.mark.parametrize("make", PROXIES.values(), ids=PROXIES.keys())
def test_no_property_is_forgotten(make):
    proxy, (algorithm, *_) = make()
    own = {
        name[len("Set") :]
        for name in vars(type(algorithm))
        if name.startswith("Set") and hasattr(algorithm, f"Get{name[len('Set') :]}")
    }
    offered = {element.get("command", "")[len("Set") :] for element in proxy}
    assert own - offered <= ELSEWHERE


def test_every_property_is_documented():
    for make in PROXIES.values():
        proxy, _ = make()
        for element in proxy:
            if element.tag.endswith("Property"):
                text = element.findtext("Documentation")
                assert text and text.strip().endswith("."), element.get("name")


def test_every_extended_representation_shows_the_same_panel():
    root = xml.etree.ElementTree.parse(SERVER_MANAGER / "SplattingLines.xml").getroot()
    extensions = root.findall(".//Extension")
    panels = {xml.etree.ElementTree.tostring(child).strip() for one in extensions for child in one}
    assert {one.get("name") for one in extensions} == {
        "GeometryRepresentation",
        "UnstructuredGridRepresentation",
        "StructuredGridRepresentation",
    }
    assert len(panels) == 2  # the type, and its proxy with the panel
