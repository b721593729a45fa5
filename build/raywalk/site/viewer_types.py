"""The viewer's types of what the pipeline writes: `python -m raywalk.site.viewer_types FILE`.

`npm run typecheck` runs it first, so that those types are never older than what they are made from:
a scene's data, words, sections and boxes (scene_types.py), a lesson's View (scene/schema.py), and
the Header of trace files (trace_file/trace.schema.json). All are JSON Schemas by then.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

import raywalk.trace_file
from raywalk.scene.schema import BRIGHTEST, ViewTable
from raywalk.site.scene_types import (
    BoxesData,
    SceneData,
    SceneWords,
    SectionsData,
    StopsData,
    SurroundingsData,
    WorkedData,
)
from raywalk.trace.tree import Visibility

# Besides tables: constants whose values the viewer says again, to be refused where they differ.
HEAD = f"""\
/** Made by raywalk/site/viewer_types.py: not to be edited. World units, right-handed, +y up. */
export type Vec3 = readonly [number, number, number];
export type Visibility = {{ {"; ".join(f"{of.name.lower()}: {of}" for of in Visibility)} }};
export type Brightest = {BRIGHTEST:g};
"""
# Of the schemas' names those that the viewer knows by another.
NAMES = {
    "ViewTable": "View", "SwitchesTable": "SwitchesView", "vector": "Vec3", "colour": "Vec3",
    "Camera": "CameraData", "Material": "MaterialData",
}  # fmt: skip
MOST_IN_TUPLE = 4  # a list of up to 6 or 12 numbers is used as a list

Schema = dict[str, Any]


def viewer_types() -> str:
    """The text of the viewer's pipeline-types.d.ts."""
    file = Path(raywalk.trace_file.__file__).parent / "trace.schema.json"
    named = {"Header": json.loads(file.read_text(encoding="utf-8"))}
    for of in (
        SceneData,
        SceneWords,
        SectionsData,
        StopsData,
        SurroundingsData,
        BoxesData,
        WorkedData,
        ViewTable,
    ):
        whole = TypeAdapter(of).json_schema()
        named |= whole.pop("$defs", {}) | {of.__name__: whole}
    return HEAD + "".join(_declaration(name, schema) for name, schema in sorted(named.items()))


def _declaration(name: str, schema: Schema) -> str:
    said = " ".join(schema.get("description", "").split())
    comment = f"\n/** {said} */" if said else ""
    fields = "".join(f"  {field};\n" for field in _fields(schema))
    return f"{comment}\nexport interface {NAMES.get(name, name)} {{\n{fields}}}\n"


def _type(schema: Schema) -> str:
    match schema:
        case {"viewer": str(name)}:
            return name
        case {"$ref": str(ref)}:
            name = ref.rsplit("/", 1)[-1]
            return NAMES.get(name, name)
        case {"const": value}:
            return json.dumps(value)
        case {"enum": values}:
            return " | ".join(map(json.dumps, values))
        case {"anyOf": choices} | {"oneOf": choices}:
            return " | ".join(map(_type, choices))
        case {"type": "array"}:
            return _list(schema)
        case {"type": "object"}:
            return _object(schema)
        case {"type": "number" | "integer"}:
            return "number"
        case {"type": "string" | "boolean" as plain}:
            return str(plain)
    raise ValueError(f"no type of the viewer for {schema}")


def _list(schema: Schema) -> str:
    if "prefixItems" in schema:
        parts = [_type(part) for part in schema["prefixItems"]]
    else:
        each, most = _type(schema["items"]), schema.get("maxItems", MOST_IN_TUPLE + 1)
        if most > MOST_IN_TUPLE:
            return f"readonly ({each})[]" if " " in each else f"readonly {each}[]"
        least = schema["minItems"]
        parts = [each] * least + [f"{each}?"] * (most - least)
    return "Vec3" if parts == ["number"] * 3 else f"readonly [{', '.join(parts)}]"


def _object(schema: Schema) -> str:
    if "properties" not in schema:
        [of] = schema.get("patternProperties", {"": schema.get("additionalProperties")}).values()
        return f"Readonly<Record<string, {_type(of)}>>"
    return f"{{ {'; '.join(_fields(schema))} }}"


def _fields(schema: Schema) -> Iterator[str]:
    """What has a default is there all the same, unless that is null."""
    required = schema.get("required", [])
    for key, part in schema["properties"].items():
        is_there = key in required or part.get("default") is not None
        yield f"readonly {key}{'' if is_there else '?'}: {_type(part)}"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(viewer_types(), encoding="utf-8")
