# SPDX-License-Identifier: BSD-3-Clause
"""Styles: each parameter is the same by C++, the command line, Python and a style file; draw() and styles()."""

import json
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import ink_files

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Styles/Core"))
import generate_parameters  # noqa: E402
TABLES = {"contours": "Contours", "illustration": "Illustration", "line-art": "LineArt", "stipple": "Stipple", "splatting-lines": "SplattingLines"}
PAGES = {"contours": "contours.md", "illustration": "illustration.md", "line-art": "line-art.md", "stipple": "stipple.md", "splatting-lines": "splatting-lines.md"}
STYLES = vtkink.styles()
CASES = [pytest.param(style, parameter, id=f"{style}.{parameter.name}")
         for style, described in STYLES.items() for parameter in described.parameters.values()]  # fmt: skip


def rows(style):
    return generate_parameters.read(str(ROOT / "Styles" / TABLES[style] / "parameters.json"))["rows"]


def option_of(style, parameter):
    words = parameter.keyword.rstrip("_").replace("_", "-")
    return "--" + rows(style)[parameter.name].get("option", words)


def another(parameter):
    """A value that is not the default, as JSON and as text."""
    kind, default, (least, greatest) = parameter.type, parameter.default, parameter.range
    if kind == "bool":
        return default == "off", "off" if default == "on" else "on"
    if kind == "enum":
        name = next(choice for choice in parameter.choices if choice != default)
        return name, name
    if kind in ("int", "double"):
        value = float(default) + (1 if kind == "int" else 0.125)
        value = value if greatest is None or value <= greatest else least + (0 if kind == "int" else 0.0625)
        value = int(value) if kind == "int" else value
        return value, json.dumps(value)
    numbers = {"color": [0.25, 0.5, 0.75], "colors": [0.25, 0.5, 0.75, 1.0, 0.0, 0.0], "list": [80.0, 120.5],
               "vector": [3.0, 4.0, 4.5][: len(default.split(",")) if default else 3]}  # fmt: skip
    if kind == "string":
        checked = {"ColorMap": "viridis", "Texture": str(ROOT / "Data" / "pencil.png")}
        return (checked.get(parameter.name, "pressure"),) * 2
    value = numbers[kind][:2] if parameter.name.endswith(("ColorRange", "ValueRange")) else numbers[kind]
    return value, ",".join(json.dumps(number) for number in value)


def parameters_of(text):
    return json.loads(text)["parameters"]


def changed(style, **parameters):
    """A style file that sets some parameters."""
    return json.dumps({"style": style, "parameters": parameters})


def plainly(style, name, text):
    """All parameters after one is set in C++, as JSON, with what goes with it where it is given together with others."""
    made = vtkink.vtkInkStyle.CreateStyle(style)
    assert made.SetParameterAsString(name, text)
    return parameters_of(made.GetParametersAsJSON())


@pytest.mark.parametrize("style, parameter", CASES)
def test_by_cpp_file_and_python(style, parameter, tmp_path):
    value, text = another(parameter)
    assert plainly(style, parameter.name, text)[parameter.name] == value
    given = vtkink.vtkInkStyle.CreateStyle(style)
    assert given.SetParametersFromJSON(changed(style, **{parameter.name: value})) == ""
    together = parameters_of(given.GetParametersAsJSON())
    assert together[parameter.name] == value
    assert together != parameters_of(vtkink.vtkInkStyle.CreateStyle(style).GetParametersAsJSON())
    keyword = vtkink.drawing._make_style(style, None, {parameter.keyword: value})
    assert parameters_of(keyword.GetParametersAsJSON()) == together
    file = tmp_path / "style.json"
    file.write_text(given.GetParametersAsJSON(), encoding="utf-8")
    read = vtkink.drawing._make_style(style, file, {})
    assert read.GetParametersAsJSON() == given.GetParametersAsJSON()


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.one_build
def test_every_option_is_the_parameter(ink, style, tmp_path):
    """One after the other, as the program takes a moment to start: the options of all parameters at once, then each group."""
    arguments, given = [], {}
    for parameter in STYLES[style].parameters.values():
        value, text = another(parameter)
        row = rows(style)[parameter.name]
        # What excludes another one, or what would switch it off.
        switch = parameter.type == "bool" and value is False and any(parameter.name in one.get("if", {}) for one in rows(style).values())
        if switch or parameter.name in ("GradientThreshold", "ThresholdMode", "MaximumStipplesMode", "GradientMethod", "HiddenLines",
                                         "HiddenOpacity"):
            continue
        option = option_of(style, parameter)
        if parameter.type == "bool":
            arguments.append(option if value else option.replace("--", "--no-", 1))
        else:
            arguments += [option, text]
        given[parameter.name] = value
        if row.get("if") and parameter.name != "GradientPercentile":
            given.update({name: wanted for name, wanted in row["if"].items() if name not in given})
    result = ink("style", style, *arguments)
    assert (result.code, result.err) == (0, ""), result
    found = parameters_of(result.out)
    # An implied switch is on, whatever the order.
    assert {name: found[name] for name in given} == given
    expected = vtkink.vtkInkStyle.CreateStyle(style)
    assert expected.SetParametersFromJSON(changed(style, **given)) == ""
    assert parameters_of(expected.GetParametersAsJSON()) == found
    file = tmp_path / "style.json"
    file.write_text(result.out, encoding="utf-8")
    assert ink("style", style, "--style-file", file).out == result.out


