"""The page of the JSON schema: one table for each definition."""

import json


def kind(rule):
    """What a value may be, with links to definitions."""
    if "$ref" in rule:
        name = rule["$ref"].rsplit("/", 1)[1]
        return f"[{name}](#{name})"
    if "properties" in rule:
        return "object: " + ", ".join(f"`{key}` {kind(value)}" for key, value in rule["properties"].items())
    for word, joint in (("oneOf", " or "), ("anyOf", " or "), ("allOf", " and ")):
        if word in rule:
            return joint.join(kind(one) for one in rule[word])
    if "enum" in rule:
        return ", ".join(f"`{json.dumps(one)}`" for one in rule["enum"])
    if "const" in rule:
        return f"`{json.dumps(rule['const'])}`"
    types = rule.get("type", "any")
    types = types if isinstance(types, list) else [types]
    if "array" in types and "items" in rule:
        return f"list of {kind(rule['items'])}"
    return " or ".join(types)


def table(rule):
    required = rule.get("required", [])
    rows = ["| key | always there | value |", "|---|---|---|"]
    for key, value in rule["properties"].items():
        words = f"; {value['description']}" if "description" in value else ""
        rows.append(f"| `{key}` | {'yes' if key in required else ''} | {kind(value)}{words} |".replace("\n", " "))
    return "\n".join(rows)


def page(schema):
    text = ["# The JSON schema", f"{schema['title']}. [output.md](output.md) says what the keys mean; the schema itself is "
            "`docs/solve.schema.json`, JSON Schema 2020-12. A document is "
            + (" or ".join(kind(one) for one in schema["oneOf"]) if "oneOf" in schema else kind(schema)) + "."]
    for name, rule in schema["$defs"].items():
        text.append(f"## {name}")
        if "description" in rule:
            text.append(rule["description"])
        text.append(table(rule) if "properties" in rule else kind(rule))
    return text
