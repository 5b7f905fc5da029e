"""The JSON schema of study files, from which editors complete keys and values."""

import json
from functools import reduce
from operator import or_
from typing import Any

from pydantic import TypeAdapter

from silostudy.stages import FILE_KINDS


def study_schema() -> str:
    """JSON schema (draft 2020-12) of a study file of any kind, as text."""
    union: Any = reduce(or_, (model for kind in FILE_KINDS.values() for model in kind.models))
    adapter: TypeAdapter = TypeAdapter(union)
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **adapter.json_schema()}
    return json.dumps(schema, indent=1) + "\n"