@pytest.mark.one_build
def test_switches_can_be_turned_off(ink):
    for parameter in STYLES["stipple"].parameters.values():
        if parameter.type == "bool":
            for negated, value in (("no-", False), ("", True)):
                result = ink("style", "stipple", option_of("stipple", parameter).replace("--", f"--{negated}", 1))
                assert parameters_of(result.out)[parameter.name] is value, parameter


def test_a_style_file_is_the_picture(ink, picture, volume_file, tmp_path):
    options = ["--preset", "bone", "--sharpness", "0.8", "--silhouette-gain", "3", "--ink-color", "navy", "--pixels-per-stipple", "9"]
    file = tmp_path / "mine.json"
    file.write_text(ink("style", "stipple", *options).out, encoding="utf-8")
    drawn = picture(volume_file, "--style", "stipple", *options, "--iso", 100)
    assert (picture(volume_file, "--style-file", file, "--iso", 100) == drawn).all()
    assert (picture(volume_file, "--style-file", file, "--iso", 100, "--sharpness", "0.1") != drawn).any()


@pytest.mark.parametrize("content, words", [
    ("", ["expected JSON, found a parse error at line 1"]),
    ('{"style": "stipple", "parameters": {"Sharpnes": 1}}', ["'Sharpnes'", "Sharpness"]),
    ('{"style": "stipple", "parameters": {"Sharpness": 7}}', ["Sharpness", "from 0 to 1", "7"]),
    ('{"style": "splatting-lines", "parameters": {}}', ["style", "splatting-lines"]),
])
@pytest.mark.one_build
def test_wrong_style_files(ink, volume_file, tmp_path, content, words):
    file = tmp_path / "wrong.json"
    file.write_text(content, encoding="utf-8")
    result = ink("render", volume_file, "--style", "stipple", "--style-file", file, "-o", tmp_path / "out.png")
    assert result.code == 1 and all(word in result.error for word in [*words, "wrong.json"]), result
    result = ink("render", volume_file, "--style-file", tmp_path / "none.json", "-o", tmp_path / "out.png")
    assert result.code == 1 and "none.json" in result.error


@pytest.mark.one_build
def test_help_has_essentials_and_all(ink):
    short, long = (ink("render", "--style", "stipple", option).out for option in ("--help", "--help-all"))
    for parameter in STYLES["stipple"].parameters.values():
        # By the shortest name: --boundary-base is a part of no other option.
        option = f" {option_of('stipple', parameter)}".replace(" --", " --no-" if parameter.default == "on" else " --", 1)
        assert (f"{option} " in short or f"{option}\n" in short) == parameter.essential, option
        assert f"{option} " in long or f"{option}\n" in long
    assert "--tau" not in long and "--tau" in ink("render", "--help").out


@pytest.fixture(scope="module")
def volume():
    return ink_files.blob((20, 24, 28))


def ink_of(file):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    values = vtkink.numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1)[..., :3]


