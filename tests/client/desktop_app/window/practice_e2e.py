#!/usr/bin/env python3
"""Every key of the table and the mouse, in the real window, in practice mode."""

import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import desk
from desk import CUE_BALL_COLUMN, EIGHT_BALL_BOX, LOWER_LEFT, START, TABLE, Client, is_cue_ball, is_yellow, wait_for

PROGRAM = os.environ.get("POOLHALL_CLIENT", "poolhall-client")
ARROW = (425, 268, 515, 468)


def cue_ball(picture):
    return picture.centre(is_cue_ball, CUE_BALL_COLUMN)


def is_arrow(r, g, b):
    return r > 220 and g > 200 and b > 150


def is_sky_blue(r, g, b):
    return r < 140 and 140 < g < 210 and b > 190


def is_orange(r, g, b):
    return r > 190 and 120 < g < 190 and b < 60


class NoFonts(unittest.TestCase):
    def test_a_machine_without_fonts_is_told_so(self):
        with tempfile.NamedTemporaryFile("w", suffix=".conf") as fonts:
            fonts.write('<!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig><dir>/nowhere</dir></fontconfig>')
            fonts.flush()
            result = subprocess.run([PROGRAM, "--practice"], env=dict(os.environ, FONTCONFIG_FILE=fonts.name),
                                    capture_output=True, text=True, timeout=desk.PATIENCE)
        self.assertEqual(result.returncode, 1)
        self.assertIn("no font: fontconfig finds none", result.stderr)


