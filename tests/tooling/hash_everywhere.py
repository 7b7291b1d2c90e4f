"""Builds the golden program for every platform, runs it, and compares its hashes with the committed ones.

usage: hash_everywhere.py BUILD-FOLDER GOLDEN-FILE [PLATFORM...]

Each platform's hashes stay in BUILD-FOLDER/PLATFORM/hashes.txt. Status 0 if all agree; 1 if one differs or could not be
built or run; 2 for wrong arguments.
"""

import re
import subprocess
import sys
import time
from pathlib import Path

import platforms


def hashes_of(text, where):
    """The lines `corpus hash` as a dictionary; ValueError says where one is not."""
    hashes = {}
    for number, line in enumerate(text.splitlines(), 1):
        match = re.fullmatch(r"(\S+) ([0-9a-f]{16})", line)
        if not match or match[1] in hashes:
            raise ValueError(f"{where}:{number}: not a corpus of its own and its hash: '{line}'")
        hashes[match[1]] = match[2]
    if not hashes:
        raise ValueError(f"{where}: no hash")
    return hashes


def first_difference(committed, actual):
    """Names the first corpus that differs, and how; None if none does."""
    for corpus in {**committed, **actual}:
        if committed.get(corpus) != actual.get(corpus):
            return f"{corpus}: {actual.get(corpus, 'none')}, committed is {committed.get(corpus, 'none')}"
    return None


def hashes_on(platform, folder):
    """What the golden program prints there. Compilers and programs that fail say why themselves, on stderr."""
    try:
        program, _ = platforms.build(platform, folder)
    except subprocess.CalledProcessError:
        raise ValueError("does not build") from None
    try:
        output = platforms.output_of(platform, program)
    except subprocess.CalledProcessError as error:
        raise ValueError(f"the program ended with status {error.returncode}") from None
    except subprocess.TimeoutExpired:
        raise ValueError(f"no end within {platforms.RUN_LIMIT_S} s") from None
    (folder / "hashes.txt").write_text(output)
    return hashes_of(output, folder / "hashes.txt")


def verdict(platform, folder, committed):
    missing = platform.missing_packages()
    if missing:
        return f"missing: apt-get install {' '.join(missing)}"
    if platform.fma and not platforms.has_fma():
        return "not run: this processor has no FMA"
    try:
        return first_difference(committed, hashes_on(platform, folder)) or "ok"
    except ValueError as error:
        return str(error)


def version_of(platform):
    try:
        output = subprocess.run([platform.compiler.split()[0], "--version"], capture_output=True, text=True).stdout
    except FileNotFoundError:
        return "-"
    return next(iter(re.findall(r"\d+\.\d+\.\d+", output)), "?")


def chosen(names):
    known = {platform.name: platform for platform in platforms.PLATFORMS}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise ValueError(f"unknown platform '{unknown[0]}'; there are {', '.join(known)}")
    return [known[name] for name in names or known]


def main(folder, golden, *names):
    try:
        selection = chosen(names)
        committed = hashes_of(Path(golden).read_text(), golden)
    except (OSError, ValueError) as error:
        print(f"hash-everywhere: {error}", file=sys.stderr)
        return 2
    print(f"{'platform':18}{'compiler':10}{'time':>6}  hashes", flush=True)
    agreeing = 0
    for platform in selection:
        start = time.monotonic()
        result = verdict(platform, Path(folder) / platform.name, committed)
        agreeing += result == "ok"
        print(f"{platform.name:18}{version_of(platform):10}{time.monotonic() - start:4.0f} s  {result}", flush=True)
    print(f"{agreeing} of {len(selection)} platforms agree with {golden} on {len(committed)} corpora")
    return 0 if agreeing == len(selection) else 1


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(f"hash-everywhere: {__doc__.splitlines()[2]}")
    sys.exit(main(*sys.argv[1:]))
