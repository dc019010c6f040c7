# SPDX-License-Identifier: BSD-3-Clause
"""Options anywhere on the command line, what is said of wrong ones, and options after a style file."""

import json

import numpy as np
import pytest

import ink_files

pytestmark = pytest.mark.one_build


@pytest.fixture
def style_file(tmp_path):
    """Writes a style file with some parameters."""

    def write(style, **parameters):
        path = tmp_path / "style.json"
        path.write_text(json.dumps({"style": style, "parameters": parameters}))
        return path

    return write


@pytest.fixture
def parameters(ink):
    """What `ink style` prints, by name."""

    def run(*arguments):
        result = ink("style", *arguments)
        assert (result.code, result.err) == (0, ""), result
        return json.loads(result.out)["parameters"]

    return run


@pytest.mark.parametrize("style, option, value", [
    ("stipple", "--preset", "bone"),  # a name
    ("stipple", "--sharpness", 0.5),  # a number
    ("stipple", "--seed", 7),
    ("stipple", "--iso", 80),  # a list
    ("stipple", "--light", "-30,30"),  # a vector
    ("stipple", "--ink-color", "navy"),
    ("stipple", "--scalars", "density"),  # a text
    ("stipple", "--boundary", "1,2,1"),  # a shorthand of its own
    ("stipple", "--max-stipples", "projected"),  # a shorthand that is a parameter, too
    ("splatting-lines", "--tau", 1),
    ("splatting-lines", "--iso", 80),
    ("splatting-lines", "--hidden-color", "red,blue"),
    ("splatting-lines", "--background", "ivory"),
])
def test_the_file_after_an_option_of_a_style(ink, picture, volume_file, tmp_path, style, option, value):
    options = ["--style", style, *(["--hidden-layers"] if option == "--hidden-color" else []), option, value]
    out = tmp_path / "last.png"
    result = ink("render", "--quiet", "--size", "200x200", *options, volume_file, "-o", out)
    assert (result.code, result.out, result.err) == (0, "", "")
    assert (ink_files.read_png(out) == picture(volume_file, *options)).all()


@pytest.mark.parametrize("option, value", [("--iso", 80), ("--arrays", "Normals"), ("--precision", "double"),
                                           ("--rule", "strict"), ("--memory", "1GiB")])
def test_the_file_after_an_option_of_sample(ink, volume_file, tmp_path, option, value):
    result = ink("sample", "--quiet", option, value, volume_file, "-o", tmp_path / "last.vtp")
    assert (result.code, result.err) == (0, "")
    assert ink("sample", "--quiet", volume_file, tmp_path / "first.vtp", option, value).code == 0
    assert (tmp_path / "last.vtp").read_bytes() == (tmp_path / "first.vtp").read_bytes()


def test_the_file_after_three_numbers(ink, tmp_path):
    points, normals, _ = ink_files.sphere_mesh()
    ink_files.write_ply(tmp_path / "cloud.ply", (points, normals, np.zeros((0, 3), "<i4")), normals=False)
    (tmp_path / "v.raw").write_bytes(ink_files.blob().tobytes())
    for arguments in (["--viewpoint", "0,0,9", tmp_path / "cloud.ply"],
                      ["--raw", "32x32x32:uint8", "--spacing", "1,1,2", tmp_path / "v.raw"]):
        result = ink("sample", "--quiet", *arguments, "-o", tmp_path / "out.vtp")
        assert (result.code, result.err) == (0, "")


def test_iso_values_one_by_one_before_the_file(ink, volume_file, tmp_path):
    apart = ink("sample", "-q", "--iso", 80, "--iso", 120, volume_file, "-o", tmp_path / "apart.vtp")
    assert (apart.code, apart.err) == (0, "")
    assert ink("sample", volume_file, tmp_path / "after.vtp", "--iso", 80, "--iso", 120).code == 0
    assert (tmp_path / "apart.vtp").read_bytes() == (tmp_path / "after.vtp").read_bytes()
    assert ink("sample", volume_file, tmp_path / "commas.vtp", "--iso", "80,120").code == 0
    assert (tmp_path / "apart.vtp").read_bytes() == (tmp_path / "commas.vtp").read_bytes()


def test_the_style_of_a_preset_need_not_be_named(ink, picture, volume_file):
    named = picture(volume_file, "--style", "stipple", "--preset", "engineering")
    assert (picture(volume_file, "--preset", "engineering") == named).all()
    assert (picture(volume_file, "--preset=engineering") == named).all()
    # An option that only another style has is told from it.
    result = ink("render", volume_file, "-o", "none.png", "--preset", "engineering", "--tau", 1)
    assert result.code == 2 and result.error.startswith("ink: error: --tau: expected with --style")


@pytest.mark.parametrize("options, name", [
    (["--style", "stipple", "--seed"], "--seed"), (["--style", "stipple", "--lighting"], "--lighting"),
    (["--style", "stipple", "--seed", "1", "--seed", "2"], "--seed"), (["--hidden-width"], "--hidden-width"),
    (["--preset"], "--preset")])
