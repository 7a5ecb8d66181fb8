"""Problem files as nested dicts with exact numbers, and their conversion to text."""

import json
import re
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Real
from os import PathLike, fspath

import numpy as np

from ._core import InvalidData


def exact(value, field):
    """Returns the text of an exact number. Raises InvalidData.

    A float stands for the decimal that it prints. A number of mpmath has the digits of mpmath.mp.dps, a result of this
    module all its digits.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, str):
        return value
    if hasattr(value, "_mpf_"):
        return getattr(value, "digits", "") or str(value)
    if isinstance(value, Integral) and not isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float):
        return float.__repr__(value)
    if isinstance(value, Fraction):
        return f"{value.numerator}/{value.denominator}"
    if isinstance(value, (Decimal, Real)) and not isinstance(value, bool):
        return str(value)
    raise InvalidData(f"{field}: wrong type; a number is a string, an integer or a decimal; {type(value).__name__}")


def whole(value, field):
    """Returns a whole number as an int. Raises InvalidData."""
    if not isinstance(value, Integral) or isinstance(value, bool):
        raise InvalidData(f"{field}: wrong type; it is a whole number; {value!r}")
    if abs(value) >= 2**31:
        raise InvalidData(f"{field}: out of range; its size is below 2^31; {value}")
    return int(value)


def real(value, field):
    """Returns a number as a float. Raises InvalidData."""
    if isinstance(value, (Real, Decimal)) and not isinstance(value, bool):
        return float(value)
    raise InvalidData(f"{field}: wrong type; it is a number; {value!r}")


def text(value, field):
    """Returns a text. Raises InvalidData for another type."""
    if isinstance(value, str):
        return value
    raise InvalidData(f"{field}: wrong type; it is a text; {value!r}")


def optional(convert, value, field):
    """Returns the converted value, and None for None."""
    return None if value is None else convert(value, field)


def is_array(value):
    return isinstance(value, (list, tuple)) or getattr(value, "ndim", 0) > 0


def is_pair(value):
    """Returns True for two columns, such as (x, heights)."""
    return is_array(value) and len(value) == 2 and all(map(is_array, value))


def table(columns, field):
    """Returns two columns of numbers as the text of a file, a row on each line. Raises InvalidData."""
    x, values = ([exact(number, f"{field}[{k}]") for k, number in enumerate(column)] for column in columns)
    if len(x) != len(values):
        raise InvalidData(f"{field}: columns of different lengths; each x has one value; {len(x)} and {len(values)}")
    return "".join(f"{a},{b}\n" for a, b in zip(x, values)) or "\n"


def piece_of(piece, k):
    """Returns a pair (to, profile) as a dict. Raises InvalidData for a list of another length."""
    if not is_array(piece):
        return piece
    if len(piece) != 2:
        raise InvalidData(f"indenter.pieces[{k}]: wrong length; a piece is (to, profile); {len(piece)} entries")
    return dict(zip(("to", "profile"), piece))


def without_arrays(document):
    """Returns a document in which text and lists stand for pairs of arrays, and the ends of the friction's edges or None."""
    indenter, friction, ends = document.get("indenter"), document.get("friction"), None
    for name, group, keys in (("friction", friction, ("values", "jumps")), ("indenter", indenter, ("support",))):
        for key in keys if isinstance(group, dict) else ():
            if isinstance(group.get(key), (Real, Decimal)):
                raise InvalidData(f"{name}.{key}: wrong type; it is an array of numbers; a number")
    if isinstance(indenter, dict):
        if is_array(indenter.get("pieces")):
            indenter = indenter | {"pieces": [piece_of(piece, k) for k, piece in enumerate(indenter["pieces"])]}
        samples = indenter.get("samples")
        if is_pair(samples):
            samples = table(samples, "indenter.samples")
        elif is_array(samples):
            raise InvalidData("indenter.samples: wrong type; it is (x, heights), the name of a file or a dict; an array")
        elif isinstance(samples, dict) and is_pair(samples.get("file")):
            samples = samples | {"file": table(samples["file"], "indenter.samples.file")}
        elif isinstance(samples, PathLike):
            samples = fspath(samples)
        document = document | {"indenter": indenter | {"samples": samples}}
    if is_pair(friction):
        edges, values = friction
        if len(edges) == len(values) + 1:
            ends, edges = (edges[0], edges[-1]), edges[1:-1]
        document = document | {"friction": {"values": values, "jumps": edges}}
    return document, ends


def quoted(text):
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def keyed(key):
    """Returns a key of TOML, in quotes unless it consists of letters, digits, _ and -."""
    return key if re.fullmatch("[A-Za-z0-9_-]+", str(key)) else quoted(str(key))


def toml(value, field=""):
    """Returns an inline value of a problem file. Numbers become strings, so that they stay exact."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        entries = (f"{keyed(key)} = {toml(inner, f'{field}.{key}')}" for key, inner in value.items() if inner is not None)
        return "{" + ", ".join(entries) + "}"
    if is_array(value):
        return "[" + ", ".join(toml(inner, f"{field}[{k}]") for k, inner in enumerate(value)) + "]"
    return quoted(exact(value, field))


def text_of(document):
    """Returns the text of a problem file."""
    return "".join(f"{keyed(key)} = {toml(value, key)}\n" for key, value in document.items() if value is not None)


def changed(document, path, value):
    """Sets the datum at a path such as "friction.values[1]" in a document. Raises InvalidData if there is no such datum."""
    parts = [int(index) if index else key for key, index in re.findall(r"([^.\[\]]+)|\[(\d+)\]", path)]
    try:
        if not re.fullmatch(r"[^.\[\]]+(\[\d+\])*(\.[^.\[\]]+(\[\d+\])*)*", path):
            raise KeyError
        *outer, last = parts
        for part in outer:
            document = document.setdefault(part, {}) if isinstance(document, dict) else document[part]
        if isinstance(document, list) and last >= len(document):
            raise IndexError
        document[last] = value
    except (IndexError, KeyError, TypeError, AttributeError):
        raise InvalidData(f"{path}: no such datum; it names one of the problem's; absent") from None
