# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's XML of the rows that generate_parameters.py reads."""

import html
import json
import re
import sys

# The data that has not what a parameter needs, as ParaView's decorators ask.
EXCLUDED = {"image": "vtkPolyData vtkUnstructuredGrid vtkStructuredGrid", "mesh": "vtkImageData"}
ALL_VALUES = 1e38
ARRAY_RANGES = ("range", "mid")


def property_name(row):
    return row.get("panel") or row["prefix"] + row["name"]


def attributes(pairs, indent):
    """XML attributes, one below the other."""
    return ("\n" + " " * indent).join(f'{key}="{html.escape(str(value))}"' for key, value in pairs if value is not None)


def decorator(indent, **pairs):
    kind = pairs.pop("type")
    head = f'{" " * indent}<PropertyWidgetDecorator '
    return head + attributes([("type", kind), ("mode", "visibility"), *pairs.items()], len(head)) + " />"


def hints(row, rows):
    lines = []
    if row.get("domain") in ARRAY_RANGES:
        lines.append(" " * 10 + "<NoDefault />")
    for name, value in row.get("if", {}).items():
        other = rows[name]
        index = next((entry[2] for entry in other["entries"] if entry[0] == value), int(value is True))
        lines.append(decorator(10, type="GenericDecorator", property=property_name(other), value=index))
    excluded = EXCLUDED.get(row.get("paneldata", row.get("data")))
    if excluded:
        lines.append(decorator(10, type="InputDataTypeDecorator", exclude=1, name=excluded))
    return [" " * 8 + "<Hints>", *lines, " " * 8 + "</Hints>"] if lines else []


def domain(row, count):
    kind = row["type"]
    indent = " " * 8
    if row.get("domain") == "file":
        return [f'{indent}<FileListDomain name="files" />']
    if row.get("domain") in ARRAY_RANGES:
        mode = ' default_mode="mid"' if row["domain"] == "mid" else ""
        return [
            f'{indent}<InkArrayRangeDomain name="range"{mode}>',
            f"{indent}  <RequiredProperties>",
            f'{indent}    <Property name="Input" function="Input" />',
            f'{indent}    <Property name="{row["array"]}" function="ArraySelection" />',
            f"{indent}  </RequiredProperties>",
            f"{indent}</InkArrayRangeDomain>",
        ]
    if kind == "bool":
        return [f'{indent}<BooleanDomain name="bool" />']
    if kind == "enum":
        entries = [f'{indent}  <Entry text="{html.escape(label)}" value="{value}" />' for _, label, value in row["entries"]]
        return [f'{indent}<EnumerationDomain name="enum">', *entries, f"{indent}</EnumerationDomain>"]
    least, greatest = (0, 1) if kind in ("color", "colors") else row.get("slider") or row.get("range") or (None, None)
    # What is wider than ParaView's integers has no end to be shown.
    ends = [end if end is not None and abs(end) < 2147483647 else None for end in (least, greatest)]
    limits = "".join(f' {name}="{" ".join([json.dumps(end)] * count)}"' for name, end in zip(("min", "max"), ends) if end is not None)
    return [f'{indent}<{"Int" if kind == "int" else "Double"}RangeDomain name="range"{limits} />'] if limits else []


def xml_property(row, rows):
    """A property that calls SetParameter with the parameter's name and its numbers, or SetParameterAsString with its text."""
    kind = row["type"]
    color = kind in ("color", "colors")
    count = 3 if color else row["size"] if kind == "vector" else 1
    default = row["default"]
    if kind == "enum":
        default = next(entry[2] for entry in row["entries"] if entry[0] == default)
    values = default if isinstance(default, list) else [int(default) if isinstance(default, bool) else default]
    if not values:
        # No range is that of all values.
        values = [-ALL_VALUES, ALL_VALUES] if row.get("domain") == "range" else [0] * count
    text = kind == "string"
    integral = kind in ("bool", "int", "enum")
    element = ("Ink" if row.get("tracked") else "") + ("String" if text else "Int" if integral else "Double") + "VectorProperty"
    command = "SetParameterAsString" if text else "SetParameter"
    # A label that is too long cuts the panel.
    notes = [row["unit"].replace("1/1000", "‰")] if row.get("unit") else []
    notes += [f"{number}: {word}" for number, word in row.get("special", {}).items()]
    pairs = [
        ("name", property_name(row)),
        ("si_class", f"vtkSI{element.removeprefix('Ink')}" if row.get("tracked") else None),
        ("label", row["label"] + (f" ({'; '.join(notes)})" if notes else "")),
        ("command", None if row.get("client") else command),
        ("initial_string", None if row.get("client") else row["name"]),
        ("number_of_elements", count),
        ("default_values", " ".join(value if text else json.dumps(value) for value in values)),
        ("panel_widget", "color_selector" if color and not integral else None),
        ("panel_visibility", None if row.get("level") == "essential" else "advanced"),
    ]
    head = f"      <{element} "
    return [
        head + attributes(pairs, len(head)) + ">",
        *domain(row, count),
        *hints(row, rows),
        f"        <Documentation>{html.escape(row['text'], quote=False)}</Documentation>",
        f"      </{element}>",
    ]


def xml(document, template):
    """The template with its properties."""
    rows = document["rows"]
    shown = {name: row for name, row in rows.items() if row.get("panel") is not False}
    properties = "\n\n".join("\n".join(xml_property(row, rows)) for row in shown.values())

    def group(match):
        rows_of = [row for row in shown.values() if row["group"] == match[2]]
        names = [property_name(row) for row in rows_of if match[3] in (None, row.get("level", "advanced"))]
        if not names:
            sys.exit(f"expected a group with parameters, found '{match[2]}'")
        return "\n".join(f'{match[1]}<Property name="{name}" />' for name in names)

    text = template.replace("      <!-- parameters -->", properties)
    return re.sub(r"^( *)<!-- group (.*?)(?:: (essential|advanced))? -->$", group, text, flags=re.MULTILINE)