@pytest.mark.parametrize("style", STYLES)
def test_draw_returns_an_actor_and_writes_a_picture(volume, style, tmp_path):
    few = {"line_spacing": 16} if style == "line-art" else {}
    actor = vtkink.draw(volume, style, **few)
    assert actor.IsA("vtkActor") and actor.GetMapper().GetInput().GetNumberOfPoints() > 100
    assert actor.style.GetName() == style
    output = tmp_path / "out.png"
    # A contour of 2.5 thousandths of so small a picture is a shadow.
    broad = {"line_width": 20} if style == "contours" else {}
    vtkink.draw(volume, style, output, size=np.array([120, 80]), ink_color="red", iso_values=100, **broad, **few)
    image = ink_of(output).astype(int)
    assert image.shape == (80, 120, 3) and (image[0, 0] == 255).all()
    assert 0.005 < (image[..., 1] < 200).mean() < 0.9, "there is ink"
    assert (image[..., 0] >= image[..., 1]).all(), "which is red"


def test_draw_takes_what_people_have(volume, volume_file, tmp_path):
    by_path = vtkink.draw(volume_file).GetMapper().GetInput()
    assert by_path.GetNumberOfPoints() > 100
    sphere = vtk.vtkSphereSource()
    by_algorithm = vtkink.draw(sphere, "stipple", number_of_surface_stipples=3000).GetMapper().GetInput()
    by_object = vtkink.draw(sphere.GetOutput(), "stipple", number_of_surface_stipples=np.int64(3000)).GetMapper().GetInput()
    assert by_algorithm.GetNumberOfPoints() == by_object.GetNumberOfPoints() == 3000
    ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh(), normals=True)
    assert vtkink.draw(tmp_path / "ball.ply", "splatting-lines", number_of_samples=4000).GetMapper().GetInput().GetNumberOfPoints() == 4000
    # z, y and x: the array's last axis runs fastest.
    bounds = vtkink.draw(volume, "splatting-lines").GetBounds()
    assert bounds[1] - bounds[0] > bounds[5] - bounds[4]


def test_an_array_to_color_by_is_enough_for_colors(tmp_path):
    sphere, heights = vtk.vtkSphereSource(), vtk.vtkElevationFilter()
    heights.SetInputConnection(sphere.GetOutputPort())
    pictures = []
    for name, colors in (("ink", {}), ("by", {"color_by": "Elevation"}), ("both", {"color_by": "Elevation", "color_map": "viridis"})):
        output = tmp_path / f"{name}.png"
        vtkink.draw(heights, "stipple", output, size=(100, 100), number_of_surface_stipples=5000, **colors)
        pictures.append(ink_of(output).astype(int))
    black, colored, both = pictures
    assert np.ptp(black, axis=-1).max() == 0 and np.ptp(colored, axis=-1).max() > 80
    assert (colored == both).all()


@pytest.mark.parametrize("arguments, error, words", [
    ({"data": "none.nii"}, FileNotFoundError, ["none.nii"]),
    ({"data": 3}, TypeError, ["int", "NumPy"]),
    ({"data": np.zeros((3, 3))}, ValueError, ["three axes", "2"]),
    ({"style": "oil"}, ValueError, ["oil", "stipple"]),
    ({"sharpnes": 1}, TypeError, ["sharpnes", "sharpness"]),
    ({"sharpness": 2}, ValueError, ["sharpness: ", "from 0 to 1", "2"]),
    ({"preset": "oil"}, ValueError, ["preset: ", "bone"]),
    ({"ink_color": "mauvish"}, ValueError, ["ink_color: ", "mauvish"]),
    ({"view": "behind"}, ValueError, ["view", "front"]),
    ({"size": (120,)}, ValueError, ["size", "two whole numbers", "(120,)"]),
    ({"size": np.array([120.5, 80])}, ValueError, ["size", "two whole numbers", "120.5"]),
    ({"size": (0, 80)}, ValueError, ["size", "two whole numbers", "(0, 80)"]),
    ({"output": "a.gif"}, ValueError, [".png", ".tif"]),
    ({"data": vtk.vtkTable()}, ValueError, ["stipple", "vtkTable"]),
    ({"data": vtk.vtkPolyData(), "style": "splatting-lines"}, ValueError, ["no points"]),
    ({"color_by": "pressure"}, ValueError, ["'pressure' to color by", "point arrays: "]),
])
def test_draw_says_what_is_wrong(volume, arguments, error, words):
    with pytest.raises(error) as raised:
        vtkink.draw(**{"data": volume, "style": "stipple", **arguments})
    assert all(word in str(raised.value) for word in words), raised.value