class Practice(unittest.TestCase):
    def setUp(self):
        self.client = Client(PROGRAM, "--practice", "--name", "Anna", title="Poolhall practice")
        self.addCleanup(self.client.close)

    def assert_near(self, actual, wanted, within):
        for a, w in zip(actual, wanted):
            self.assertLessEqual(abs(a - w), within, f"{actual} is not near {wanted}")

    def arrow(self):
        return self.client.look().centre(is_arrow, ARROW)

    def test_p_saves_numbered_pictures_of_the_window(self):
        first = self.client.look()
        self.assertEqual((first.format, first.width, first.height), ("PNG", 1280, 720))
        self.assertEqual(first.path.name, "poolhall-001.png")
        self.assert_near(cue_ball(first), START, 3)
        second = self.client.look()
        self.assertEqual(second.path.name, "poolhall-002.png")
        self.assertGreater(second.difference(first, (0, 690, 640, 720)), 50, "its name is not shown")

    def test_up_and_down_move_the_cue_ball_until_the_rails(self):
        self.client.hold("Up", 0.5)
        raised = cue_ball(self.client.look())
        self.assertLess(raised[1], START[1] - 30)
        self.client.hold("Down", 0.3)
        self.assertGreater(cue_ball(self.client.look())[1], raised[1] + 10)
        self.client.hold("Down", 4)
        self.assert_near(cue_ball(self.client.look()), (START[0], 565), 5)

    def test_arrows_and_page_keys_turn_the_aim(self):
        level = self.arrow()[1]
        for key, seconds, higher in (("Left", 1, True), ("Right", 2, False), ("Prior", 0.5, True), ("Next", 0.8, False)):
            before = self.arrow()[1]
            self.client.hold(key, seconds)
            after = self.arrow()[1]
            self.assertTrue(after < before - 0.5 if higher else after > before + 0.5, f"{key}: {before} to {after}")
        self.assertGreater(self.arrow()[1], level)

    def test_space_fires(self):
        self.client.hold("Prior", 0.4)
        self.client.key("space")
        time.sleep(0.5)
        moving = self.client.look()
        self.assertEqual(moving.find(is_cue_ball, CUE_BALL_COLUMN), [])
        self.assertNotEqual(moving.find(is_cue_ball, TABLE), [])

    def test_f1_shows_help_and_hides_it(self):
        plain = self.client.look()
        self.client.key("F1")
        time.sleep(0.4)
        self.assertGreater(self.client.look().difference(plain, (400, 200, 900, 500)), 2000)
        self.client.key("F1")
        time.sleep(0.4)
        self.assertLess(self.client.look().difference(plain, (400, 200, 900, 500)), 50)

    def test_f2_shows_the_frame_rate_and_hides_it(self):
        plain = self.client.look()
        edge = (0, 70, 1280, 100)
        below = (640, 690, 1190, 720)
        self.client.key("F2")
        time.sleep(0.4)
        shown = self.client.look()
        self.assertGreater(shown.difference(plain, edge) + shown.difference(plain, below), 20)
        self.client.key("F2")
        time.sleep(0.4)
        hidden = self.client.look()
        self.assertEqual(hidden.difference(plain, edge) + hidden.difference(plain, below), 0)

    def test_f2_at_rest_draws_nothing_new(self):
        self.client.key("F2")
        time.sleep(1)
        before = self.client.cpu_seconds()
        time.sleep(3)
        self.assertLess(self.client.cpu_seconds() - before, 0.3)

    def test_f3_and_f4_are_two_toggles_with_icons(self):
        plain = self.client.look()
        self.client.key("F3")
        time.sleep(0.3)
        step = self.client.look()
        self.assertGreater(step.difference(plain, (96, 580, 400, 690)), 30)
        self.client.key("F4")
        time.sleep(0.3)
        both = self.client.look()
        self.assertGreater(both.difference(step, (96, 580, 400, 690)), 30)
        self.client.key("F3")
        self.client.key("F4")
        time.sleep(0.3)
        self.assertEqual(self.client.look().difference(plain, (96, 580, 280, 690)), 0)

    def test_step_mode_moves_by_a_thirtieth_and_leaves_rings(self):
        self.client.key("F3")
        self.client.key("space")
        time.sleep(0.5)
        fired = self.client.look()
        self.assert_near(cue_ball(fired), START, 3)
        self.client.key("space")
        time.sleep(0.3)
        stepped = self.client.look()
        # 2.679 m/s for 1/30 s on a table where 1.55 m are about 932 px.
        ball = stepped.centre(is_cue_ball, (440, 340, 480, 396))
        self.assert_near(ball, (START[0] + 53.7, START[1]), 3)
        self.assertGreater(stepped.difference(fired, CUE_BALL_COLUMN), 100)
        time.sleep(0.7)
        self.assertEqual(self.client.look().difference(stepped, (390, 300, 700, 440)), 0, "time did not stand still")
        self.client.key("F3")
        time.sleep(0.5)
        self.assertEqual(self.client.look().find(is_cue_ball, (440, 340, 480, 396)), [])

    def test_collision_mode_marks_the_times_of_impact(self):
        self.client.key("F4")
        self.client.key("space")
        time.sleep(1.5)
        marked = self.client.look()
        self.assertGreater(len(marked.find(is_yellow, (820, 345, 900, 391))), 40, "no circles where the balls met")
        self.client.key("F4")
        time.sleep(0.3)
        self.assertEqual(self.client.look().find(is_yellow, (820, 345, 900, 391)), [])

    def test_f5_shows_the_last_shot_by_other_solvers(self):
        self.client.key("F5")
        time.sleep(0.3)
        self.assertEqual(self.client.look().find(is_sky_blue, TABLE), [], "there is no shot yet")
        self.client.key("F3")
        self.client.key("space")
        for step in range(3):
            self.client.key("space")
        wait_for("the paths", lambda: len(self.client.look().find(is_sky_blue, TABLE)) > 500)
        first = self.client.look()
        self.assertGreater(len(first.find(is_orange, TABLE)), 100)
        self.client.key("space")
        time.sleep(0.3)
        self.assertGreater(self.client.look().difference(first, TABLE), 100, "their balls did not step along")
        self.client.key("F5")
        time.sleep(0.3)
        second = self.client.look()
        self.assertGreater(second.difference(first, TABLE), 200, "the same solvers")
        for press in range(2):
            self.client.key("F5")
        time.sleep(0.3)
        self.assertEqual(self.client.look().find(is_sky_blue, TABLE), [], "not switched off")

    def test_m_h_and_c_answer_on_the_screen(self):
        status = (0, 690, 640, 720)
        before = self.client.look()
        time.sleep(4.5)
        for key in ("h", "c"):
            self.client.key(key)
            time.sleep(0.4)
            self.assertGreater(self.client.look().difference(before, status), 50, key)
            time.sleep(4.5)
        plain = self.client.look()
        self.client.key("m")
        time.sleep(4.5)
        everywhere_below = (640, 590, 1280, 720)
        self.assertGreater(self.client.look().difference(plain, everywhere_below), 10, "muted is not shown")

    def test_mouse_aims_drags_and_shoots(self):
        self.client.focus()
        self.client.move_mouse(700, 200)
        self.assertLess(self.arrow()[1], START[1] - 10)
        self.client.move_mouse(*START)
        self.client.press_mouse(down=True)
        self.client.move_mouse(450, 250)
        self.client.press_mouse(down=False)
        self.assert_near(cue_ball(self.client.look()), (START[0], 250), 4)
        self.client.move_mouse(800, 250)
        self.client.click()
        time.sleep(0.4)
        self.assertEqual(self.client.look().find(is_cue_ball, CUE_BALL_COLUMN), [])

    def test_letters_count_by_place_on_layouts_that_have_none(self):
        codes = {"p": "33", "m": "58"}  # of their keys, whatever is printed on them
        self.addCleanup(subprocess.run, ["setxkbmap", "us"], check=True)
        for layout in ("ru", "gr", "ara", "il"):
            plain = self.client.look()
            subprocess.run(["setxkbmap", layout], check=True)
            time.sleep(0.5)
            before = set(self.client.shots.glob("*.png"))
            self.client.key(codes["m"])
            time.sleep(0.5)
            self.client.key(codes["p"])
            new = wait_for("a screenshot", lambda: set(self.client.shots.glob("*.png")) - before)
            self.assertGreater(desk.Picture(new.pop()).difference(plain, (1100, 690, 1280, 720)), 10, layout)
            subprocess.run(["setxkbmap", "us"], check=True)

    def test_game_that_is_over_starts_anew_by_itself(self):
        self.sink_the_cue_ball()
        over = self.client.look()
        wait_for("the new game", lambda: self.is_new_game(self.client.look()))
        self.assertGreater(self.client.look().difference(over, (300, 250, 980, 480)), 1000, "nothing said of the end")

    def test_space_starts_the_new_game_at_once(self):
        self.sink_the_cue_ball()
        self.client.key("space")
        time.sleep(0.5)
        self.assertTrue(self.is_new_game(self.client.look()))

    def sink_the_cue_ball(self):
        """From the middle of the base line straight into the corner at the upper left."""
        self.client.focus()
        self.client.move_mouse(172, 148)
        self.client.click()
        time.sleep(0.8)

    def is_new_game(self, picture):
        try:
            ball = cue_ball(picture)
        except AssertionError:
            return False
        return abs(ball[0] - START[0]) < 3 and abs(ball[1] - START[1]) < 3

    def test_any_size_of_the_window_shows_the_whole_table(self):
        for width, height in ((640, 400), (1000, 860)):
            self.client.resize(width, height)
            picture = self.client.look()
            self.assertEqual((picture.width, picture.height), (width, height))
            whole = (0, 0, width, height)
            self.assertNotEqual(picture.find(is_cue_ball, whole), [])

    def test_idle_window_costs_almost_nothing(self):
        time.sleep(1)
        before = self.client.cpu_seconds()
        time.sleep(4)
        self.assertLess(self.client.cpu_seconds() - before, 0.2)

    def test_escape_leaves(self):
        self.client.key("Escape")
        self.assertEqual(self.client.process.wait(desk.PATIENCE), 0)
        self.assertEqual(self.client.error_text(), "")

    def test_ctrl_c_and_sigterm_leave_cleanly(self):
        self.assertEqual(self.client.end(signal.SIGINT), 0)
        second = Client(PROGRAM, "--practice")
        self.addCleanup(second.close)
        self.assertEqual(second.end(signal.SIGTERM), 0)


class Refusals(unittest.TestCase):
    def run_client(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *arguments], env=dict(os.environ, **environment), capture_output=True,
                              text=True, timeout=desk.PATIENCE)

    def test_wrong_command_line_is_one_line_and_status_2(self):
        for arguments in (["--nonsense"], ["--match", "xyz"], ["--server", "ftp://x"], ["--watch"]):
            ended = self.run_client(*arguments)
            self.assertEqual(ended.returncode, 2)
            self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)

    def test_no_display_is_one_line_and_status_1(self):
        ended = self.run_client("--practice", DISPLAY=":7777", SDL_VIDEODRIVER="x11", SDL_AUDIODRIVER="dummy")
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)

    def test_unwritable_folder_costs_the_screenshot_only(self):
        client = Client(PROGRAM, "--practice", "--screenshots", "/proc/nowhere")
        self.addCleanup(client.close)
        client.key("p")
        time.sleep(0.5)
        self.assertIsNone(client.process.poll())
        client.key("Escape")
        self.assertEqual(client.process.wait(desk.PATIENCE), 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])
