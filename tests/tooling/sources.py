"""The project's root and its source files, for the tests of this folder."""

import re
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAYERS = ("shared", "protocol", "server", "client")
CPP = {".hpp", ".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
_COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def files(root, folders, suffixes):
    """All files below the folders with one of the suffixes, sorted, so that messages come in one order."""
    found = (path for folder in folders for path in (root / folder).rglob("*"))
    return sorted(path for path in found if path.suffix in suffixes)


def without_comments(text):
    """C++ with comments and raw strings made blank; other strings, lines and columns stay."""
    return _COMMENT_OR_STRING.sub(
        lambda match: match[0] if match[0][0] == '"' else re.sub(r"[^\n]", " ", match[0]), text)


def includes(path):
    """(line, bracket, header) of each include line of a file."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if match := INCLUDE.match(line):
            yield number, *match.groups()


def planted(faults_in, texts):
    """What a rule finds in a project that has just these files, {"path": "text"}."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in texts.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return faults_in(root)
