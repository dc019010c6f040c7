# SPDX-License-Identifier: BSD-3-Clause
"""``vtkink.draw`` and ``vtkink.styles``: the styles, with their parameters as keywords."""

import json
import keyword
import math
import numbers
import os
import re
from collections.abc import Sequence
from typing import NamedTuple

from . import _vtk_module
from .reading import data_object
from .vtkInkStyles import vtkInkCameraFit, vtkInkStyle


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
            raise TypeError(
                f"draw() has no parameter {word!r} of style {style.GetName()!r}; expected one of {', '.join(known)}"
            )
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


# The way the viewer looks, and up in the picture, as `ink render --view` has them.
_VIEWS = {
    "front": ((0, 1, 0), (0, 0, 1)),
    "back": ((0, -1, 0), (0, 0, 1)),
    "left": ((-1, 0, 0), (0, 0, 1)),
    "right": ((1, 0, 0), (0, 0, 1)),
    "top": ((0, 0, -1), (0, 1, 0)),
    "bottom": ((0, 0, 1), (0, -1, 0)),
    "iso": ((-1, 1, -1), (-1, 1, 2)),
}
_DEFAULT_STYLE = "illustration"


def _supersampling(size):
    """By how much what is rendered is larger, as ``ink render`` has it: small pictures would get broader lines."""
    return min(max(math.ceil(500 / size[1]), 2), 4) if max(size) < 500 else 2


def _write_picture(style, output, size, view):
    core, rendering, writing = (_vtk_module(name) for name in ("vtkImagingCore", "vtkRenderingCore", "vtkIOImage"))
    renderer, window = rendering.vtkRenderer(), rendering.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    factor = _supersampling(size)
    window.SetSize(*(factor * side for side in size))
    window.AddRenderer(renderer)
    renderer.AddActor(style.GetActor())
    background = [0.0, 0.0, 0.0]
    style.GetBackgroundColor(background)
    renderer.SetBackground(background)
    if style.GetLight() is not None:
        renderer.RemoveAllLights()
        renderer.AddLight(style.GetLight())
    direction, up = _VIEWS[view]
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*(-coordinate for coordinate in direction))
    camera.SetViewUp(*up)
    fit = vtkInkCameraFit()
    fit.SetAspect(size[0] / size[1])
    fit.AddPoints(style.GetFramePoints(), camera)
    fit.Apply(camera)
    renderer.ResetCameraClippingRange()
    style.SetPixelScale(factor)
    picture, smaller, writer = rendering.vtkWindowToImageFilter(), core.vtkImageShrink3D(), writing.vtkPNGWriter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    smaller.SetInputConnection(picture.GetOutputPort())
    smaller.SetShrinkFactors(factor, factor, 1)
    smaller.SetMean(True)
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.SetFileName(os.fspath(output))
    writer.Write()
    style.SetPixelScale(1)
    renderer.RemoveActor(style.GetActor())
    window.Finalize()
    if writer.GetErrorCode():
        raise OSError(f"cannot write {os.fspath(output)!r}")


def _checked_size(size):
    sides = _plain(size)
    if not isinstance(sides, list) or len(sides) != 2 or not all(isinstance(side, int) and side >= 1 for side in sides):
        raise ValueError(f"size: expected two whole numbers of at least 1, found {size!r}")
    return sides


def _why_empty(style):
    """Why no marks were made; empty if there are some."""
    if style.GetPiece(0).GetNumberOfPoints() > 0:
        return ""
    notes = style.GetNumberOfNotes()
    return style.GetNote(notes - 1) if notes else "nothing to draw"


def draw(data, style=None, output=None, *, size=(1024, 1024), view="front", style_file=None, **parameters):
    """Draws a volume, a mesh or points in a style. Returns the actor, for a renderer of your own.

    :param data: a VTK data object, an algorithm, the path of a file, or a NumPy array of three axes, z, y and x
    :param style: its name, see :func:`styles`; without one that of ``style_file``, or else illustration
    :param output: a PNG file to write a picture to
    :param size: the picture's width and height in pixels; it also says how many marks a mesh gets
    :param view: of the picture: front, back, left, right, top, bottom or iso
    :param style_file: a file as ``ink style NAME`` prints it, whose parameters come before the keywords
    :param parameters: the style's, see ``vtkink.styles()[style].parameters``; colors are names, "#rrggbb" or three numbers
    :raises TypeError: for a keyword that the style does not have
    :raises ValueError: for a wrong value, and for data that cannot be drawn in this style or of which nothing is to be
        drawn, as an iso-surface of a value that is nowhere; no picture is written then

    The actor's attribute ``style`` is the vtkInkStyle, by which parameters can still be changed::

        actor = vtkink.draw("engine.nii.gz", preset="bone", tau=1.0, output="engine.png")
        actor.style.SetParameter("Tau", 0.98)
    """
    if view not in _VIEWS:
        raise ValueError(f"view: expected one of {', '.join(_VIEWS)}, found {view!r}")
    if output is not None and not os.fspath(output).endswith(".png"):
        raise ValueError(f"output: expected a name that ends in .png, found {os.fspath(output)!r}")
    size = _checked_size(size)
    chosen = _make_style(style, style_file, parameters)
    chosen.SetPictureSize(max(size))
    chosen.SetPictureHeight(size[1])
    shown = data_object(data)
    reason = chosen.GetReasonAgainst(shown) or chosen.TryDraw(shown) or _why_empty(chosen)
    if reason:
        raise ValueError(f"{chosen.GetName()}: {reason}")
    actor = chosen.GetActor()
    actor.style = chosen
    if output is not None:
        _write_picture(chosen, output, size, view)
    return actor
