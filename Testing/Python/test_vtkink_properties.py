# SPDX-License-Identifier: BSD-3-Clause
"""The filters' properties as VTK's programmers know them: enumerations, numbers that are none, documentation."""

import math
import pathlib
import re
import subprocess

import pytest

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = sorted(
    header for folder in ("Filters", "IO", "Rendering") for header in (ROOT / folder).glob("*/vtkInk*.h")
    if not header.stem.endswith("Internals")
)  # fmt: skip
CLASSES = [getattr(vtkink, name) for name in dir(vtkink) if name.startswith("vtkInk") and hasattr(vtkink, name)]
FILTERS = [
    cls for cls in CLASSES
    if isinstance(cls, type) and issubclass(cls, vtk.vtkAlgorithm) and not issubclass(cls, vtk.vtkAbstractMapper)
]  # fmt: skip


def enumerations(cls):
    """Names of properties that have a setter for each of their values, and these values' names."""
    found = {}
    for method in vars(cls):
        match = re.fullmatch(r"Set(\w+?)To([A-Z0-9]\w*)", method)
        if match:
            found.setdefault(match[1], []).append(match[2])
    return found


# With those that they have from a base.
CASES = [pytest.param(cls, name, values, id=f"{cls.__name__}.{name}")
         for cls in FILTERS if cls is not vtkink.vtkInkIsoSurfaceAlgorithm
         for one in cls.__mro__ if one.__name__.startswith("vtkInk")
         for name, values in enumerations(one).items()]  # fmt: skip


@pytest.mark.parametrize("cls, name, values", CASES)
def test_enumerations_have_names(cls, name, values):
    filter = cls()
    default, known = getattr(filter, f"Get{name}")(), getattr(filter, f"Get{name}AsString")()
    assert known in values
    codes = set()
    for value in values:
        getattr(filter, f"Set{name}To{value}")()
        assert getattr(filter, f"Get{name}AsString")() == value
        assert f"\n  {name}: {value}\n" in str(filter)
        codes.add(getattr(filter, f"Get{name}")())
    # Each code has a name, and there are no others.
    low, high = (getattr(filter, f"Get{name}{end}Value")() for end in ("Min", "Max"))
    assert codes == set(range(low, high + 1)) and default in codes


@pytest.mark.parametrize("header", [one for one in HEADERS if one.parent.parent.name != "Rendering"], ids=lambda one: one.stem)
def test_properties_with_few_values_are_enumerations(header):
    """What is clamped between names has setters by name."""
    text = header.read_text(encoding="utf-8")
    cls = getattr(vtkink, header.stem, None)
    if cls is None:
        pytest.skip("not built")
    clamped = re.findall(r"vtkSetClampMacro\((\w+), int, [A-Z_]{3,}(?:_\d)?, [A-Z_]{3,}(?:_\d)?\)", text)
    assert set(clamped) == set(enumerations(cls))


def test_a_wrong_value_is_clamped():
    sampler = vtkink.vtkInkIsoSurfaceSampler()
    for given, kept in ((-9, sampler.CHAR_PRECISION), (9, vtk.vtkAlgorithm.SINGLE_PRECISION)):
        sampler.SetOutputNormalsPrecision(given)
        assert sampler.GetOutputNormalsPrecision() == kept


NUMBERS = [
    ("vtkInkContours", "FeatureAngle"),
    ("vtkInkContours", "LargestCosine"),
    ("vtkInkContours", "LowestValue"),
    ("vtkInkEdgeVoxels", "EdgeScale"),
    ("vtkInkEdgeVoxels", "LeastGradientMagnitude"),
    ("vtkInkGradient", "LaplacianScale"),
    ("vtkInkLinesOfCurvature", "FeatureAngle"),
    ("vtkInkLinesOfCurvature", "FieldSmoothing"),
    ("vtkInkLinesOfCurvature", "IsoValue"),
    ("vtkInkLinesOfCurvature", "MinimumLength"),
    ("vtkInkLinesOfCurvature", "Spacing"),
    ("vtkInkLinesOfCurvature", "StepFactor"),
    ("vtkInkLinesOfCurvature", "StopDistance"),
    ("vtkInkLinesOfCurvature", "UmbilicLimit"),
    ("vtkInkPrincipalCurvature", "FeatureAngle"),
    ("vtkInkPrincipalCurvature", "FieldSmoothing"),
    ("vtkInkStippleGenerator", "GradientPercentile"),
    ("vtkInkStippleGenerator", "GradientThreshold"),
    ("vtkInkStippleGenerator", "LayerThickness"),
    ("vtkInkStippleGenerator", "PictureSize"),
    ("vtkInkStippleGenerator", "ReferenceGradient"),
    ("vtkInkStippleGenerator", "Smoothing"),
    ("vtkInkSurfaceSampler", "CoverageSlack"),
]


class Warnings(list):
    CallDataType = "string0"

    def __init__(self, owner):
        owner.AddObserver("WarningEvent", self)

    def __call__(self, owner, event, text):
        self.append(text)


