"""What the report says of the engine against measurements follows from the numbers."""

import json
import tempfile
import unittest
from pathlib import Path

import report_files
import document
import measurements
from numbers_in_words import time_of_ns
from results import BadResults, read_accuracy, read_validate

VALIDATE = read_validate(report_files.HERE / "validate.json")
ACCURACY = read_accuracy(report_files.HERE / "accuracy.json")


class MeasurementsTest(unittest.TestCase):
    def test_the_best_model_is_judged_without_outliers(self):
        self.assertEqual((0.02, "friction"), measurements.best_rms(VALIDATE["tables"][0]))

    def test_what_is_reached_and_what_is_not_is_said_with_the_reason(self):
        two_balls, lag = measurements.reached(VALIDATE)
        self.assertEqual("Two balls: 2.0 % rms with friction; aim 2.5 %, reached. Shot 1 is an outlier.", two_balls)
        self.assertEqual("Lag: 0.5 s rms with cloth; aim 0.1 s, not reached. The cloth is slow.", lag)

    def test_speeds_and_angles_must_be_reached_by_one_model(self):
        self.assertIsNone(measurements.both_at_once(VALIDATE))
        angles = {**VALIDATE["tables"][0], "name": "two_balls_angle", "unit": "deg", "relative": False, "reach": 1,
                  "rms": [2, 3], "rms_without_outliers": [0.5, 1.5]}
        said = measurements.both_at_once({**VALIDATE, "tables": [VALIDATE["tables"][0], angles]})
        self.assertEqual("Two balls, speeds and angles by one model: friction comes nearest; no one model reaches both aims, with 2.0 % "
                         "and 1.500 deg.", said)

    def test_tables_have_value_error_and_rms_by_model(self):
        table = measurements.markdown_table(VALIDATE["tables"][0])
        self.assertIn("| shot 1 * | 0.800 | 0.900 (+12.5 %) | 0.880 (+10.0 %) |", table)
        self.assertIn("| **rms error** |  | 11.3 %; 10.0 % without * | 7.2 %; 2.0 % without * |", table)
        self.assertIn("| 2.54 m | 7.0 to 9.0 | 6.5 (-0.5) |", measurements.markdown_table(VALIDATE["tables"][1]))

    def test_recorded_shots_are_told_by_those_that_were_not_fitted(self):
        self.assertIn("within 6.00 cm (all balls, whole shot, median) and 2.60 cm", measurements.recorded_words(VALIDATE))
        self.assertIn("2 even, constants fitted to the odd", measurements.recorded_table(VALIDATE))

    def test_the_page_says_what_nobody_has_measured(self):
        page = measurements.page(VALIDATE)
        for said in ("drop edge", "massé", "Source: M09", "| rail |", "poolhall-lab validate --recorded FILE --out DIR"):
            self.assertIn(said, page)

    def test_a_solver_is_enough_from_where_its_error_is_below_that_of_the_places(self):
        for ensemble in ACCURACY["ensembles"]:
            if ensemble["name"] != "two_balls":
                continue
            for _, point in measurements.enough(ensemble, VALIDATE["unknowns"][0]):
                self.assertTrue(point is None or point["rest_error"]["median"] <= 0.003)

    def test_horizons_are_told_by_input_error(self):
        (line,) = measurements.horizons_words(VALIDATE)
        self.assertIn("2.50 s at 1 µm and 0.40 s at 1 mm", line)

    def test_the_report_has_the_section_or_says_that_it_was_not_measured(self):
        self.assertIn("## Against measured billiards", document.markdown(ACCURACY, None, VALIDATE, False))
        self.assertIn("Not measured in this run", measurements.section(None))
        self.assertEqual("", measurements.unknown_section(ACCURACY, None, time_of_ns))

    def test_uneven_results_are_one_line_with_the_place(self):
        broken = json.loads(json.dumps(VALIDATE))
        broken["tables"][1]["rows"][0]["ours"] = []
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "validate.json"
            path.write_text(json.dumps(broken))
            with self.assertRaisesRegex(BadResults, "/tables/1/rows/0: models, ours, errors are not equally long"):
                read_validate(path)


if __name__ == "__main__":
    unittest.main()
