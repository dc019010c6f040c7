#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is made of a style's parameters.json: C++ rows, ParaView's properties, a table for the documentation.

    generate_parameters.py cxx parameters.json OUT.cxx
    generate_parameters.py xml parameters.json OUT.xml TEMPLATE.xml
    generate_parameters.py xml-filter FILTER.json OUT.xml TEMPLATE.xml      # see filter_properties.py
    generate_parameters.py table parameters.json FILE.md      # in place of the table that is there

A row of parameters.json is one parameter. Its entries:

    name      as users write it; also the setter's name, unless `sets` gives another
    type      bool, int, double, enum, color (RGB in 0..1), colors (one or more), vector (of `size` numbers), list (any
              number of numbers) or string
    range     [least, greatest] of each number; null: no limit
    default   of a style that is new; an enumeration's is an entry's name
    level     essential, or without it advanced
    unit      for people; `pixels`: 1 or 2 where lengths or areas are in the picture's pixels
    special   {NUMBER: WORD}: numbers that stand for something else, in few letters for ParaView's labels
    text      one sentence
    label     for people, if not the name's words
    sets      OBJECT.METHOD without its Set, if not the group's object and the name
    option    on the command line, if not the name's words with dashes
    entries   of an enumeration: [name, label] or [name, label, value], the value being the index otherwise
    size, optional, order   of a vector: how many numbers, whether it may have none, `ascending` or `strict`
    check     a function from the text of a string to what is wrong with it
    data      image, mesh or points: the data that has this parameter
    if        {NAME: VALUE}: what another parameter has to be for this one to count
    needs     a parameter that must be on or not empty where this one is given
    implies   {NAME: VALUE}: what else holds where this one is given without these
    follows   the parameter whose value this one takes where only that one is given
    panel     the property's name in ParaView, if not the name; false: it has none
    paneldata, slider, domain   in ParaView: `data` there; a narrower range; `range` or `mid`: that of the array, or `file`:
              a string is a file's name
    tracked, client   in ParaView: the proxy sets the property, too, and nobody's own value is lost by that; and it stays on
              the client, where what it sets are properties
    from      a folder of Styles: the row is that of the same name, or of the one that `of` names, in its table, with what
              stands here in place of its entries. Its setter is that of the style that "styles" has a method for, {FOLDER:
              METHOD}, or without one of this style itself, unless it `sets` another

The table's "prefix" comes before the names of ParaView's properties that `panel` gives none: all styles' stand side by side.
Its "array" is the property that chooses the array of a `domain`.

In a template for ParaView's XML, a line <!-- parameters --> stands for the properties, and <!-- group NAME --> for the
list of those of a group, <!-- group NAME: essential --> and <!-- group NAME: advanced --> for a part of it. A table stands
in a page between the lines <!-- parameters: begin --> and <!-- parameters: end -->.

A group has a name, the object whose methods its rows call, and rows. A shorthand is an option of the command line that sets
several parameters at once: by numbers, or by a word.
"""

import json
import os
import re
import sys

TYPES = {"bool", "int", "double", "enum", "color", "colors", "vector", "list", "string"}
KEYS = {
    "name", "type", "range", "default", "level", "unit", "pixels", "special", "text", "label", "sets", "option", "entries", "size",
    "optional", "order", "check", "client", "data", "if", "needs", "implies", "follows", "panel", "paneldata", "slider",
    "domain", "tracked", "from", "of",
}  # fmt: skip
ORDERS = {None: 0, "ascending": 1, "strict": 2}


def words(name):
    """CamelCase cut into its words."""
    return re.findall(r"[A-Z]+(?![a-z])|[A-Z][a-z0-9]*", name)


def as_text(row, value):
    """A value as SetParameterAsString takes it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, list):
        return ",".join(as_text(row, one) for one in value)
    return value if isinstance(value, str) else json.dumps(value)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def inherited(document, path, row):
    """A row `from` another table, which may have it from a third one, with the object that its setter belongs to."""
    folder, name = row["from"], row.get("of", row["name"])
    other_path = os.path.join(os.path.dirname(path), "..", folder, "parameters.json")
    other = load(other_path)
    for group in other["groups"]:
        for one in group["parameters"]:
            if one["name"] == name:
                target, method = one.get("sets", f"{group['object']}.{name}").split(".")
                objects = other["objects"][target]
                if "from" in one:
                    sets = "sets" in one
                    one, *inner = inherited(other, other_path, one)
                    objects, method = (objects, method) if sets else inner
                steps = [document.get("styles", {}).get(folder, ""), objects]
                # Names in ParaView are those of one style.
                shared = {key: value for key, value in one.items() if key != "panel" or value is False}
                return {**shared, **row}, "()->".join(step for step in steps if step), method
    sys.exit(f"{path}: {row['name']}: expected a row of {folder}, found none named '{name}'")