def test_messages_name_options_that_the_help_leaves_out(ink, volume_file, options, name):
    assert f"\n  {name} " not in ink("render", *options[:2], "--help").out
    result = ink("render", volume_file, "-o", "none.png", *options)
    assert result.code == 2 and result.error.startswith(f"ink: error: {name}: ")


def test_help_leaves_out_what_it_left_out(ink):
    short, long = (ink("render", "--style", "stipple", option) for option in ("--help", "--help-all"))
    assert short.code == long.code == 0
    assert "--seed " in long.out and "--seed " not in short.out
    assert "--tau" not in short.out + long.out and "unlisted" not in short.out + long.out


@pytest.mark.parametrize("options, name, value", [
    (["--preset", "bone", "stipple"], "Preset", "bone"),
    (["--preset=bone", "stipple"], "Preset", "bone"),
    (["--light", "-10,20", "--boundary", "off", "stipple"], "LightDirection", [-10, 20]),
    (["--no-boundary-enhancement", "stipple"], "BoundaryEnhancement", False),
    (["--scalars", "splatting-lines", "stipple"], "Scalars", "splatting-lines"),
    (["--tau", "1.1", "splatting-lines"], "Tau", 1.1),
    (["--hidden-layers", "splatting-lines"], "HiddenLayers", True)])
def test_options_before_the_name_of_the_style(parameters, options, name, value):
    assert parameters(*options)[name] == value
    assert parameters(options[-1], *options[:-1]) == parameters(*options)


def test_an_option_is_not_told_to_be_given_with_itself(ink, volume_file):
    result = ink("render", volume_file, "-o", "none.png", "--style", "stipple", "--stipple-source", "volume", "--iso", 80)
    assert result.code == 2
    assert result.error == "ink: error: --iso: expected with --stipple-source surface"


def test_a_style_file_can_say_what_is_stippled(ink, picture, style_file, volume_file):
    # The frame of voxels is that of the iso-surface, which is not the same.
    stipple = ["--style", "stipple", "--position", "15.5,-100,15.5", "--focal-point", "15.5,15.5,15.5"]
    off = style_file("stipple", StippleSource="volume", IsoValues=[100])
    drawn = picture(volume_file, *stipple, "--style-file", off)
    assert (drawn == picture(volume_file, *stipple, "--stipple-source", "volume")).all()
    # The command line's word is the last.
    hidden = picture(volume_file, *stipple, "--iso", 100)
    assert (hidden != drawn).any()
    assert (picture(volume_file, *stipple, "--style-file", off, "--iso", 100) == hidden).all()
    assert (picture(volume_file, *stipple, "--style-file", style_file("stipple", IsoValues=[100])) == hidden).all()


@pytest.mark.parametrize("style, given, options, name", [
    ("splatting-lines", {"HiddenLayers": True, "HiddenLineWidth": 1}, ["--line-width", 3], "HiddenLineWidth"),
    ("stipple", {"NumberOfSurfaceStipples": 5000}, ["--max-stipples", 4], "NumberOfSurfaceStipples")])
def test_what_a_style_file_gives_stays(parameters, style_file, style, given, options, name):
    assert parameters(style, *options)[name] != given[name]
    both = parameters(style, "--style-file", style_file(style, **given), *options)
    assert both[name] == given[name]
    # Only what was given itself: this one follows again.
    first = style_file(style, LineWidth=2) if style == "splatting-lines" else style_file(style, PixelsPerStipple=2)
    assert parameters(style, "--style-file", first, *options)[name] == parameters(style, *options)[name]


def test_options_win_over_a_style_file(parameters, style_file):
    lines = style_file("splatting-lines", LineWidth=1, HiddenLineWidth=1, HiddenLayers=True)
    assert parameters("splatting-lines", "--style-file", lines, "--hidden-width", 2)["HiddenLineWidth"] == 2
    stipple = style_file("stipple", StippleSource="volume")
    assert parameters("stipple", "--style-file", stipple, "--iso", 80)["StippleSource"] == "surface"


@pytest.mark.parametrize("style, options", [
    ("splatting-lines", ["--line-width", 3]), ("stipple", ["--iso", 80]), ("stipple", ["--pixels-per-stipple", 3]),
    ("stipple", ["--max-stipples", 4]), ("stipple", ["--ink-color", "white", "--paper-color", "black"]),
    ("stipple", ["--preset", "bone"])])
def test_a_whole_style_file_as_printed_changes_nothing(ink, parameters, tmp_path, style, options):
    whole = tmp_path / "whole.json"
    whole.write_text(ink("style", style).out)
    assert parameters(style, "--style-file", whole, *options) == parameters(style, *options)


def test_errors_inside_of_a_style_fail(ink, tmp_path):
    """VTK cannot measure the area of a face that is too large for a double, and says so in the middle of the work."""
    points, normals, triangles = ink_files.sphere_mesh()
    points = points.astype(np.float64)
    points[100] = [1e160, 1e159, 2e160]
    ink_files.write_vtp(tmp_path / "far.vtp", (points, normals, triangles))
    result = ink("render", tmp_path / "far.vtp", "--style", "stipple", "-o", tmp_path / "out.png")
    assert result.code == 1 and "ink: error: Stipple: " in result.error
    assert not (tmp_path / "out.png").exists()
