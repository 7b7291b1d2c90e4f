"""What a browser shares with the desktop, client/play with what it stands on, compiles and links for WebAssembly.

usage: wasm_test.py NLOHMANN_JSON_INCLUDE_FOLDER BUILD_FOLDER

No exceptions, as there are none in WebAssembly's C++ library; no window, thread, socket or file that it does not have.
"""

import os
import re
import shutil
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from platforms import CLANG, WASM, Platform
from sources import ROOT

FOLDERS = ("client/play", "protocol", "shared")
COMPILER = ["clang++", "--target=wasm32-wasi", "-std=c++20", "-O0", "-fno-exceptions", "-DJSON_NOEXCEPTION",
            "-DJSON_HAS_FILESYSTEM=0", "-DJSON_HAS_EXPERIMENTAL_FILESYSTEM=0"]
NEEDS = {need: package for need, package in (CLANG | WASM).items() if need != "node"}


def sources():
    """The .cpp files that the CMakeLists.txt of each folder names."""
    for folder in FOLDERS:
        text = re.sub(r"#.*", "", (ROOT / folder / "CMakeLists.txt").read_text())
        yield from (ROOT / folder / name for name in re.findall(r"[\w/]+\.cpp", text))


class WasmTest(unittest.TestCase):
    json = build = None

    def object_of(self, source):
        return self.build / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")

    def errors_of(self, command):
        """What the compiler says of the command if it fails; else nothing."""
        run = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        return f"{run.stderr[:2000]}\n" if run.returncode else ""

    def compile(self, source):
        ccache = [*filter(None, [shutil.which("ccache")])]
        return self.errors_of([*ccache, *COMPILER, "-I", ROOT, "-isystem", self.build, "-c", source,
                               "-o", self.object_of(source)])

    def test_what_a_browser_needs_compiles_and_links(self):
        missing = Platform("wasm32", NEEDS, "").missing_packages()
        self.assertFalse(missing, f"the compiler for WebAssembly is not whole: apt-get install {' '.join(missing)}")
        self.build.mkdir(parents=True, exist_ok=True)
        # Only this library of the host's headers may be seen.
        header = self.build / "nlohmann"
        header.unlink(missing_ok=True)
        header.symlink_to(self.json / "nlohmann")
        all_sources = [*sources()]
        for folder in FOLDERS:
            self.assertTrue(any(source.is_relative_to(ROOT / folder) for source in all_sources), f"{folder} has no sources")
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            errors = "".join(pool.map(self.compile, all_sources))
        self.assertFalse(errors, "\n" + errors)
        objects = map(self.object_of, all_sources)
        errors = self.errors_of([*COMPILER, "-mexec-model=reactor", *objects, "-o", self.build / "play.wasm"])
        self.assertFalse(errors, "\n" + errors)


if __name__ == "__main__":
    WasmTest.build, WasmTest.json = Path(sys.argv.pop()), Path(sys.argv.pop())
    unittest.main()
