"""One hash for one scene by every native compiler and optimisation level; and no C mathematics but sqrt.

usage: determinism_test.py LIBPOOLHALL_SHARED BUILD-FOLDER
"""

import sys
import unittest
from pathlib import Path

import symbols
from platforms import GCC, NATIVE, Platform, build, has_fma, output_of
from sources import ROOT

COMMITTED = ROOT / "tests/golden/hashes.txt"


class DeterminismTest(unittest.TestCase):
    library = ""
    folder = Path()

    def test_the_built_library_calls_no_mathematical_function_but_sqrt(self):
        self.assertEqual([], symbols.forbidden([self.library]))

    def test_every_native_platform_gives_the_committed_hashes_and_calls_no_mathematical_function(self):
        for platform in NATIVE:
            with self.subTest(platform.name):
                program, simulation = build(platform, self.folder / platform.name)
                self.assertEqual([], symbols.forbidden(simulation))
                if platform.fma and not has_fma():
                    print(f"{platform.name}: built, not run: this processor has no FMA")
                    continue
                actual = output_of(platform, program)
                self.assertTrue(actual, f"{platform.name} printed no hash")
                self.assertEqual(COMMITTED.read_text(), actual, f"{platform.name} printed\n{actual}")

    @unittest.skipUnless(has_fma(), "needs a processor with FMA")
    def test_contraction_would_change_the_hashes(self):
        """So the builds with FMA above prove something."""
        contracted = Platform("contracted", GCC, "g++ -O3 -march=haswell -ffp-contract=fast")
        program, _ = build(contracted, self.folder / contracted.name)
        self.assertNotEqual(COMMITTED.read_text(), output_of(contracted, program))


if __name__ == "__main__":
    DeterminismTest.folder = Path(sys.argv.pop())
    DeterminismTest.library = sys.argv.pop()
    unittest.main()
