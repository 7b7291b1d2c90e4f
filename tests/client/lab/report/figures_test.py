"""The figures have what the numbers have: well-formed, labelled, a point a number, drawn; and the same each time."""

import re
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import report_files
from PIL import Image

SVG = "{http://www.w3.org/2000/svg}"
# Figure: the words that stand in it, and how many points a line has.
FIGURES = {
    "work_precision": (["CPU time of a shot", "error at rest, median", "One ball", "Two balls", "euler", "exact_arc", "overlap",
                        "event", "0"], {}),
    "work_precision_two_balls": (["CPU time of a shot", "error at rest, median", "euler", "exact_arc", "overlap", "event", "480",
                                  "10 µs", "100 µm"],
                                 {"points-euler": 3, "points-exact_arc": 3, "points-overlap": 3, "points-event": 1}),
    "work_precision_one_ball": (["euler", "exact_arc", "event"], {"points-euler": 3, "points-exact_arc": 3, "points-event": 1}),
    "verdict_flips": (["ticks a second", "share of shots", "Two balls", "euler", "event", "10 %"],
                      {"points-euler": 3, "points-exact_arc": 3, "points-overlap": 3, "points-event": 1}),
    "error_in_time": (["time since the strike (s)", "error at that time, median", "euler:30", "event"],
                      {"curve-euler:30": 4, "curve-event": 4}),  # at 0 s there is no error, and no place for it
    "tunnelling": (["speed of the ball (m/s)", "collisions missed (%)", "overlap:30", "event"],
                   {"curve-overlap:30": 4, "curve-event": 4}),
    "crowds": (["balls on the table", "CPU time of a shot", "euler:30", "event"], {"curve-euler:30": 3, "curve-event": 3}),
    "effects": (["CPU time of a shot", "how far the balls' rest moves", "sliding  (two_balls)", "in the scene", "25.0 %"],
                {"points-zero": 2, "points-present": 3, "points-worth": 2}),
}


class FiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.out = report_files.measured_folder(Path(cls.scratch.name) / "first")
        cls.result = report_files.run("--draw-only", "--out", cls.out)

    def test_the_program_draws_every_figure_and_no_other(self):
        self.assertEqual((0, ""), (self.result.returncode, self.result.stderr))
        expected = {f"{name}.{kind}" for name in FIGURES for kind in ("svg", "png")}
        self.assertEqual(expected, {path.name for path in (self.out / "figures").iterdir()})

    def test_svgs_are_well_formed_and_say_what_they_show(self):
        for name, (words, _) in FIGURES.items():
            with self.subTest(name):
                text = (self.out / "figures" / f"{name}.svg").read_text()
                xml.fromstring(text)
                drawn = set(re.findall(r"<!-- (.*?) -->", text))
                self.assertEqual(set(), set(words) - drawn)
                self.assertTrue(any("seed 7" in words and "A Processor of No Maker" in words for words in drawn))

    def test_svgs_have_a_mark_for_each_number(self):
        for name, (_, lines) in FIGURES.items():
            groups = {group.get("id"): group for group in xml.parse(self.out / "figures" / f"{name}.svg").iter(f"{SVG}g")}
            for line, count in lines.items():
                with self.subTest(name, line=line):
                    self.assertEqual(count, len(list(groups[line].iter(f"{SVG}use"))))

    def test_pngs_are_drawn(self):
        for name in FIGURES:
            with self.subTest(name), Image.open(self.out / "figures" / f"{name}.png") as picture:
                self.assertEqual(1600, picture.width)
                self.assertGreaterEqual(picture.height, 900)
                pixels = picture.convert("RGB")
                self.assertGreater(len(pixels.getcolors(1 << 20)), 20)
                white = sum(count for count, color in pixels.getcolors(1 << 20) if color == (255, 255, 255))
                self.assertLess(0.5, white / (picture.width * picture.height))
                # Something stands in each quarter.
                for x in (0, 800):
                    for y in (0, picture.height // 2):
                        self.assertGreater(len(pixels.crop((x, y, x + 800, y + picture.height // 2)).getcolors(1 << 20)), 1)

    def test_the_same_numbers_give_the_same_bytes(self):
        second = report_files.measured_folder(Path(self.scratch.name) / "second")
        report_files.run("--draw-only", "--out", second)
        for path in sorted(self.out.rglob("*.*")):
            with self.subTest(path.name):
                self.assertEqual(path.read_bytes(), (second / path.relative_to(self.out)).read_bytes())


if __name__ == "__main__":
    unittest.main()
