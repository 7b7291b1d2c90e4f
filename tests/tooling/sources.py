"""The project's root and its source files, for the tests of this folder."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAYERS = ("shared", "protocol", "server", "client")


def files(root, folders, suffixes):
    """All files below the folders with one of the suffixes, sorted, so that messages come in one order."""
    found = (path for folder in folders for path in (root / folder).rglob("*"))
    return sorted(path for path in found if path.suffix in suffixes)
