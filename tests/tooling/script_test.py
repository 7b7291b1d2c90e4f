"""The task script: its messages, its help, and that it works from anywhere."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from platforms import PLATFORMS
from sources import ROOT

SCRIPT = ROOT / "poolhall"


def run(*arguments, script=SCRIPT, **options):
    return subprocess.run([str(script), *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, **options)


class ScriptTest(unittest.TestCase):
    def test_an_unknown_task_is_one_line_and_status_2(self):
        result = run("shoot")
        self.assertEqual((2, ""), (result.returncode, result.stdout))
        self.assertEqual("poolhall: unknown task 'shoot'; ./poolhall help lists them\n", result.stderr)

    def test_wrong_arguments_are_one_line_and_status_2(self):
        for arguments in (["join"], ["watch", "ws://127.0.0.1:1"], ["build", "no-preset"], ["setup", "all"], ["fuzz", "x"],
                          ["test", "--preset"]):
            with self.subTest(arguments):
                result = run(*arguments)
                self.assertEqual((2, 1), (result.returncode, result.stderr.count("\n")), result.stderr)

    def test_help_lists_every_task(self):
        dispatch = SCRIPT.read_text().rsplit("case $task in", 1)[1]
        tasks = {name for names in re.findall(r"^ +([a-z][a-z |-]*)\)", dispatch, re.MULTILINE) for name in names.split(" | ")}
        listed = set(re.findall(r"^  ([a-z-]+)\b", run("help").stdout, re.MULTILINE))
        self.assertGreater(len(tasks), 10)
        self.assertEqual(tasks, tasks & listed)

    def test_it_works_from_another_folder_through_a_link_and_with_spaces_in_its_path(self):
        with tempfile.TemporaryDirectory() as folder:
            checkout = Path(folder) / "a check out"
            (checkout / "build" / "dev").mkdir(parents=True)
            shutil.copy(SCRIPT, checkout)
            link = Path(folder) / "linked"
            link.symlink_to(checkout / "poolhall")
            self.assertEqual(0, run("clean", script=link, cwd="/").returncode)
            self.assertFalse((checkout / "build").exists())

    def setup_without_apt(self, profile):
        with tempfile.TemporaryDirectory() as folder:
            for tool in ("bash", "readlink", "dirname", "nproc", "sed", "cat", "xargs", "echo"):
                os.symlink(shutil.which(tool), f"{folder}/{tool}")
            result = run("setup", profile, env={"PATH": folder})
        self.assertEqual(1, result.returncode)
        return result.stderr

    def test_without_apt_setup_lists_what_is_needed(self):
        message = self.setup_without_apt("play")
        for package in ("apt", "g++", "libsdl2-dev"):
            self.assertIn(package, message)
        self.assertNotIn("libgtest-dev", message)

    def test_setup_everywhere_has_all_that_the_platforms_need(self):
        listed = set(self.setup_without_apt("everywhere").split())
        needed = {package for platform in PLATFORMS for package in platform.needs.values()}
        self.assertEqual(set(), needed - listed)

    @unittest.skipUnless(shutil.which("shellcheck"), "needs shellcheck")
    def test_shellcheck_finds_nothing(self):
        scripts = [SCRIPT, ROOT / ".ci/run", *(ROOT / "tests").rglob("*.sh")]
        result = subprocess.run(["shellcheck", *map(str, scripts)], capture_output=True, text=True)
        self.assertEqual("", result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
