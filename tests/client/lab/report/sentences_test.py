"""Numbers are said as people say them, and the report's sentences follow the numbers."""

import copy
import json
import unittest

import report_files
import document
import findings
import numbers_in_words as say
import results
import tables
import words

ACCURACY = results.read_accuracy(report_files.HERE / "accuracy.json")
EFFECTS = results.read_effects(report_files.HERE / "effects.json")
ONE_BALL, TWO_BALLS = ACCURACY["ensembles"]


def labels(points):
    return [point["label"] for point in points]


class NumbersTest(unittest.TestCase):
    def test_lengths_have_the_unit_that_people_use(self):
        for metres, said in ((0, "0 m"), (1.234, "1.23 m"), (0.2, "20.0 cm"), (9.996e-3, "1.00 cm"), (9.96e-3, "9.96 mm"),
                             (2e-3, "2.00 mm"), (1e-6, "1.00 µm"), (5e-10, "500 pm"), (3e-15, "3.00 fm"),
                             (2.5e-16, "2.5 × 10⁻¹⁶ m"), (2e4, "2.0 × 10⁴ m"), (None, "–")):
            with self.subTest(metres):
                self.assertEqual(said, say.metres(metres))

    def test_a_single_digit_is_enough_for_an_axis(self):
        self.assertEqual(["100 µm", "1 mm", "1 cm", "10 cm", "1 m", "10⁻¹⁶ m"],
                         [say.metres(value, 1) for value in (1e-4, 1e-3, 1e-2, 1e-1, 1, 1e-16)])
        self.assertEqual(["100 ns", "1 µs", "10 ms"], [say.time_of_ns(ns, 1) for ns in (1e2, 1e3, 1e7)])

    def test_shares_ratios_and_lists(self):
        self.assertEqual(["0 %", "0.10 %", "12.5 %", "100 %", "–"], [say.percent(share) for share in (0, 0.001, 0.125, 1, None)])
        self.assertNotEqual("100 %", say.percent(0.9999))
        self.assertEqual(["0.85", "12", "1.2 million", "10 billion", "10¹⁴"], [say.times(x) for x in (0.85, 12, 1.2e6, 1e10, 1e14)])
        self.assertEqual(["a", "a and b", "a, b and c", ""], [say.listed(x) for x in ("a", "ab", "abc", "")])
        self.assertEqual(["48 s", "15 min 12 s"], [say.duration(x) for x in (47.6, 912)])


class FindingsTest(unittest.TestCase):
    def test_the_pareto_front_is_known(self):
        self.assertEqual(["overlap:30", "euler:30", "exact_arc:30", "event"], labels(findings.pareto_front(TWO_BALLS)))
        self.assertEqual(["event"], labels(findings.pareto_front(ONE_BALL)))

    def test_of_equal_errors_the_cheaper_is_on_the_front(self):
        self.assertEqual(["event"], labels(findings.pareto_front({"points": [
            point for point in ONE_BALL["points"] if point["label"] in ("exact_arc:30", "event")]})))

    def test_the_price_of_a_tenth_of_the_error(self):
        groups = findings.stepping(TWO_BALLS)
        factor, first, last = findings.tenfold(groups["euler"])  # 100 times as exact for four times the time
        self.assertEqual((30, 480), (first, last))
        self.assertAlmostEqual(2, factor)
        self.assertIsNone(findings.tenfold(groups["overlap"]))
        self.assertIsNone(findings.tenfold(findings.stepping(ONE_BALL)["exact_arc"]))  # no error to divide

    def test_the_cheapest_way_to_an_accuracy(self):
        self.assertEqual("euler:120", findings.cheapest_within(findings.stepping(TWO_BALLS)["euler"], 1e-3)["label"])
        self.assertEqual("exact_arc:30", findings.cheapest_within(TWO_BALLS["points"], 1e-3)["label"])
        self.assertIsNone(findings.cheapest_within(findings.stepping(TWO_BALLS)["overlap"], 1e-3))

    def test_the_rate_from_which_verdicts_hold(self):
        groups = findings.stepping(TWO_BALLS)
        self.assertEqual([120, 30, None], [findings.rate_of_few_flips(groups[solver]) for solver in ("euler", "exact_arc", "overlap")])


