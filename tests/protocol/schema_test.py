"""Holds the schemas and asyncapi.yaml against what the code says and sends.

usage: schema_test.py PROTOCOL_SAMPLES PROTOCOL_FOLDER
"""

import copy
import json
import pathlib
import re
import subprocess
import sys
import unittest
import warnings

import jsonschema
import yaml

SAMPLES, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
ROUNDS = 40


def samples(*arguments):
    text = subprocess.run([SAMPLES, *arguments], check=True, capture_output=True, text=True).stdout
    return [json.loads(line) for line in text.splitlines()]


def schema(name):
    return json.loads((FOLDER / "schema" / name).read_text())


def validator(name):
    # RefResolver is what Debian 12 has; later versions keep it, with a warning.
    warnings.simplefilter("ignore", DeprecationWarning)
    root = schema(name)
    resolver = jsonschema.RefResolver((FOLDER / "schema" / name).resolve().as_uri(), root)
    return jsonschema.Draft202012Validator(root, resolver=resolver)


def knows(root, part, steps):
    """Whether a value at the pointer's steps is one that the schema's part describes."""
    if "$ref" in part:
        return knows(root, root["$defs"][part["$ref"].rsplit("/", 1)[1]], steps)
    if not steps:
        return True
    if any(knows(root, choice, steps) for choice in part.get("anyOf", [])):
        return True
    below = part.get("items") if steps[0].isdigit() else part.get("properties", {}).get(steps[0])
    return below is not None and knows(root, below, steps[1:])


KEYS = ("default", "minimum", "exclusiveMinimum", "maximum")
CATALOG = samples("catalog")[0]
MESSAGES = samples("messages", str(ROUNDS))
# One of each kind, and of `move` one with each kind of move.
CLIENT_MESSAGES = len(CATALOG["client"]) - 1 + len(CATALOG["moves"])


