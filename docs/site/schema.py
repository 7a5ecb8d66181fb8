"""Writes the page of a JSON schema: one table for each definition."""

import json
import re


def linked(text):
    """Returns a text with links to the pages that it names."""
    return re.sub(r"\b(\w+\.md)\b", r"[\1](\1)", text)


def kind(rule):
    """Returns the description of a value, with links to definitions."""
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
        words = f"; {linked(value['description'])}" if "description" in value else ""
        rows.append(f"| `{key}` | {'yes' if key in required else ''} | {kind(value)}{words} |".replace("\n", " "))
    return "\n".join(rows)


def page(heading, file):
    schema = json.loads(file.read_text(encoding="utf-8"))
    text = [f"# {heading}", f"{schema['title']}. {linked(schema['description'])} The schema itself is `docs/{file.name}`, JSON "
            "Schema 2020-12. A document is " + kind(schema) + "."]
    for name, rule in schema["$defs"].items():
        text.append(f"## {name}")
        if "description" in rule:
            text.append(linked(rule["description"]))
        text.append(table(rule) if "properties" in rule else kind(rule))
    return text