def read(path):
    """The file, with what its rows leave out filled in."""
    document = load(path)
    rows = {}
    for group in document["groups"]:
        for index, row in enumerate(group["parameters"]):
            name = row["name"]
            given = {}
            if "from" in row:
                sets = row.get("sets")
                row, given["object"], given["method"] = inherited(document, path, row)
                given = {} if sets else given
                group["parameters"][index] = row
            unknown = set(row) - KEYS
            if unknown or name in rows or row["type"] not in TYPES:
                sys.exit(f"{path}: {name}: expected each name once, a known type and keys of {sorted(KEYS)}; found {row}")
            rows[name] = row
            if not given:
                target, given["method"] = row.get("sets", f"{group['object']}.{name}").split(".")
                if target not in document["objects"]:
                    sys.exit(f"{path}: {name}: expected an object of {sorted(document['objects'])}, found '{target}'")
                given["object"] = document["objects"][target]
            row["object"], row["method"], row["group"] = given["object"], given["method"], group["name"]
            row["prefix"] = document.get("prefix", "")
            row["array"] = document.get("array")
            row.setdefault("label", " ".join(words(name)))
            row.setdefault("option", "-".join(words(name)).lower())
            row.setdefault("entries", [])
            row["entries"] = [(entry + [index])[:3] for index, entry in enumerate(row["entries"])]
    for row in rows.values():
        others = [*row.get("if", {}), *row.get("implies", {}), *filter(None, (row.get("needs"), row.get("follows")))]
        for other in others:
            if other not in rows:
                sys.exit(f"{path}: {row['name']}: expected the name of a parameter, found '{other}'")
    document["rows"] = rows
    document.setdefault("shorthands", [])
    return document


def quoted(text):
    return "nullptr" if text is None else json.dumps(text)


def number(value, otherwise):
    return otherwise if value is None else repr(float(value))


def settings(name, values, rows, out):
    """An array of settings, and the expression that stands for it."""
    if not values:
        return "{}"
    entries = ", ".join(f"{{ {quoted(key)}, {quoted(as_text(rows[key], value))} }}" for key, value in values.items())
    out.append(f"constexpr InkParameter::Setting {name}[] = {{ {entries} }};")
    return name


def accessors(document, row):
    """The lambdas that set and get a parameter."""
    target = f"static_cast<{document['class']}*>(style)->"
    target += f"{row['object']}()->" if row["object"] else ""
    setter, getter = f"{target}Set{row['method']}", f"{target}Get{row['method']}"
    kind = row["type"]
    if kind == "string":
        put, get = f"{setter}(value.Text)", f"return {{ {{}}, {getter}() }}"
    elif kind in ("list", "colors") or row.get("optional"):
        put, get = f"{setter}(value.Numbers)", f"return {{ {getter}(), {{}} }}"
    elif kind in ("color", "vector"):
        size = 3 if kind == "color" else row["size"]
        arguments = ", ".join(f"value.Numbers[{i}]" for i in range(size))
        put = f"{setter}({arguments})"
        get = f"const double* v = {getter}(); return {{ {{ {', '.join(f'v[{i}]' for i in range(size))} }}, {{}} }}"
    else:
        cast = {"bool": "value.Numbers[0] != 0.0", "int": "static_cast<{}>(value.Numbers[0])",
                "enum": "static_cast<int>(value.Numbers[0])", "double": "value.Numbers[0]"}[kind]  # fmt: skip
        greatest = (row.get("range") or [0, 0])[1]
        cast = cast.format("vtkIdType" if greatest and greatest > 2147483647 else "int")
        put, get = f"{setter}({cast})", f"return {{ {{ static_cast<double>({getter}()) }}, {{}} }}"
    return (
        f"[](vtkInkStyle* style, const InkParameterValue& value) {{ {put}; }}",
        f"[](vtkInkStyle* style) -> InkParameterValue {{ {get}; }}",
    )


