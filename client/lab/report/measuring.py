"""Runs poolhall-lab for the report, and lets Ctrl-C end a run so that what is finished is kept."""

import re
import signal
import subprocess

INTERRUPTED = 128 + signal.SIGINT


class Failed(Exception):
    """poolhall-lab ended with `status`, and has said why."""

    def __init__(self, status):
        super().__init__(f"status {status}")
        self.status = status


class Lab:
    """One poolhall-lab; `interrupted` is True from the first Ctrl-C on."""

    def __init__(self, program):
        self.program = program
        self.interrupted = False

    def knows(self, command):
        """Whether its help names the command."""
        listed = subprocess.run([self.program, "--help"], capture_output=True, text=True, check=False).stdout
        return re.search(rf"^ +{command}\b", listed, re.MULTILINE) is not None

    def run(self, *arguments, **options):
        """True when the command ran to its end, False when it was interrupted; raises Failed."""
        child, told = None, False

        def interrupt(number, _frame):
            nonlocal told
            self.interrupted = True
            if child:
                told = True
                child.send_signal(number)

        before = {number: signal.signal(number, interrupt) for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            # In a session of its own, so that it gets each Ctrl-C once, and from here.
            child = subprocess.Popen([self.program, *map(str, arguments)], start_new_session=True, **options)
            if self.interrupted and not told:  # while it was started
                child.send_signal(signal.SIGINT)
            status = child.wait()
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)
        if self.interrupted:
            return False
        if status != 0:
            raise Failed(status if status > 0 else 128 - status)
        return True
