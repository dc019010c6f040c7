# SPDX-License-Identifier: BSD-3-Clause
"""``vtkink.draw`` and ``vtkink.styles``: the styles, with their parameters as keywords."""

import difflib
import json
import keyword
import math
import numbers
import os
import re
from collections.abc import Sequence
from typing import NamedTuple

from . import _vtk_module
from .reading import Errors, data_object, reader_of
from .vtkInkIOPicture import vtkInkPictureWriter
from .vtkInkStyles import vtkInkCameraFit, vtkInkStyle, vtkInkView


class Parameter(NamedTuple):
    """A parameter of a style, as ``draw`` takes it by keyword."""

    keyword: str
    name: str  #: as vtkInkStyle.SetParameter and style files have it
    type: str
    default: str
    range: tuple  #: of each number; None where there is no end
    unit: str
    essential: bool
    group: str
    text: str
    choices: tuple  #: of an enumeration


class Style(NamedTuple):
    """A way of drawing."""

    name: str
    text: str
    presets: tuple
    parameters: dict  #: by keyword


def _keyword(name):
    """StippleSize as stipple_size, and Lambda, which is a word of Python's own, as lambda_."""
    word = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
    return word + "_" if keyword.iskeyword(word) else word


def _parameter(style, index):
    ends = [0.0, 0.0]
    style.GetParameterRange(index, ends)
    return Parameter(
        keyword=_keyword(style.GetParameterName(index)),
        name=style.GetParameterName(index),
        type=style.GetParameterType(index),
        default=style.GetParameterDefault(index),
        range=tuple(end if math.isfinite(end) else None for end in ends),
        unit=style.GetParameterUnit(index),
        essential=style.IsParameterEssential(index),
        group=style.GetParameterGroup(index),
        text=style.GetParameterText(index),
        choices=tuple(style.GetParameterEntry(index, i) for i in range(style.GetNumberOfParameterEntries(index))),
    )


def _describe(style):
    parameters = [_parameter(style, index) for index in range(style.GetNumberOfParameters())]
    return Style(
        name=style.GetName(),
        text=style.GetDescription(),
        presets=tuple(style.GetPresetName(index) for index in range(style.GetNumberOfPresets())),
        parameters={parameter.keyword: parameter for parameter in parameters},
    )


def _style_names():
    return [vtkInkStyle.GetStyleName(index) for index in range(vtkInkStyle.GetNumberOfStyles())]


def styles():
    """All styles by name, each with its presets and its parameters by keyword::

        for parameter in vtkink.styles()["stipple"].parameters.values():
            print(parameter.keyword, parameter.default, parameter.range, parameter.unit, parameter.text)
    """
    return {name: _describe(vtkInkStyle.CreateStyle(name)) for name in _style_names()}


