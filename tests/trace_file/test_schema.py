"""Every file obeys the published JSON Schema, and the schema is strict."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
from conftest import Encoded

import raywalk.trace_file
from raywalk.trace.tree import SENT_ON

SCHEMA = json.loads((Path(raywalk.trace_file.__file__).parent / "trace.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_every_file_obeys_the_schema(encoded: Encoded) -> None:
    VALIDATOR.validate(json.loads(encoded.json))


def test_the_json_is_canonical(encoded: Encoded) -> None:
    """Sorted keys, no spaces: the same content is the same bytes."""
    again = json.dumps(json.loads(encoded.json), sort_keys=True, separators=(",", ":"))
    assert again.encode() == encoded.json


def test_a_material_has_a_share_for_each_kind_of_ray(encoded: Encoded) -> None:
    """The schema lets kinds be added, and says nothing of which there are."""
    named = set(SCHEMA["properties"]["materials"]["items"]["properties"])
    for material in json.loads(encoded.json)["materials"]:
        assert set(material) - named == {kind.name.lower() for kind in SENT_ON}


@pytest.mark.parametrize("key", sorted(SCHEMA["properties"]))
def test_no_key_may_be_missing(glass: Encoded, key: str) -> None:
    header = json.loads(glass.json)
    del header[key]
    assert not VALIDATOR.is_valid(header)