class Schemas(unittest.TestCase):
    def test_are_schemas(self):
        for name in ("client-message.json", "server-message.json", "game.json", "scene.json", "result.json"):
            jsonschema.Draft202012Validator.check_schema(schema(name))

    def test_list_the_messages_of_the_code(self):
        for side in ("client", "server"):
            listed = [entry["$ref"].rsplit("/", 1)[1] for entry in schema(f"{side}-message.json")["oneOf"]]
            self.assertEqual(listed, list(CATALOG[side]))

    def test_list_the_moves_and_the_games_of_the_code(self):
        defs = schema("game.json")["$defs"]
        for kind, listed in (("moves", defs["move"]["oneOf"]), ("games", defs["state"]["properties"]["part"]["oneOf"])):
            self.assertEqual([entry["$ref"].rsplit("/", 1)[1] for entry in listed], list(CATALOG[kind]))

    def test_list_the_fields_of_the_code(self):
        objects = dict(CATALOG["parts"])
        for side in ("client", "server"):
            file = f"{side}-message.json"
            objects[file] = {**objects.get(file, {}), **CATALOG[side]}
        objects["game.json"] = {**objects["game.json"], **CATALOG["moves"], **CATALOG["games"]}
        for file, parts in objects.items():
            root = schema(file)
            for part, fields in parts.items():
                described = root["$defs"][part] if part else root
                with self.subTest(file=file, part=part):
                    self.assertEqual(set(described["properties"]), set(fields))
                    required = {field for field, is_required in fields.items() if is_required}
                    self.assertEqual(set(described["required"]), required)

    def test_have_the_bounds_defaults_and_units_of_the_code(self):
        root = schema("scene.json")
        for part, fields in CATALOG["listed"].items():
            described = root["$defs"][part] if part else root
            for field, listed in fields.items():
                with self.subTest(part=part, field=field):
                    found = described["properties"][field]
                    bounds = {key: found[key] for key in KEYS if key in found}
                    self.assertEqual(bounds, {key: listed[key] for key in KEYS if key in listed})
                    self.assertIn(listed["unit"], found.get("description", ""))

    def test_have_the_solvers_and_models_of_the_code(self):
        parts = schema("scene.json")["$defs"]
        self.assertEqual(parts["solver_kind"]["enum"], CATALOG["solver_kinds"])
        for effect, names in CATALOG["models"].items():
            self.assertEqual(parts[effect]["properties"]["model"]["enum"], names)

    def test_have_the_presets_of_the_code(self):
        parts = schema("scene.json")["$defs"]
        page = (FOLDER / "PROTOCOL.md").read_text()
        for part, names in CATALOG["presets"].items():
            self.assertEqual(parts[f"{part}_preset"]["properties"]["preset"]["enum"], names)
            for name in names:
                self.assertIn(f"`{name}`", page)

    def test_know_every_field_of_a_scene(self):
        root, check = schema("scene.json"), validator("scene.json")
        leaves = samples("leaves")
        self.assertGreater(len(leaves), 60)
        for leaf in leaves:
            check.validate(leaf["scene"])
            self.assertTrue(knows(root, root, leaf["pointer"].split("/")[1:]), leaf["pointer"])

    def test_accept_what_the_code_sends(self):
        validators = {side: validator(f"{side}-message.json") for side in ("client", "server")}
        self.assertEqual(len(MESSAGES), ROUNDS * (CLIENT_MESSAGES + len(CATALOG["server"])))
        for sample in MESSAGES:
            validators[sample["from"]].validate(sample["message"])

    def test_accept_the_scenes_and_results_that_the_code_writes(self):
        scene, result = validator("scene.json"), validator("result.json")
        lines = samples("results", str(ROUNDS))
        self.assertEqual(len(lines), 3 * ROUNDS)
        for i in range(0, len(lines), 3):
            scene.validate(lines[i])
            result.validate(lines[i + 1])
            result.validate(lines[i + 2])
            self.assertIsInstance(lines[i + 2]["duration"], str)

    def test_refuse_what_clients_must_not_send(self):
        check = validator("client-message.json")
        for sample in MESSAGES[:CLIENT_MESSAGES]:
            message = sample["message"]
            for field, required in CATALOG["client"][message["type"]].items():
                if required:
                    spoilt = copy.deepcopy(message)
                    del spoilt[field]
                    self.assertFalse(check.is_valid(spoilt), spoilt)
                self.assertFalse(check.is_valid({**message, field: None}), field)
            self.assertFalse(check.is_valid({**message, "extra": 1}))
            self.assertFalse(check.is_valid({**message, "seq": 0}))

    def test_refuse_moves_that_are_none(self):
        check = validator("client-message.json")

        def is_valid(move):
            return check.is_valid({"type": "move", "seq": 1, "seat": 0, "move": move})

        moves = [sample["message"]["move"] for sample in MESSAGES[:CLIENT_MESSAGES] if "move" in sample["message"]]
        self.assertEqual([move["type"] for move in moves], list(CATALOG["moves"]))
        for move in moves:
            self.assertTrue(is_valid(move), move)
            self.assertFalse(is_valid({**move, "extra": 1}), move)
            for field in move:
                spoilt = copy.deepcopy(move)
                del spoilt[field]
                self.assertFalse(is_valid(spoilt), spoilt)
        self.assertTrue(is_valid({"type": "shoot", "strike": {"direction": [1, 0]}}))
        for strike in ({}, {"direction": [0, 0]}, {"direction": [1, 0], "speed": -1}, {"direction": [1, 0], "spin": 1},
                       {"direction": [1, 0], "offset": [2, 0]}, {"direction": [1, 0], "elevation": -1}):
            self.assertFalse(is_valid({"type": "shoot", "strike": strike}), strike)
        self.assertFalse(is_valid({"type": "dance"}))

    def test_refuse_settings_that_are_none(self):
        check = validator("client-message.json")
        for settings, good in (({}, True), ({"race_to": 3, "breaks": "loser", "turns": "solo"}, True),
                               ({"race": 3}, False), ({"breaks": "first"}, False), ({"shot_clock_s": 7.5}, False)):
            message = {"type": "create_match", "seq": 1, "name": "Ann", "settings": settings}
            self.assertEqual(good, check.is_valid(message), settings)


class AsyncApi(unittest.TestCase):
    def setUp(self):
        self.document = yaml.safe_load((FOLDER / "asyncapi.yaml").read_text())

    def messages(self, operation):
        listed = self.document["channels"]["/ws"][operation]["message"]["oneOf"]
        return [entry["$ref"].rsplit("/", 1)[1] for entry in listed]

    def test_lists_the_messages_of_the_code(self):
        for side, operation in (("client", "publish"), ("server", "subscribe")):
            self.assertEqual(self.messages(operation), [f"{side}_{name}" for name in CATALOG[side]])

    def test_points_each_message_to_its_schema(self):
        for key, message in self.document["components"]["messages"].items():
            side, name = key.split("_", 1)
            self.assertEqual(message["name"], name)
            self.assertEqual(message["payload"]["$ref"], f"./schema/{side}-message.json#/$defs/{name}")
            self.assertIn(name, CATALOG[side])