@pytest.mark.parametrize("cls, name", NUMBERS)
def test_nan_is_refused_and_said(cls, name):
    filter = getattr(vtkink, cls)()
    warnings = Warnings(filter)
    set_value, get_value = getattr(filter, f"Set{name}"), getattr(filter, f"Get{name}")
    default, time = get_value(), filter.GetMTime()
    set_value(math.nan)
    assert get_value() == default and filter.GetMTime() == time
    assert len(warnings) == 1 and f"{name}: expected a number from" in warnings[0] and f"found nan; it stays {default:g}." in warnings[0]
    low, high = (getattr(filter, f"Get{name}{end}Value")() for end in ("Min", "Max"))
    for given, kept in ((-math.inf, low), (math.inf, high), (0.5, max(0.5, low))):
        set_value(given)
        assert get_value() == kept
    assert len(warnings) == 1


def test_every_clamped_number_refuses_nan():
    for header in HEADERS:
        if header.parent.parent.name != "Rendering":
            assert not re.findall(r"vtkSet(?:Clamp|Vector\d)Macro\((\w+), double", header.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ["ScalarWindow", "ReferenceScalarRange"])
@pytest.mark.parametrize("window", [(9.0, 3.0), (math.nan, 3.0), (3.0, math.nan)])
def test_reversed_windows_are_refused_and_said(name, window):
    generator = vtkink.vtkInkStippleGenerator()
    warnings = Warnings(generator)
    getattr(generator, f"Set{name}")(-2.0, 5.0)
    for arguments in (window, (window,)):
        getattr(generator, f"Set{name}")(*arguments)
        assert getattr(generator, f"Get{name}")() == (-2.0, 5.0)
    assert len(warnings) == 2 and f"{name}: expected" in warnings[0] and "it stays -2 to 5." in warnings[0]
    getattr(generator, f"Set{name}")(4.0, 4.0)
    assert getattr(generator, f"Get{name}")() == (4.0, 4.0) and len(warnings) == 2


def test_a_viewpoint_is_finite():
    sampler = vtkink.vtkInkSurfaceSampler()
    warnings = Warnings(sampler)
    sampler.SetViewpoint(1, 2, 3)
    for wrong in (math.nan, math.inf):
        sampler.SetViewpoint(0, 0, wrong)
        assert sampler.GetViewpoint() == (1, 2, 3)
    assert len(warnings) == 2 and "Viewpoint: expected" in warnings[0] and "it stays 1, 2, 3." in warnings[0]


SETTER = re.compile(r"^  (?:virtual )?(?:void|bool) (Set\w+)\(|^  (?:vtk|Ink)Set\w*Macro\((\w+)", re.MULTILINE)
COMMENT = re.compile(r"^   \*(?!/)(.*)$|^  ///(?!@)(.*)$", re.MULTILINE)
BRITISH = re.compile(r"colour|grey|neighbour|normalis|centre|behaviour|quantis|rasteris|visualis|optimis|analys[ei]|favour", re.I)


def documented_setters(header):
    """Each public setter with the comment above it, or above the group that it belongs to."""
    text = header.read_text(encoding="utf-8")
    public = text[text.index("public:") :]
    for part in re.split(r"^  ///@\{$|^  ///@\}$|\n\n", public, flags=re.MULTILINE):
        comment = " ".join(one or other for one, other in COMMENT.findall(part))
        for match in SETTER.finditer(part):
            yield match[1] or f"Set{match[2]}", comment


@pytest.mark.parametrize("header", HEADERS, ids=lambda one: one.stem)
def test_setters_are_documented_with_their_default(header):
    by_value = r"Set\w+To[A-Z0-9]\w*$"
    missing = [
        name for name, comment in documented_setters(header)
        if not re.search(r"default|until", comment, re.I) and not re.search(by_value, name)
    ]  # fmt: skip
    assert not missing


@pytest.mark.parametrize("header", HEADERS, ids=lambda one: one.stem)
def test_public_names_are_american(header):
    code = re.sub(r"/\*.*?\*/|//[^\n]*", "", header.read_text(encoding="utf-8"), flags=re.DOTALL)
    assert not BRITISH.findall(code)


@pytest.mark.parametrize("file", sorted((ROOT / "Plugin" / "ServerManager").glob("*.xml*")), ids=lambda file: file.name)
def test_panels_names_are_american(file):
    names = re.findall(r'(?:name|command|label|text)="([^"]*)"', file.read_text(encoding="utf-8"))
    assert not [name for name in names if BRITISH.search(name)]


@pytest.mark.parametrize("command", ["render", "sample", "info", "convert"])
def test_options_are_american(command):
    result = subprocess.run(["ink", command, "--help"], capture_output=True, text=True)
    if command == "convert" and result.returncode:
        pytest.skip("built without OpenVDB")
    options = re.findall(r"--[a-z][a-z-]+", result.stdout)
    assert options and not [option for option in options if BRITISH.search(option)]
