"""`./poolhall hash-everywhere`: what agrees, what differs and what is missing is named, and the status says so.

usage: hash_everywhere_test.py BUILD-FOLDER
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import platforms
from hash_everywhere import first_difference, hashes_of
from sources import ROOT

COMMITTED = ROOT / "tests/golden/hashes.txt"


class HashEverywhereTest(unittest.TestCase):
    folder = Path()

    def run_it(self, *names, golden=COMMITTED, **environment):
        command = [sys.executable, "-B", str(ROOT / "tests/tooling/hash_everywhere.py"), str(self.folder), str(golden)]
        return subprocess.run([*command, *names], capture_output=True, text=True, env={**os.environ, **environment})

    def run_with_golden(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as golden:
            golden.write(text)
            golden.flush()
            return self.run_it("gcc-O0", golden=golden.name)

    def test_a_wrong_golden_hash_is_reported_by_its_corpus_and_status_1(self):
        lines = COMMITTED.read_text().splitlines()
        corpus, right = lines[-1].split()
        result = self.run_with_golden("\n".join([*lines[:-1], f"{corpus} {'0' * 16}"]))
        self.assertEqual((1, ""), (result.returncode, result.stderr))
        self.assertRegex(result.stdout, rf"(?m)^gcc-O0 .* s  {corpus}: {right}, committed is 0{{16}}$")
        self.assertIn("0 of 1 platforms agree", result.stdout)

    def test_the_right_hashes_are_ok_and_status_0_and_stay_to_be_compared(self):
        result = self.run_it("gcc-O0")
        self.assertEqual((0, ""), (result.returncode, result.stderr))
        self.assertRegex(result.stdout, r"(?m)^gcc-O0 .* s  ok$")
        self.assertEqual(COMMITTED.read_text(), (self.folder / "gcc-O0/hashes.txt").read_text())

    def test_a_missing_compiler_is_reported_by_its_package_and_status_1(self):
        with tempfile.TemporaryDirectory() as empty:
            result = self.run_it(PATH=empty)
        self.assertEqual((1, ""), (result.returncode, result.stderr))
        for platform in platforms.PLATFORMS:
            self.assertRegex(result.stdout, rf"(?m)^{platform.name} .* missing: apt-get install .+$")
        self.assertRegex(result.stdout, r"(?m)^aarch64-gcc-O2 .* g\+\+-aarch64-linux-gnu qemu-user$")

    def test_wrong_arguments_and_golden_files_are_one_line_and_status_2(self):
        for result in (self.run_it("z80"), self.run_it(golden="/nowhere/hashes.txt"), self.run_with_golden(""),
                       self.run_with_golden("corpus 12"), self.run_with_golden(f"a {'0' * 16}\na {'0' * 16}\n")):
            with self.subTest(result.stderr):
                self.assertEqual((2, "", 1), (result.returncode, result.stdout, result.stderr.count("\n")))
                self.assertRegex(result.stderr, "^hash-everywhere: ")

    def test_a_corpus_that_only_one_side_has_is_a_difference(self):
        one, two = hashes_of(f"a {'1' * 16}\n", "one"), hashes_of(f"a {'1' * 16}\nb {'2' * 16}\n", "two")
        self.assertIsNone(first_difference(one, one))
        self.assertEqual(f"b: none, committed is {'2' * 16}", first_difference(two, one))
        self.assertEqual(f"b: {'2' * 16}, committed is none", first_difference(one, two))


if __name__ == "__main__":
    HashEverywhereTest.folder = Path(sys.argv.pop())
    unittest.main()
