"""One hash for one scene on every compiler, optimisation level and processor; and no C mathematics but sqrt.

usage: determinism_test.py LIBPOOLHALL_SHARED BUILD-FOLDER
"""

import os
import shutil
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import symbols
from sources import ROOT, files

# Without FMA every build agrees even if contraction is left on, so the haswell builds are the ones that prove it.
FLAVOURS = {
    "gcc-O0": ["g++", "-O0"],
    "gcc-O2": ["g++", "-O2"],
    "gcc-O3-fma": ["g++", "-O3", "-march=haswell"],
    "clang-O2": ["clang++", "-O2"],
    "clang-O2-fma": ["clang++", "-O2", "-march=haswell"],
}
COMMON = ["-std=c++20", "-ffp-contract=off", "-I", str(ROOT), "-c"]
PROGRAM = ROOT / "tests/shared/golden_hashes.cpp"
COMMITTED = ROOT / "tests/golden/hashes.txt"


def has_fma():
    return "fma" in Path("/proc/cpuinfo").read_text().split()


def build(compiler, folder):
    """Compiles the simulation and the golden program; returns the program and the simulation's objects."""
    command = [*filter(None, [shutil.which("ccache")]), compiler[0], *COMMON, *compiler[1:]]
    folder.mkdir(parents=True, exist_ok=True)

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        subprocess.run([*command, str(source), "-o", str(target)], check=True)
        return str(target)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        golden, *simulation = pool.map(compile_one, [PROGRAM, *files(ROOT, ["shared"], {".cpp"})])
    program = folder / "golden_hashes"
    subprocess.run([compiler[0], golden, *simulation, "-o", str(program)], check=True)
    return program, simulation


def output_of(program):
    return subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout


class DeterminismTest(unittest.TestCase):
    library = ""
    folder = Path()

    def test_the_built_library_calls_no_mathematical_function_but_sqrt(self):
        self.assertEqual([], symbols.forbidden([self.library]))

    def test_every_flavour_gives_the_committed_hashes_and_calls_no_mathematical_function(self):
        for flavour, compiler in FLAVOURS.items():
            with self.subTest(flavour):
                program, simulation = build(compiler, self.folder / flavour)
                self.assertEqual([], symbols.forbidden(simulation))
                if "-march=haswell" in compiler and not has_fma():
                    print(f"{flavour}: built, not run: this processor has no FMA")
                    continue
                actual = output_of(program)
                self.assertTrue(actual, f"{flavour} printed no hash")
                self.assertEqual(COMMITTED.read_text(), actual, f"{flavour} printed\n{actual}")

    @unittest.skipUnless(has_fma(), "needs a processor with FMA")
    def test_contraction_would_change_the_hashes(self):
        """So the builds with FMA above prove something."""
        compiler = [*FLAVOURS["gcc-O3-fma"], "-ffp-contract=fast"]
        program, _ = build(compiler, self.folder / "contracted")
        self.assertNotEqual(COMMITTED.read_text(), output_of(program))


if __name__ == "__main__":
    DeterminismTest.folder = Path(sys.argv.pop())
    DeterminismTest.library = sys.argv.pop()
    unittest.main()
