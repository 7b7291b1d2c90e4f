#!/usr/bin/env python3
"""poolhall-lab compare: its pictures and what it refuses."""

import json
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROGRAM = os.environ["POOLHALL_LAB"]
SCENES = Path(os.environ["POOLHALL_SCENES"])
# Colours of the first three solvers, as cairo writes them.
COLOURS = (r"rgb\(0%, ?0%, ?0%\)", r"rgb\(83\.5\d*%, ?36\.9\d*%, ?0%\)", r"rgb\(0%, ?44\.7\d*%, ?69\.8\d*%\)")


def run(*arguments, text=""):
    return subprocess.run([PROGRAM, "compare", *map(str, arguments)], input=text, capture_output=True, text=True)


def ways(svg, colour):
    """The open lines of straight pieces in that colour, which are the balls' ways and the legend's line."""
    paths = [tag for tag in re.findall(r"<path [^>]*>", svg) if re.search(rf'stroke(:|="){colour}', tag)]
    return [tag for tag in paths if " L " in tag and " C " not in tag and len(re.findall(r"\bM ", tag)) == 1]


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_refused(self, result, reason):
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"poolhall-lab: {reason}\n")

    def test_a_picture_has_a_path_for_each_ball_and_solver(self):
        result = run(SCENES / "draw.json", "--solver", "event", "--solver", "euler:30", "--solver", "euler:480",
                     "--out", self.folder / "new")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        svg = (self.folder / "new/compare.svg").read_text()
        self.assertTrue(ElementTree.fromstring(svg).tag.endswith("svg"))
        for colour in COLOURS:
            # Cue ball, object ball, and the legend's line.
            self.assertEqual(len(ways(svg, colour)), 3, colour)

    def test_the_same_picture_as_png(self):
        for name in ("break_9_ball", "end_game", "jaw_rattle", "jump"):
            file = self.folder / f"{name}.png"
            self.assertEqual(run(SCENES / f"{name}.json", "--picture", file).returncode, 0)
            looked = subprocess.run(["identify", "-format", "%m %w %k", file], check=True, capture_output=True, text=True)
            kind, width, colours = looked.stdout.split()
            self.assertEqual((kind, width), ("PNG", "1600"), name)
            self.assertGreater(int(colours), 100, name)

    def test_an_endless_cloth_is_as_large_as_its_paths(self):
        scene = json.dumps({"schema": "poolhall.scene/1", "table": {"length": 2, "width": 1, "rails": False}, "effects": {"rolling": {"mu": 0.01}},
                            "balls": [{"id": "a", "r": [0, 0], "v": [3, 1]}]})
        result = run("--picture", self.folder / "a.svg", text=scene)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertNotIn("nan", (self.folder / "a.svg").read_text())

    def test_the_solvers_are_those_asked_for(self):
        self.assertIn("overlap:30", run(SCENES / "draw.json").stdout)
        out = run("--solver", "semi_implicit:60", SCENES / "draw.json").stdout
        self.assertIn("semi_implicit:60", out)
        self.assertNotIn("euler", out)
        self.assertEqual(run("--solver", "rk4", SCENES / "draw.json").returncode, 2)

    def test_bad_scenes_are_refused_with_line_and_pointer(self):
        scene = json.loads((SCENES / "draw.json").read_text())
        scene["balls"][1]["r"] = scene["balls"][0]["r"]
        self.assert_refused(run("-", text="\n" + json.dumps(scene)), "line 2: /balls/1/r: overlaps /balls/0")
        self.assert_refused(run(text='{\n"schema": x\n}'), "line 2: a syntax error at byte 11")
        self.assert_refused(run(text="[]"), "line 1: the scene must be an object")
        self.assert_refused(run(text=""), "there is no scene")
        line = json.dumps(json.loads((SCENES / "draw.json").read_text())) + "\n"
        self.assert_refused(run(text=2 * line), "line 2: there is more than one scene")

    def test_a_scene_that_no_solver_takes_is_refused(self):
        result = run("--solver", "overlap:30", SCENES / "jump.json")
        self.assert_refused(result, "line 1: /solver/kind: overlap knows no heights: not with airborne")

    def test_names_of_balls_in_any_script_are_drawn(self):
        scene = json.loads((SCENES / "draw.json").read_text())
        pictures = set()
        for name in ("a", "\u738b", "\u05d1\u05e9", "\u0628\u0628", "\U0001f3b1"):
            scene["balls"][1]["id"] = name
            result = run("--picture", self.folder / "a.svg", text=json.dumps(scene))
            self.assertEqual((result.returncode, result.stderr), (0, ""), name)
            pictures.add((self.folder / "a.svg").read_bytes())
        self.assertEqual(len(pictures), 5)

    def test_a_machine_without_fonts_is_told_so(self):
        fonts = self.folder / "fonts.conf"
        fonts.write_text('<!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig><dir>/nowhere</dir></fontconfig>')
        picture = self.folder / "a.svg"
        result = subprocess.run([PROGRAM, "compare", SCENES / "draw.json", "--picture", picture], capture_output=True, text=True,
                                env=dict(os.environ, FONTCONFIG_FILE=str(fonts)))
        self.assertEqual(result.returncode, 2)
        self.assertIn("no font: fontconfig finds none", result.stderr)
        self.assertFalse(picture.exists())

    def test_files_that_cannot_be_read_or_written_are_refused(self):
        self.assert_refused(run(self.folder / "none.json"), f"{self.folder}/none.json cannot be opened")
        draw = SCENES / "draw.json"
        self.assert_refused(run(draw, "--picture", "/nowhere/a.png"), "/nowhere/a.png cannot be written: No such file or directory")
        self.assert_refused(run(draw, "--picture", "a.jpg"), "a.jpg must end in .svg or .png")
        file = self.folder / "file"
        file.write_text("")
        self.assert_refused(run(draw, "--out", file), f"{file} is no folder, and cannot be made one")
        full = subprocess.run(f"{PROGRAM} compare {draw} >/dev/full", shell=True, capture_output=True, text=True)
        self.assertEqual((full.returncode, full.stderr), (2, "poolhall-lab: standard output cannot be written\n"))


if __name__ == "__main__":
    unittest.main()
