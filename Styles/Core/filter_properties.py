# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's XML of a filter, from a table of its properties and a template.

A table, Plugin/ServerManager/FILTER.json, is {"filter": its class, "properties": its rows}, each a property with the setter
of its name. Entries of a row are those of generate_parameters.py: name, type, range, default, level, text, label, entries,
size, if, domain, and data, the data that has it. Beside them:

    animated  true: its values may change with time
    from      another filter's table, or a folder of Styles: the row is the one of this name there, without labels and units.
              Without a name all rows are, or those that set the `object` of a style

A row of a name that an earlier one has replaces only the entries that it gives. The table's "array" is the property that
chooses the array of a `domain`.
"""

import html
import json
import os
import sys

import generate_parameters
import paraview_properties

KEYS = {"name", "type", "range", "default", "level", "text", "label", "entries", "size", "if", "domain", "data", "animated"}
# What a style's row says of its property alone.
STYLE_ONLY = {"label", "data"}
TYPES = {"bool", "int", "double", "enum", "vector"}
DATA = {"image": "vtkImageData", "mesh": "vtkPolyData"}


def rows_from(path, row):
    """The rows of another table that one stands for."""
    folder = os.path.dirname(path)
    table = os.path.join(folder, row["from"] + ".json")
    if os.path.exists(table):
        found = [{key: one[key] for key in KEYS if key in one} for one in read(table)["rows"].values()]
    else:
        style = generate_parameters.read(os.path.join(folder, "..", "..", "Styles", row["from"], "parameters.json"))
        getter = style["objects"][row["object"]] if "object" in row else None
        rows = [one for one in style["rows"].values() if getter is None or one["object"] == getter]
        found = [{key: one[key] for key in KEYS - STYLE_ONLY if key in one} | {"name": one["method"]} for one in rows]
    chosen = [one for one in found if row.get("name") in (None, one["name"])]
    if not chosen:
        sys.exit(f"{path}: expected a row of {row['from']}, found none named '{row.get('name')}'")
    return [{**one, **{key: value for key, value in row.items() if key not in ("from", "object")}} for one in chosen]


def read(path):
    """The table, with the rows of others in it."""
    document = generate_parameters.load(path)
    rows = {}
    for given in document["properties"]:
        for row in rows_from(path, given) if "from" in given else [given]:
            rows[row["name"]] = {**rows.get(row["name"], {}), **row}
    for row in rows.values():
        unknown = set(row) - KEYS
        if unknown or row.get("type") not in TYPES or "text" not in row or not set(row.get("if", {})) <= set(rows):
            sys.exit(f"{path}: {row['name']}: expected a known type, a text, names of rows in `if` and keys of {sorted(KEYS)}; found {row}")
        row["entries"] = [(entry + [index])[:3] for index, entry in enumerate(map(list, row.get("entries", [])))]
        row["array"] = document.get("array")
    return {**document, "rows": rows}


def hints(row, rows):
    lines = []
    if row.get("data"):
        lines.append(paraview_properties.decorator(10, type="InputDataTypeDecorator", name=DATA[row["data"]]))
    for name, value in row.get("if", {}).items():
        index = next((entry[2] for entry in rows[name]["entries"] if entry[0] == value), int(value is True))
        lines.append(paraview_properties.decorator(10, type="GenericDecorator", property=name, value=index))
    return [" " * 8 + "<Hints>", *lines, " " * 8 + "</Hints>"] if lines else []


def xml_property(row, rows):
    default = row["default"]
    if row["type"] == "enum":
        default = next(entry[2] for entry in row["entries"] if entry[0] == default)
    values = default if isinstance(default, list) else [int(default) if isinstance(default, bool) else default]
    element = ("Int" if row["type"] in ("bool", "int", "enum") else "Double") + "VectorProperty"
    pairs = [
        ("name", row["name"]),
        ("label", row.get("label")),
        ("command", f"Set{row['name']}"),
        ("number_of_elements", len(values)),
        ("default_values", " ".join(map(json.dumps, values))),
        ("animateable", None if row.get("animated") else 0),
        ("panel_visibility", None if row.get("level") == "essential" else "advanced"),
    ]
    head = f"      <{element} "
    # A range that has no ends is there all the same.
    endless = [' ' * 8 + '<DoubleRangeDomain name="range" />'] if row.get("range") == [None, None] else []
    return [
        head + paraview_properties.attributes(pairs, len(head)) + ">",
        *(paraview_properties.domain(row, len(values)) or endless),
        *hints(row, rows),
        f"        <Documentation>{html.escape(row['text'], quote=False)}</Documentation>",
        f"      </{element}>",
    ]


def xml(document, template):
    """The template with the filter's properties in place of the line <!-- properties -->."""
    rows = document["rows"]
    properties = "\n\n".join("\n".join(xml_property(row, rows)) for row in rows.values())
    return template.replace("      <!-- properties -->", properties)
