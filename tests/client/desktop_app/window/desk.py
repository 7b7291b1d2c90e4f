"""Drives the real window as a person would: keys and mouse by xdotool, eyes by screenshots."""

import os
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

PATIENCE = 20  # s; a loaded machine is slow, never wrong


def wait_for(what, condition, patience=PATIENCE):
    """The first true value of condition(); fails with `what` when it does not come."""
    until = time.monotonic() + patience
    while time.monotonic() < until:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise AssertionError(f"waited in vain for {what}")


class Picture:
    """The pixels of a PNG file."""

    def __init__(self, path):
        self.path = Path(path)
        size = subprocess.run(["identify", "-format", "%m %w %h", path], check=True, capture_output=True, text=True)
        self.format, width, height = size.stdout.split()
        self.width, self.height = int(width), int(height)
        raw = subprocess.run(["convert", path, "-depth", "8", "rgb:-"], check=True, capture_output=True)
        self.pixels = raw.stdout

    def at(self, x, y):
        start = 3 * (y * self.width + x)
        return tuple(self.pixels[start:start + 3])

    def find(self, is_wanted, box=None):
        """Positions whose colour is_wanted(r, g, b), within (left, top, right, bottom)."""
        left, top, right, bottom = box or (0, 0, self.width, self.height)
        return [(x, y) for y in range(top, bottom) for x in range(left, right) if is_wanted(*self.at(x, y))]

    def centre(self, is_wanted, box=None):
        """The middle of what has that colour."""
        found = self.find(is_wanted, box)
        assert found, f"nothing of that colour in {self.path}"
        return tuple((min(p[i] for p in found) + max(p[i] for p in found)) / 2 for i in (0, 1))

    def difference(self, other, box=None):
        """How many pixels differ plainly within the box."""
        left, top, right, bottom = box or (0, 0, self.width, self.height)
        count = 0
        for y in range(top, bottom):
            for x in range(left, right):
                if any(abs(a - b) > 24 for a, b in zip(self.at(x, y), other.at(x, y))):
                    count += 1
        return count


class Client:
    """A running poolhall-client and its window."""

    def __init__(self, program, *arguments, state=None, title="Poolhall"):
        self.folder = Path(tempfile.mkdtemp(prefix="poolhall-window-"))
        self.shots = self.folder / "shots"
        self.errors = open(self.folder / "stderr", "w+")
        environment = dict(os.environ, SDL_RENDER_DRIVER="software", SDL_AUDIODRIVER="dummy",
                           SDL_VIDEODRIVER="x11", XDG_STATE_HOME=str(state or self.folder / "state"))
        if "--screenshots" not in arguments:
            arguments = (*arguments, "--screenshots", str(self.shots))
        self.process = subprocess.Popen([program, *arguments], env=environment, stderr=self.errors)
        try:
            self.window = wait_for(f"a window {title}", lambda: self._find_window(title))
        except AssertionError:
            # Left running, it would take the keys meant for the next window.
            self.close()
            raise
        time.sleep(0.5)  # for the first picture

    def _find_window(self, title):
        assert self.process.poll() is None, f"the client ended: {self.error_text()}"
        found = subprocess.run(["xdotool", "search", "--all", "--onlyvisible", "--pid", str(self.process.pid),
                                "--name", "^" + title], capture_output=True, text=True)
        return found.stdout.split()[-1] if found.stdout.split() else None

    def error_text(self):
        self.errors.flush()
        return (self.folder / "stderr").read_text()

    def _xdotool(self, *arguments):
        subprocess.run(["xdotool", *arguments], check=True, capture_output=True)

    def focus(self):
        self._xdotool("windowraise", self.window, "windowfocus", "--sync", self.window)

    def key(self, name):
        self.focus()
        self._xdotool("key", name)

    def hold(self, name, seconds):
        self.focus()
        self._xdotool("keydown", name)
        time.sleep(seconds)
        self._xdotool("keyup", name)

    def move_mouse(self, x, y):
        self._xdotool("mousemove", "--window", self.window, str(x), str(y))
        time.sleep(0.1)

    def press_mouse(self, down):
        self._xdotool("mousedown" if down else "mouseup", "1")
        time.sleep(0.1)

    def click(self):
        self._xdotool("click", "1")

    def resize(self, width, height):
        self._xdotool("windowsize", "--sync", self.window, str(width), str(height))
        time.sleep(0.5)

    def look(self):
        """Presses P and gives what it saved."""
        before = set(self.shots.glob("*.png"))
        self.key("p")
        new = wait_for("a screenshot", lambda: set(self.shots.glob("*.png")) - before)
        return Picture(new.pop())

    def cpu_seconds(self):
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self, how=signal.SIGTERM):
        """Its exit status."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.errors.close()
        shutil.rmtree(self.folder, ignore_errors=True)


# Where things are in a window of 1280 x 720 at the start of a game, px.
TABLE = (175, 155, 1105, 583)
CUE_BALL_COLUMN = (390, 155, 424, 583)
START = (407, 368)
EIGHT_BALL_BOX = (858, 350, 895, 387)
LOWER_LEFT = (96, 560, 400, 720)


def is_cue_ball(r, g, b):
    """Ivory, down to its shaded edge; lines on the felt are greener."""
    return r > 110 and abs(r - g) < 30 and b > 80


def is_yellow(r, g, b):
    return r > 200 and g > 170 and b < 110