def cxx(document):
    rows = document["rows"]
    arrays, table = [], []
    for row in rows.values():
        name = row["name"]
        entries = "{}"
        if row["entries"]:
            entries = f"{name}Entries"
            listed = ", ".join(f"{{ {quoted(n)}, {quoted(label)}, {value}.0 }}" for n, label, value in row["entries"])
            arrays.append(f"constexpr InkParameter::Entry {entries}[] = {{ {listed} }};")
        implied = settings(f"{name}Implies", row.get("implies"), rows, arrays)
        condition = next(iter(row.get("if", {}).items()), None)
        condition_text = "{ nullptr, nullptr }"
        if condition:
            condition_text = f"{{ {quoted(condition[0])}, {quoted(as_text(rows[condition[0]], condition[1]))} }}"
        least, greatest = row.get("range") or (None, None)
        setter, getter = accessors(document, row)
        table.append(
            ",\n    ".join(
                [
                    f"  {{ {quoted(name)}, {quoted(row['label'])}, InkParameterType::{row['type'].capitalize()}",
                    f"{row.get('size', 0)}, {str(row.get('optional', False)).lower()}, "
                    f"{number(least, '-InkUnlimited')}, {number(greatest, 'InkUnlimited')}, {ORDERS[row.get('order')]}, "
                    f"{row.get('check', 'nullptr')}",
                    f"{quoted(as_text(row, row['default']))}, {quoted(row.get('unit', ''))}, {row.get('pixels', 0)}, "
                    f"{str(row.get('level') == 'essential').lower()}",
                    f"{quoted(row['group'])}, {quoted(row['text'])}, {quoted(row['option'])}",
                    f"{entries}, InkParameterData::{row.get('data', 'any').capitalize()}, {condition_text}, "
                    f"{quoted(row.get('needs'))}, {implied}, {quoted(row.get('follows'))}",
                    setter,
                    getter + " }",
                ]
            )
        )
    shorthands = []
    for index, shorthand in enumerate(document["shorthands"]):
        listed = []
        for word, values in shorthand.get("words", {}).items():
            array = settings(f"Word{index}{word.capitalize()}", values, rows, arrays)
            listed.append(f"{{ {quoted(word)}, {array} }}")
        arrays.append(f"constexpr InkShorthand::Word Words{index}[] = {{ {', '.join(listed)} }};")
        spans = []
        for key in ("numbers", "names"):
            if shorthand.get(key):
                arrays.append(f"constexpr const char* {key.capitalize()}{index}[] = "
                              f"{{ {', '.join(quoted(one) for one in shorthand[key])} }};")  # fmt: skip
            spans.append(f"{key.capitalize()}{index}" if shorthand.get(key) else "{}")
        shorthands.append(f"  {{ {quoted(shorthand['option'])}, {quoted(shorthand['text'])}, {quoted(shorthand['group'])}, "
                          f"Words{index}, {spans[0]}, {spans[1]} }}")  # fmt: skip
    includes = "\n".join(f'#include "{header}"' for header in ["InkParameter.h", f"{document['class']}.h", *document["includes"]])
    function = document["class"].removeprefix("vtk").removesuffix("Style") + "Parameters"
    arrays_text, table_text, shorthands_text = "\n".join(arrays), ",\n".join(table), ",\n".join(shorthands)
    # C++ has no arrays of nothing.
    shorthands_text = (f"constexpr InkShorthand Shorthands[] = {{\n{shorthands_text}\n}};" if shorthands
                       else "constexpr std::span<const InkShorthand> Shorthands;")  # fmt: skip
    return f"""// Generated from the parameters.json of the style {document['style']}; not to be edited.
{includes}

namespace
{{

{arrays_text}

const InkParameter Parameters[] = {{
{table_text}
}};

{shorthands_text}

}} // namespace

const InkParameterTable& {function}()
{{
  static const InkParameterTable table{{ Parameters, Shorthands }};
  return table;
}}
"""


def shown_range(row):
    least, greatest = row.get("range") or (None, None)
    if row["entries"]:
        return ", ".join(entry[0] for entry in row["entries"])
    if least is None and greatest is None:
        return {"bool": "on, off", "string": "text", "list": "numbers"}.get(row["type"], row["type"])
    if greatest is None:
        return f"from {json.dumps(least)}"
    return f"{json.dumps(least)} to {json.dumps(greatest)}"


def table(document, page):
    """The page with its table of all parameters."""
    lines = ["| parameter | option of `ink render` | default | range | |", "|---|---|---|---|---|"]
    for level in ("essential", "advanced"):
        for row in document["rows"].values():
            if row.get("level", "advanced") != level:
                continue
            name = f"**{row['name']}**" if level == "essential" else row["name"]
            negated = "no-" if row["default"] is True else ""
            unit = f" {row['unit']}" if row.get("unit") else ""
            default = as_text(row, row["default"]) or "none"
            lines.append(f"| {name} | `--{negated}{row['option']}` | {default} | {shown_range(row)}{unit} | {row['text']} |")
    begin, end = "<!-- parameters: begin -->\n", "<!-- parameters: end -->"
    if page.count(begin) != 1 or page.count(end) != 1:
        sys.exit(f"expected one line {begin.strip()} and one {end} in the page")
    head, rest = page.split(begin)
    return head + begin + "\n".join(lines) + "\n" + end + rest.split(end)[1]


def main():
    # These read tables as this does.
    import filter_properties
    import paraview_properties

    back_end, path, *files = sys.argv[1:]
    makers = {"cxx": (read, cxx), "table": (read, table), "xml": (read, paraview_properties.xml),
              "xml-filter": (filter_properties.read, filter_properties.xml)}  # fmt: skip
    load_table, make = makers[back_end]
    arguments = [load_table(path)]
    if back_end != "cxx":
        with open(files[-1], encoding="utf-8") as file:
            arguments.append(file.read())
    text = make(*arguments)
    if files:
        with open(files[0], "w", encoding="utf-8") as file:
            file.write(text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
