"""The sources are formatted. Versions of clang-format differ in their taste, so only Debian 12's version 14 is asked."""

import re
import shutil
import subprocess
import sys

from sources import ROOT

SKIPPED = 77  # ctest's SKIP_RETURN_CODE
program = shutil.which("clang-format")
version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout if program else "no clang-format"
if not re.search(r"version 14\.", version):
    print(f"needs clang-format 14, found: {version.strip()}")
    sys.exit(SKIPPED)
sys.exit(subprocess.run([str(ROOT / "poolhall"), "format", "--check"]).returncode)
