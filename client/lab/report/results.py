"""Reads what poolhall-lab has measured; a file that is not as schema/ says is refused with one line."""

import json
from pathlib import Path

import jsonschema

SCHEMAS = Path(__file__).resolve().parent / "schema"
# What must be as long as the first of its group, the abscissa.
SERIES = {"error_in_time": ("t", "median", "p90"), "tunnelling": ("speed", "missed"), "crowds": ("balls", "ns")}


class BadResults(Exception):
    """One line: the file, the place in it, and what is wrong."""


def _no_constant(name):
    raise ValueError(f"{name} is no JSON number")


def _parse(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"), parse_constant=_no_constant)
    except OSError as error:
        raise BadResults(f"{path}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise BadResults(f"{path}: no JSON: {error}") from error


def _read(path, schema_name):
    data = _parse(path)
    schema = json.loads((SCHEMAS / schema_name).read_text(encoding="utf-8"))
    fault = jsonschema.exceptions.best_match(jsonschema.Draft202012Validator(schema).iter_errors(data))
    if fault:
        where = "/".join(["", *map(str, fault.absolute_path)]) or "the whole"
        raise BadResults(f"{path}: {where}: {fault.message[:200]}")
    return data


def _check_lengths(path, where, series, names):
    for number, one in enumerate(series):
        if len({len(one[name]) for name in names}) > 1:
            raise BadResults(f"{path}: {where}/{number}: {', '.join(names)} are not equally long")


def read_accuracy(path):
    """A poolhall.accuracy/1 as a dict; raises BadResults."""
    data = _read(path, "accuracy.schema.json")
    for number, ensemble in enumerate(data["ensembles"]):
        _check_lengths(path, f"/ensembles/{number}/error_in_time", ensemble["error_in_time"], SERIES["error_in_time"])
    for name in ("tunnelling", "crowds"):
        _check_lengths(path, f"/{name}", data[name], SERIES[name])
    return data


def read_effects(path):
    """A poolhall.effects/1 as a dict, or None where there is no such file; raises BadResults."""
    return _read(path, "effects.schema.json") if path.exists() else None


def read_validate(path):
    """A poolhall.validate/1 as a dict, or None where there is no such file; raises BadResults."""
    if not path.exists():
        return None
    data = _read(path, "validate.schema.json")
    for number, figure in enumerate(data["figures"]):
        _check_lengths(path, f"/figures/{number}/curves", figure["curves"], ("x", "y"))
    for number, table in enumerate(data["tables"]):
        for name in ("rms", "rms_without_outliers"):
            _check_lengths(path, f"/tables/{number}", [table], ("models", name))
        _check_lengths(path, f"/tables/{number}/rows", [{**row, "models": table["models"]} for row in table["rows"]],
                       ("models", "ours", "errors"))
    return data


def solvers_of(ensemble):
    """Points by solver, slowest rate first; solvers in one order everywhere."""
    order = ("euler", "semi_implicit", "exact_arc", "overlap", "event")
    groups = {}
    for point in sorted(ensemble["points"], key=lambda point: (order.index(point["solver"]), point["hz"] or 0)):
        groups.setdefault(point["solver"], []).append(point)
    return groups


def point_of(ensemble, label):
    """The point with that label (`euler:30`), or None."""
    return next((point for point in ensemble["points"] if point["label"] == label), None)


def ensemble_of(accuracy, name):
    return next((ensemble for ensemble in accuracy["ensembles"] if ensemble["name"] == name), None)


def median_of(point, quantity):
    """The median of a spread such as rest_error, or None where there is none."""
    spread = point.get(quantity)
    return spread["median"] if spread else None
