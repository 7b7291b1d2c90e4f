"""A ball's step by a kernel takes as many instructions as by a loop written by hand for the same effects, within 2 %.

usage: kernel_cost_test.py KERNEL_STEPS

Counted by callgrind, which no other work on the machine disturbs. A step is what the kernel does to a ball that meets
nothing: place and velocity, and what ends with it. The search for contacts is no part of it.
"""

import collections
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

MOST = 0.02  # of the loop's instructions, more or fewer


def inclusive_costs(profile):
    """Instructions by the name of the function that was called, with all that it called, out of a callgrind file."""
    names, costs, called = {}, collections.Counter(), None
    lines = iter(profile.splitlines())
    for line in lines:
        if match := re.match(r"c?fn=\((\d+)\)(?: (.*))?$", line):
            names.setdefault(match[1], match[2])
            called = names[match[1]]
        elif line.startswith("calls="):
            costs[called] += int(next(lines).split()[1])
    return costs


class KernelCostTest(unittest.TestCase):
    program = ""

    def test_a_step_costs_what_a_loop_written_by_hand_costs(self):
        with tempfile.TemporaryDirectory() as folder:
            profile = Path(folder) / "profile"
            run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", self.program],
                                 capture_output=True, text=True)
            self.assertEqual(0, run.returncode, run.stderr)
            costs = inclusive_costs(profile.read_text())
        kernels, steps = map(int, re.fullmatch(r"(\d+) kernels, (\d+) steps each\n", run.stdout).groups())
        found = collections.defaultdict(dict)
        for function, cost in costs.items():
            if match := re.search(r"tick_by_(kernel|hand)<poolhall::(\w+)", function):
                found[match[2]][match[1]] = cost
        self.assertEqual(kernels, len(found), found)
        for kernel, cost in found.items():
            with self.subTest(kernel):
                by_kernel, by_hand = cost["kernel"], cost["hand"]
                print(f"{kernel:21} {by_kernel / steps:6.2f} instructions a step, by hand {by_hand / steps:6.2f}")
                self.assertLess(abs(by_kernel / by_hand - 1), MOST)


if __name__ == "__main__":
    KernelCostTest.program = sys.argv.pop()
    unittest.main()