def test_the_example_draws(tmp_path):
    nifti = ROOT / "Data" / "engine.nii.gz"
    result = subprocess.run([sys.executable, ROOT / "Python/Examples/draw.py", nifti], cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 0 and "sharpness (0.5): " in result.stdout, result
    for name in ("draw_stipple.png", "draw_lines.png"):
        assert (ink_of(tmp_path / name) < 128).any()


def test_files_that_cannot_be_read(tmp_path):
    (tmp_path / "a.txt").write_text("x", encoding="utf-8")
    with pytest.raises(ValueError, match=".nii.gz"):
        vtkink.draw(tmp_path / "a.txt")


def test_styles_are_described():
    assert STYLES["stipple"].presets[0] == "anatomy" and not STYLES["splatting-lines"].presets
    size = STYLES["stipple"].parameters["stipple_size"]
    assert (size.name, size.default, size.range, size.unit) == ("StippleSize", "2.2", (0.1, 100.0), "1/1000 of height")
    assert STYLES["splatting-lines"].parameters["radius"].range == (0.0, None)
    for style in STYLES.values():
        assert all(parameter.text.endswith(".") and parameter.group for parameter in style.parameters.values())


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.one_build
def test_pages_have_the_table(style, tmp_path):
    """Made again by: Styles/Core/generate_parameters.py table Styles/STYLE/parameters.json Documentation/PAGE.md"""
    page = ROOT / "Documentation" / PAGES[style]
    copy = tmp_path / page.name
    copy.write_text(page.read_text(encoding="utf-8"), encoding="utf-8")
    subprocess.run([sys.executable, ROOT / "Styles/Core/generate_parameters.py", "table",
                    ROOT / "Styles" / TABLES[style] / "parameters.json", copy], check=True)  # fmt: skip
    assert copy.read_text(encoding="utf-8") == page.read_text(encoding="utf-8")


@pytest.mark.parametrize("change, words", [
    ({"name": "BoundaryBase", "type": "double", "default": 0, "text": "Twice."}, ["BoundaryBase"]),
    ({"name": "Oil", "type": "number", "default": 0, "text": "No type."}, ["Oil", "number"]),
    ({"name": "Oil", "type": "int", "default": 0, "text": "No key.", "color": 1}, ["Oil", "color"]),
    ({"name": "Oil", "type": "int", "default": 0, "text": "No object.", "sets": "press.Oil"}, ["Oil", "press"]),
    ({"name": "Oil", "type": "int", "default": 0, "text": "No parameter.", "implies": {"Water": 1}}, ["Oil", "Water"]),
    ({"name": "Oil", "from": "Core"}, ["Oil", "Core"]),
])
@pytest.mark.one_build
def test_wrong_tables_are_refused(tmp_path, change, words):
    table = json.loads((ROOT / "Styles/Stipple/parameters.json").read_text(encoding="utf-8"))
    table["groups"][0]["parameters"].append(change)
    changed_table = tmp_path / "Stipple" / "parameters.json"
    changed_table.parent.mkdir()
    (tmp_path / "Core").symlink_to(ROOT / "Styles/Core")
    changed_table.write_text(json.dumps(table), encoding="utf-8")
    result = subprocess.run([sys.executable, ROOT / "Styles/Core/generate_parameters.py", "cxx", changed_table],
                            capture_output=True, text=True)  # fmt: skip
    assert result.returncode == 1 and all(word in result.stderr for word in words), result.stderr


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.one_build
def test_paraviews_properties(style, tmp_path):
    """Each sets its parameter by name; what decides whether one is shown is a property, too."""
    template = tmp_path / "template.xml"
    groups = sorted({row.group for row in STYLES[style].parameters.values()})
    template.write_text("<p>\n      <!-- parameters -->\n" + "".join(f"<g>\n  <!-- group {group} -->\n</g>\n" for group in groups) + "</p>", encoding="utf-8")
    out = tmp_path / "out.xml"
    subprocess.run([sys.executable, ROOT / "Styles/Core/generate_parameters.py", "xml",
                    ROOT / "Styles" / TABLES[style] / "parameters.json", out, template], check=True)  # fmt: skip
    tree = ElementTree.parse(out).getroot()
    properties = {one.get("name"): one for one in tree if one.tag.endswith("VectorProperty")}
    described = {row.name: row for row in STYLES[style].parameters.values()}
    assert len(properties) > 15
    for name, element in properties.items():
        assert (element.get("command") is None) == (element.get("initial_string") is None)
        if element.get("command"):
            row = described[element.get("initial_string")]
            assert element.get("command") == ("SetParameterAsString" if row.type == "string" else "SetParameter")
            assert (element.get("panel_visibility") == "advanced") != row.essential
            count = int(element.get("number_of_elements"))
            assert count == (1 if row.type == "string" else len(element.get("default_values").split())) and count <= 3
        for decorator in element.iter("PropertyWidgetDecorator"):
            assert decorator.get("property") in {None, *properties}
    assert sorted(one.get("name") for one in tree.iter("Property") if one.get("function") is None) == sorted(properties)


@pytest.fixture
def filter_tables(tmp_path):
    """Copies of all tables, and what makes a filter's XML of them."""
    styles, plugin = tmp_path / "Styles", tmp_path / "Plugin" / "ServerManager"
    for table in (ROOT / "Styles").glob("*/parameters.json"):
        (styles / table.parent.name).mkdir(parents=True)
        shutil.copy(table, styles / table.parent.name)
    plugin.mkdir(parents=True)
    for file in (ROOT / "Plugin/ServerManager").glob("*.json"):
        shutil.copy(file, plugin)

    def run(name, change=None, table=None):
        if change:
            path = plugin / f"{table or name}.json"
            content = json.loads(path.read_text(encoding="utf-8"))
            content["properties"].append(change)
            path.write_text(json.dumps(content), encoding="utf-8")
        return subprocess.run([sys.executable, ROOT / "Styles/Core/generate_parameters.py", "xml-filter", plugin / f"{name}.json",
                               tmp_path / "out.xml", ROOT / "Plugin/ServerManager" / f"{name}.xml.in"],
                              capture_output=True, text=True)  # fmt: skip

    return run


@pytest.mark.one_build
def test_a_generators_parameter_is_a_property_of_its_filter(filter_tables, tmp_path):
    """One row, for the style and for the filter; and one for both samplers of iso-surfaces."""
    path = tmp_path / "Styles/Stipple/parameters.json"
    table = json.loads(path.read_text(encoding="utf-8"))
    group = next(one for one in table["groups"] if one["object"] == "generator")
    group["parameters"].append({"name": "Grain", "type": "double", "range": [0, 3], "default": 1.5, "unit": "voxels", "data": "image",
                                "if": {"GradientMethod": "regression"}, "text": "How coarse."})  # fmt: skip
    path.write_text(json.dumps(table), encoding="utf-8")
    assert filter_tables("StippleGenerator").returncode == 0
    tree = ElementTree.parse(tmp_path / "out.xml").getroot()
    (grain,) = [one for one in tree.iter("DoubleVectorProperty") if one.get("name") == "Grain"]
    assert (grain.get("command"), grain.get("default_values"), grain.get("label")) == ("SetGrain", "1.5", None)
    assert (grain.find("DoubleRangeDomain").get("min"), grain.find("DoubleRangeDomain").get("max")) == ("0", "3")
    (decorator,) = grain.iter("PropertyWidgetDecorator")
    assert (decorator.get("property"), decorator.get("value")) == ("GradientMethod", "1")
    for name in ("IsoSurfaceSampler", "VDBIsoSurfaceSampler"):
        row = {"name": "Grain", "type": "bool", "default": True, "text": "Grainy."} if name == "IsoSurfaceSampler" else None
        assert filter_tables(name, row, "IsoSurfaceAlgorithm").returncode == 0
        assert "SetGrain" in (tmp_path / "out.xml").read_text(encoding="utf-8")


@pytest.mark.parametrize("change, words", [
    ({"name": "Oil", "type": "number", "default": 0, "text": "No type."}, ["Oil", "number"]),
    ({"name": "Oil", "type": "int", "default": 0, "text": "No key.", "color": 1}, ["Oil", "color"]),
    ({"name": "Oil", "type": "int", "default": 0}, ["Oil", "a text"]),
    ({"name": "Oil", "type": "int", "default": 0, "text": "No row.", "if": {"Water": True}}, ["Oil", "Water"]),
    ({"from": "Core", "name": "Oil"}, ["Oil", "Core"]),
])
@pytest.mark.one_build
def test_wrong_tables_of_filters_are_refused(filter_tables, change, words):
    result = filter_tables("Gradient", change)
    assert result.returncode == 1 and all(word in result.stderr for word in words), result.stderr