class WordsTest(unittest.TestCase):
    def test_the_front_in_words(self):
        self.assertEqual("on the front, from cheap to exact: `overlap` at 30 Hz, `euler` at 30 Hz, `exact_arc` at 30 Hz and `event`.",
                         words.front_of(TWO_BALLS))
        self.assertEqual("`event` is both the cheapest and the most exact; nothing else is on the front.", words.front_of(ONE_BALL))

    def test_event_beside_euler(self):
        self.assertEqual("`event` takes 1.5 times the time of `euler:30` (15.0 µs against 10.0 µs) and is 10 billion times as exact "
                         "(200 fm against 2.00 mm).", words.event_beside_euler(TWO_BALLS))
        self.assertEqual("`event` takes 30.0 % of the time of `euler:30` (900 ns against 3.00 µs) and is without error "
                         "(0 m against 500 µm).", words.event_beside_euler(ONE_BALL))

    def test_where_euler_is_enough_follows_the_numbers(self):
        self.assertEqual("Good enough (a median rest error under 1 mm and under 1 % of verdicts flipped): One ball. "
                         "Not good enough: Two balls (2.00 mm, 3.0 % flipped).", words.where_euler_is_enough(ACCURACY["ensembles"]))
        worse = copy.deepcopy(ACCURACY)
        results.point_of(worse["ensembles"][0], "euler:30")["rest_error"]["median"] = 1e-3
        self.assertIn("in no ensemble.", words.where_euler_is_enough(worse["ensembles"]))

    def test_who_wins(self):
        self.assertEqual("`euler:30` changes who wins: Two balls: in 1.0 % of 500 shots.", words.who_wins(ACCURACY["ensembles"]))
        self.assertEqual("No ensemble here has a winner to change.", words.who_wins([ONE_BALL]))

    def test_effects_in_words(self):
        self.assertEqual("The dearest effect is rail mathavan2010: a shot of two balls takes 9.0 times as long with it as without. "
                         "Most is lost without sliding: in the median shot of two balls a ball rests 30.0 cm away, and 25.0 % of the "
                         "verdicts change. An effect that a scene names at zero is paid for all the same: up to 1.4 times the time "
                         "(sliding), for the same shot.", words.effects_in_words(EFFECTS["effects"]))

    def test_instructions_say_more_exactly_what_an_idle_effect_costs(self):
        effects = json.loads(json.dumps(EFFECTS["effects"]))
        for effect, zero in zip(effects, (100_400, None, 100_000)):
            effect["absent"]["instructions_per_shot"] = effect["present"]["instructions_per_shot"] = 100_000
            if zero:
                effect["zero"]["instructions_per_shot"] = zero
        self.assertTrue(words.effects_in_words(effects).endswith(
            "takes at most 0.40 % more instructions than one that it leaves out (sliding), for the same shot."))
        self.assertIn("takes 1.0 times as many instructions with it as without", words.effects_in_words(effects))
        effects[0]["zero"]["instructions_per_shot"] = 100_000
        self.assertTrue(words.effects_in_words(effects).endswith("takes no more instructions than one that it leaves out."))
        self.assertIn("| sliding | two balls | 100,000 | 100,000 | 100,000 | 1.00 | – | – | – |",
                      tables.instructions_table({"effects": effects}))
        self.assertIsNone(tables.instructions_table(EFFECTS))

    def test_orders_that_theory_does_not_expect_are_named_with_their_reason(self):
        self.assertEqual(["Two balls, `euler`, rest error: 1.66 where 1 is expected: steps of 4 between rates",
                          "No order could be fitted of rest error: closed form in every tick: no error to fall. "
                          "One ball (`exact_arc`)"],
                         words.orders_missed(ACCURACY))


class DocumentTest(unittest.TestCase):
    def test_tables_say_what_was_measured(self):
        self.assertIn("| Two balls | `euler` | 3.0 % | 0.40 % | 0 % | – | 0 % | 120 Hz |", tables.flips_table(ACCURACY["ensembles"]))
        self.assertIn("| `exact_arc` | 12.0 µs (30 Hz) | 12.0 µs (30 Hz) | – | – |", tables.bounds_table(TWO_BALLS))
        self.assertIn("| Two balls | `exact_arc` | 1.99 (1.94 to 2.04) | 2 |", tables.orders_table(ACCURACY["ensembles"]))
        self.assertIn("| rail mathavan2010 | two balls | 10.0 µs | – | 90.0 µs | 9.00 | 2.00 cm | 8.00 cm | 4.0 % |",
                      tables.effects_table(EFFECTS))
        self.assertIn("| `slide_roll` | two balls | 10.5 ns | 120 | 400 ns | 15.0 µs | 108,500 | 43.0 µs |",
                      tables.kernels_table(EFFECTS))

    def test_a_column_that_nobody_has_is_left_out(self):
        self.assertIn("winners flipped", tables.main_table(TWO_BALLS))
        self.assertNotIn("winners flipped", tables.main_table(ONE_BALL))

    def test_what_is_missing_is_said(self):
        bare = json.loads(json.dumps({**ACCURACY, "tunnelling": [], "crowds": [], "quick": True, "complete": False}))
        for ensemble in bare["ensembles"]:
            ensemble["orders"], ensemble["error_in_time"] = [], []
        page = document.markdown(bare, None, None, False)
        for said in ("**A quick run**", "**The run was interrupted**", "No order was fitted", "what each effect costs and is worth is left out",
                     "## Tunnelling\n\nNot measured", "## Many balls\n\nNot measured", "No picture of one shot"):
            with self.subTest(said):
                self.assertIn(said, page)
        for name in ("tunnelling", "crowds", "effects", "error_in_time", "compare"):
            self.assertNotIn(f"figures/{name}.", page)

    def test_a_run_of_nothing_makes_a_page(self):
        page = document.markdown({**ACCURACY, "ensembles": [], "tunnelling": [], "crowds": []}, None, None, False)
        self.assertTrue(page.startswith("# What accuracy costs in time\n"))


if __name__ == "__main__":
    unittest.main()
