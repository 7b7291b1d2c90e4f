"""The report's code and the measurements of known content that its tests draw."""

import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPORT = HERE.parents[3] / "client" / "lab" / "report"
sys.path.insert(0, str(REPORT))


def run(*arguments, **options):
    """The program itself."""
    return subprocess.run([sys.executable, "-B", str(REPORT / "report.py"), *map(str, arguments)], capture_output=True, text=True,
                          check=False, **options)


def measured_folder(folder):
    """As a run leaves it, before it is drawn."""
    results = Path(folder) / "results"
    results.mkdir(parents=True)
    for name in ("accuracy.json", "effects.json"):
        shutil.copy(HERE / name, results)
    return Path(folder)