def _plain(value):
    """NumPy's numbers, and lists, tuples and arrays of any numbers, as Python's own, element by element."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes, bytearray)):
        return [_plain(one) for one in value]
    if isinstance(value, numbers.Real) and not isinstance(value, int):
        return float(value)
    return value


def _flat(values):
    for value in values:
        yield from _flat(value) if isinstance(value, list) else (value,)


def _is_finite(value):
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def _for_style_file(parameter, value):
    """A value as style files have it. What JSON lacks becomes text, which the style refuses with what it expects."""
    value = _plain(value)
    if parameter.type == "string" and not isinstance(value, str):
        raise ValueError(f"{parameter.keyword}: expected text, found {value!r}")
    elements = list(_flat(value)) if isinstance(value, list) else [value]
    has_json = all(isinstance(one, str) or (isinstance(one, numbers.Real) and _is_finite(one)) for one in elements)
    # Colors can be names and numbers, one beside the other.
    is_text = parameter.type == "colors" and isinstance(value, list)
    return value if has_json and not is_text else ",".join(map(str, elements))


def _set_parameters(style, parameters):
    known = _describe(style).parameters
    for word in parameters:
        if word not in known:
            near = difflib.get_close_matches(word, known, 1)
            hint = f"did you mean {near[0]!r}?" if near else f"expected one of {', '.join(known)}"
            raise TypeError(f"draw() has no parameter {word!r} of style {style.GetName()!r}; {hint}")
    given = {known[word].name: _for_style_file(known[word], value) for word, value in parameters.items()}
    problem = style.SetParametersFromJSON(json.dumps({"style": style.GetName(), "parameters": given}))
    if problem:
        name, _, rest = problem.partition(": ")
        word = next((row.keyword for row in known.values() if row.name == name), name)
        raise ValueError(f"{word}: {rest}")


def _read_style_file(style_file):
    try:
        with open(style_file, encoding="utf-8") as file:
            return file.read()
    except UnicodeDecodeError as error:
        raise ValueError(f"{os.fspath(style_file)}: expected text in UTF-8: {error}") from error


def _make_style(name, style_file, parameters):
    content = None if style_file is None else _read_style_file(style_file)
    if name is None:
        named = vtkInkStyle.FindStyleInJSON(content or "")
        # A file that names none, or none that there is, is refused by any style.
        name = named if named in _style_names() else _DEFAULT_STYLE
    style = vtkInkStyle.CreateStyle(name)
    if style is None:
        raise ValueError(f"style: expected one of {', '.join(_style_names())}, found {name!r}")
    problem = "" if content is None else style.SetParametersFromJSON(content)
    if problem:
        raise ValueError(f"{os.fspath(style_file)}: {problem}")
    _set_parameters(style, parameters)
    return style


_DEFAULT_STYLE = "illustration"


def _view(view, up, azimuth, elevation):
    """From where a picture is taken; what is None is to be chosen."""
    chosen = vtkInkView()
    views = [chosen.GetNameOfView(index) for index in range(chosen.GetNumberOfNames())]
    axes = [chosen.GetAxis(index) for index in range(chosen.GetNumberOfAxes())]
    for name, given, words, setter in (("view", view, views, chosen.SetName), ("up", up, axes, chosen.SetUp)):
        if given is not None and given not in words:
            raise ValueError(f"{name}: expected one of {', '.join(words)}, found {given!r}")
        if given is not None:
            setter(given)
    for name, given, setter in (("azimuth", azimuth, chosen.SetAzimuth), ("elevation", elevation, chosen.SetElevation)):
        if given is not None and not (isinstance(given, numbers.Real) and abs(given) <= 360):
            raise ValueError(f"{name}: expected degrees from -360 to 360, found {given!r}")
        if given is not None:
            setter(given)
    return chosen


def _write_picture(style, output, size, view, dpi):
    core, rendering = (_vtk_module(name) for name in ("vtkImagingCore", "vtkRenderingCore"))
    renderer, window = rendering.vtkRenderer(), rendering.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    factor = vtkInkView.GetSupersampling(*size)
    window.SetSize(*(factor * side for side in size))
    window.AddRenderer(renderer)
    renderer.AddActor(style.GetActor())
    background = [0.0, 0.0, 0.0]
    style.GetBackgroundColor(background)
    renderer.SetBackground(background)
    if style.GetLight() is not None:
        renderer.RemoveAllLights()
        renderer.AddLight(style.GetLight())
    camera = renderer.GetActiveCamera()
    view.Apply(camera)
    fit = vtkInkCameraFit()
    fit.SetAspect(size[0] / size[1])
    fit.AddPoints(style.GetFramePoints(), camera)
    fit.Apply(camera)
    renderer.ResetCameraClippingRange()
    style.SetPixelScale(factor)
    picture, smaller, writer = rendering.vtkWindowToImageFilter(), core.vtkImageShrink3D(), vtkInkPictureWriter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    smaller.SetInputConnection(picture.GetOutputPort())
    smaller.SetShrinkFactors(factor, factor, 1)
    smaller.SetMean(True)
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.SetFileName(os.fspath(output))
    writer.SetDotsPerInch(dpi)
    writer.Write()
    style.SetPixelScale(1)
    renderer.RemoveActor(style.GetActor())
    window.Finalize()
    if writer.GetErrorCode():
        raise OSError(f"cannot write {os.fspath(output)!r}")


# OpenGL implementations of today draw 16384 pixels, and pictures are drawn larger than they are. Only ink has tiles.
_LONGEST_SIDE = 16384 // vtkInkView.LEAST_SUPERSAMPLING


def _checked_size(size):
    sides = _plain(size)
    if not isinstance(sides, list) or len(sides) != 2 or not all(isinstance(side, int) and side >= 1 for side in sides):
        raise ValueError(f"size: expected two whole numbers of at least 1, found {size!r}")
    if max(sides) > _LONGEST_SIDE:
        raise ValueError(f"size: expected up to {_LONGEST_SIDE} pixels a side, found {size!r}; 'ink render' draws larger pictures")
    return sides


def _checked_dpi(dpi):
    number = _plain(dpi)
    if isinstance(number, bool) or not isinstance(number, numbers.Real) or not 1 <= number <= 30000:
        raise ValueError(f"dpi: expected a number from 1 to 30000, found {dpi!r}")
    return float(number)


def _why_empty(style):
    """Why no marks were made; empty if there are some."""
    if style.GetPiece(0).GetNumberOfPoints() > 0:
        return ""
    notes = style.GetNumberOfNotes()
    return style.GetNote(notes - 1) if notes else "nothing to draw"


def _mebibytes(memory):
    parsed = vtkInkStyle.ParseMemory(memory) if isinstance(memory, str) else 0
    if not parsed:
        raise ValueError(f"memory: expected a size of 128 MiB or more, as '800MiB' or '4GiB', found {memory!r}")
    return parsed


def _make_marks(style, data, memory):
    """Lets a style draw data, in parts where it takes more than this memory. Returns what is wrong, and data that is whole."""
    source = reader_of(data) if isinstance(data, (str, os.PathLike)) else data
    if memory is None or not hasattr(source, "GetOutputPort"):
        shown = data_object(data)
        return style.GetReasonAgainst(shown) or style.TryDraw(shown), shown
    style.SetMaximumMemory(memory)
    errors = Errors(source)
    problem = style.TryDraw(source.GetOutputPort())
    return (errors.texts[0] if errors.texts else problem), source.GetOutputDataObject(0)


def draw(
    data, style=None, output=None, *,
    size=(1024, 1024), dpi=300, view=None, up=None, azimuth=None, elevation=None, memory=None, style_file=None, **parameters,
):  # fmt: skip
    """Draws a volume, a mesh or points in a style. Returns the actor, for a renderer of your own.

    :param data: a VTK data object, an algorithm, the path of a file, or a NumPy array of three axes, z, y and x
    :param style: its name, see :func:`styles`; without one that of ``style_file``, or else illustration
    :param output: a PNG, JPEG or TIFF file to write a picture to
    :param size: the picture's width and height in pixels, up to 8192; it also says how many marks a mesh gets
    :param dpi: how many of the picture's pixels an inch has in print
    :param view: the side to look at: front, back, left, right, top, bottom or iso; None: the front, or of a mesh the side
        that shows most
    :param up: the axis that is up in the picture, as "y" or "-z"; None: z, or of a mesh as it seems to stand
    :param azimuth: degrees to go to the right around the subject; None: 0, or 30 where else only one flat face is seen
    :param elevation: degrees to go up then; None: 0, or 20 there, or 30 for what lies flat
    :param memory: how much may be taken, as "1GiB", of data in a file, or that an algorithm makes: a volume that is larger
        is read a few slices at a time, by illustration and splatting lines
    :param style_file: a file as ``ink style NAME`` prints it, whose parameters come before the keywords
    :param parameters: the style's, see ``vtkink.styles()[style].parameters``; colors are names, "#rrggbb" or three numbers
    :raises TypeError: for a keyword that the style does not have
    :raises ValueError: for a wrong value, and for data that cannot be drawn in this style or of which nothing is to be
        drawn, as an iso-surface of a value that is nowhere; no picture is written then

    The actor's attribute ``style`` is the vtkInkStyle, by which parameters can still be changed::

        actor = vtkink.draw("engine.nii.gz", preset="bone", tau=1.0, output="engine.png")
        actor.style.SetParameter("Tau", 0.98)
    """
    seen = _view(view, up, azimuth, elevation)
    if output is not None and not vtkInkPictureWriter.CanWriteFile(os.fspath(output)):
        endings = vtkInkPictureWriter.GetFileExtensions()
        raise ValueError(f"output: expected a name that ends in {endings}, found {os.fspath(output)!r}")
    size, dpi = _checked_size(size), _checked_dpi(dpi)
    memory = None if memory is None else _mebibytes(memory)
    chosen = _make_style(style, style_file, parameters)
    chosen.SetPictureSize(max(size))
    chosen.SetPictureHeight(size[1])
    problem, shown = _make_marks(chosen, data, memory)
    reason = problem or _why_empty(chosen)
    if reason:
        raise ValueError(f"{chosen.GetName()}: {reason}")
    actor = chosen.GetActor()
    actor.style = chosen
    if output is not None:
        seen.Choose(shown, os.fsdecode(data) if isinstance(data, (str, os.PathLike)) else None)
        seen.ChooseForFrame(chosen.GetFramePoints(), chosen.IsSeenThrough())
        _write_picture(chosen, output, size, seen, dpi)
    return actor
