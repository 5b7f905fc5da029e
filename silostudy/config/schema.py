"""The JSON schema of study files, from which editors complete keys and values."""

import json

from silostudy.config.study import Study


def study_schema() -> str:
    """JSON schema (draft 2020-12) of a study file, as text."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **Study.model_json_schema()}
    return json.dumps(schema, indent=1) + "\n"
