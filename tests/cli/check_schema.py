# SPDX-License-Identifier: MIT
"""check_schema.py SCHEMA.json SCENE.yaml...: do scene files keep to the schema? Reads the part of JSON Schema that the
schema uses, so that no module but yaml is needed."""
import json
import sys

import yaml

TYPES = {
    "object": lambda v: isinstance(v, dict),
    "array": lambda v: isinstance(v, list),
    "string": lambda v: isinstance(v, str),
    "null": lambda v: v is None,
    "boolean": lambda v: isinstance(v, bool),
    "number": lambda v: isinstance(v, (int, float)) and not isinstance(v, bool),
    "integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
}
KNOWN = {"$schema", "title", "description", "default", "type", "enum", "anyOf", "allOf", "minimum", "maximum", "minLength",
         "maxLength", "items", "minItems", "maxItems", "properties", "additionalProperties", "required"}


def errors(value, schema, path):
    unknown = set(schema) - KNOWN
    if unknown:
        yield f"{path}: the check does not know {unknown}"
    types = schema.get("type", [])
    types = types if isinstance(types, list) else [types]
    if types and not any(TYPES[t](value) for t in types):
        yield f"{path}: {value!r} is no {types}"
        return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{path}: {value!r} is none of {schema['enum']}"
    if "anyOf" in schema and all(list(errors(value, s, path)) for s in schema["anyOf"]):
        yield f"{path}: {value!r} is none of the forms"
    for part in schema.get("allOf", []):
        yield from errors(value, part, path)
    if TYPES["number"](value) and not schema.get("minimum", value) <= value <= schema.get("maximum", value):
        yield f"{path}: {value} is outside"
    if isinstance(value, str) and not schema.get("minLength", 0) <= len(value) <= schema.get("maxLength", len(value)):
        yield f"{path}: a text of {len(value)} characters"
    if isinstance(value, list):
        yield from list_errors(value, schema, path)
    if isinstance(value, dict):
        yield from map_errors(value, schema, path)


def list_errors(value, schema, path):
    if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
        yield f"{path}: {len(value)} items"
    items = schema.get("items", {})
    for i, item in enumerate(value):
        part = items if isinstance(items, dict) else items[i] if i < len(items) else {}
        yield from errors(item, part, f"{path}[{i}]")


def map_errors(value, schema, path):
    properties = schema.get("properties", {})
    for key in schema.get("required", []):
        if key not in value:
            yield f"{path}: {key} is missing"
    for key, part in value.items():
        if key in properties:
            yield from errors(part, properties[key], f"{path}.{key}")
        elif schema.get("additionalProperties", True) is False:
            yield f"{path}: {key} is unknown"


with open(sys.argv[1], encoding="utf-8") as file:
    root = json.load(file)
found = []
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as file:
        found += errors(yaml.safe_load(file), root, name)
print("\n".join(found) or f"{len(sys.argv) - 2} scenes keep to the schema")
sys.exit(bool(found))