# The objects within messages whose fields have a table of their own, by its heading.
TABLES = {
    "Table state": ("server-message.json", "table_state"),
    "Shot in progress": ("server-message.json", "live_shot"),
    "Seat": ("server-message.json", "seat_info"),
    "Event": ("server-message.json", "event"),
    "Final ball": ("server-message.json", "final_ball"),
    "Effect use": ("server-message.json", "effect_use"),
    "Scene": ("scene.json", ""),
    "Effects": ("scene.json", "effects"),
    "Settings": ("game.json", "settings"),
    "State": ("game.json", "state"),
    "What is legal": ("game.json", "legal"),
    "Ruling": ("game.json", "ruling"),
}


def names_in_rows(text):
    """What stands in code in the first cell of each row."""
    cells = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \|", text, re.M)
    return [name for cell in cells for name in re.findall(r"`(\w+)`", cell)]


class Page(unittest.TestCase):
    def test_names_every_solver_of_a_scene(self):
        page = (FOLDER / "PROTOCOL.md").read_text()
        row = re.search(r"^\| `solver` \| object \| (.*) \|$", page, re.M)[1]
        for name in CATALOG["solver_kinds"]:
            self.assertIn(f"`{name}`", row)

    def test_has_a_row_with_the_parameters_and_defaults_of_each_effect(self):
        page = (FOLDER / "PROTOCOL.md").read_text()
        part = page[page.index("#### Effects"): page.index("### Settings")]
        rows = dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", part, re.M))
        self.assertEqual(list(rows), list(CATALOG["parts"]["scene.json"]["effects"]))
        for effect, text in rows.items():
            for field, listed in CATALOG["listed"][effect].items():
                self.assertIn(f"`{field}`", text)
                if "default" in listed:
                    self.assertIn(f"`{field}` ({listed['default']:.10g}", text, effect)

    def sections(self):
        """The text below each heading, up to the next heading of any level."""
        page = (FOLDER / "PROTOCOL.md").read_text()
        return dict(re.findall(r"^#+ ([^\n]+)\n(.*?)(?=^#+ |\Z)", page, re.S | re.M))

    def test_has_a_table_with_the_fields_of_each_part(self):
        sections = self.sections()
        for heading, (file, part) in TABLES.items():
            with self.subTest(heading=heading):
                self.assertEqual(set(names_in_rows(sections[heading])), set(CATALOG["parts"][file][part]))

    def test_has_a_heading_for_each_move_and_a_row_for_each_of_its_fields(self):
        page = (FOLDER / "PROTOCOL.md").read_text()
        part = page[page.index("### Moves"): page.index("### State")]
        sections = dict(re.findall(r"^#### `(\w+)`\n(.*?)(?=^#### |\Z)", part, re.S | re.M))
        self.assertEqual(list(sections), list(CATALOG["moves"]))
        stroke = CATALOG["parts"]["game.json"]["stroke"]
        for move, text in sections.items():
            fields = set(CATALOG["moves"][move]) - {"type"} | (set(stroke) if move == "shoot" else set())
            self.assertEqual(set(names_in_rows(text)), fields, move)

    def test_names_the_fields_of_what_is_legal_and_of_each_games_part(self):
        page = (FOLDER / "PROTOCOL.md").read_text()
        games = page[page.index("## Games"): page.index("## Reject codes")]
        parts = CATALOG["parts"]["game.json"]
        for name in [*parts["region"], *parts["stroke_bounds"]]:
            self.assertIn(f"`{name}`", games)
        for game, fields in CATALOG["games"].items():
            section = games[games.index(f"### `{game}`"):]
            for name in fields:
                self.assertIn(name, section)

    def test_has_a_heading_for_each_message_and_a_row_for_each_field(self):
        page = (FOLDER / "PROTOCOL.md").read_text()
        for side, end in (("client", "## From the server"), ("server", "## Parts of messages")):
            part = page[page.index(f"## From the {side}"): page.index(end)]
            sections = dict(re.findall(r"^### `(\w+)`\n(.*?)(?=^### |\Z)", part, re.S | re.M))
            self.assertEqual(list(sections), list(CATALOG[side]))
            for name, text in sections.items():
                rows = set(re.findall(r"^\| `(\w+)` \|", text, re.M))
                implied = {"type", "seq"} if side == "client" else {"type"}
                self.assertEqual(rows, set(CATALOG[side][name]) - implied, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
