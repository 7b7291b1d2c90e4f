"""Three real windows at one table: two players and a spectator, driven by keys, compared by what they show.

    windows_test.py SERVER CLIENT        under a display of at least 1900 x 600, such as xvfb-run gives
"""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request
from pathlib import Path

CLIENT = sys.argv.pop(2)
SERVER = sys.argv.pop(1)
PATIENCE = 30  # s
WIDTH, HEIGHT = 620, 420
FEW = 60  # pixels; a ball's number may stand a little otherwise
CLOTH = (500, 220, 60, 90)  # a part of the cloth in a window of that size: width, height, x, y


def xdotool(*arguments):
    return subprocess.run(["xdotool", *map(str, arguments)], check=True, capture_output=True, text=True,
                          timeout=PATIENCE).stdout.strip()


def await_that(condition, what):
    end = time.monotonic() + PATIENCE
    while not (result := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"{what}: this did not happen")
        time.sleep(0.05)
    return result


def start(command, **settings):
    """A program that ends with the test's process, whatever happens."""
    return subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *map(str, command)], stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, text=True, **settings)


def end(process):
    process.terminate()
    try:
        process.wait(PATIENCE)
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Window:
    """One poolhall-client, placed side by side with the others."""

    def __init__(self, name, column, folder, server, *arguments):
        self.folder = folder / name
        self.folder.mkdir()
        environment = dict(os.environ, HOME=str(self.folder), XDG_STATE_HOME=str(self.folder / "state"),
                           SDL_VIDEODRIVER="x11", SDL_RENDER_DRIVER="software", SDL_AUDIODRIVER="dummy")
        self.process = start([CLIENT, "--server", server, "--name", name, "--width", WIDTH, "--height", HEIGHT,
                              "--screenshots", self.folder, *arguments], env=environment)
        self.id = await_that(self.find, f"{name}'s window opens").splitlines()[0]
        xdotool("windowmove", self.id, column * (WIDTH + 10), 0)

    def find(self):
        assert self.process.poll() is None, "the client has ended"
        search = subprocess.run(["xdotool", "search", "--all", "--onlyvisible", "--pid", str(self.process.pid), "--name",
                                 "^Poolhall"], capture_output=True, text=True, timeout=PATIENCE)
        return search.stdout.strip()

    def code(self):
        """The join code, once there is one; the title shows it."""
        found = re.search(r"[B-Z]{3}-?[B-Z]{3}$", xdotool("getwindowname", self.id))
        return found and found[0]

    def press(self, *keys):
        xdotool("windowfocus", "--sync", self.id)
        xdotool("key", "--delay", 40, *keys)

    def hold(self, key, seconds):
        xdotool("windowfocus", "--sync", self.id)
        xdotool("keydown", key)
        time.sleep(seconds)
        xdotool("keyup", key)

    def picture(self, name):
        """A picture of the cloth, taken from the X server."""
        path = self.folder / f"{name}.png"
        width, height, x, y = CLOTH
        subprocess.run(["import", "-window", self.id, "-crop", f"{width}x{height}+{x}+{y}", "+repage", str(path)],
                       check=True, timeout=PATIENCE)
        return path


def difference(one, other):
    """How many pixels of two pictures differ by more than a shade."""
    compared = subprocess.run(["compare", "-metric", "AE", "-fuzz", "8%", str(one), str(other), "null:"],
                              capture_output=True, text=True, timeout=PATIENCE)
    return int(float(compared.stderr.split()[0]))


class WindowsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="poolhall-e2e-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.port = free_port()
        self.server = self.serve()

    def serve(self):
        server = start([SERVER, "--listen", f"127.0.0.1:{self.port}", "--data", self.folder / "data"])
        self.addCleanup(end, server)
        self.assertEqual(f"listening on 127.0.0.1:{self.port}\n", server.stdout.readline())
        return server

    def open(self, name, column, *arguments):
        window = Window(name, column, self.folder, f"ws://127.0.0.1:{self.port}", *arguments)
        self.addCleanup(end, window.process)
        return window

    def match(self):
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/api/matches", timeout=PATIENCE) as answer:
            return json.load(answer)["matches"][0]

    def await_match(self, what, **wanted):
        def as_wanted():
            match = self.match()
            return match if all(match[key] == value for key, value in wanted.items()) else None

        try:
            return await_that(as_wanted, what)
        except AssertionError as failure:
            raise AssertionError(f"{failure}; the server says {self.match()}") from None

    def await_same_cloth(self, windows, name):
        """Waits until all windows show the same, and returns a picture of it."""
        def shown():
            first, *others = [window.picture(name) for window in windows]
            return first if all(difference(first, other) < FEW for other in others) else None

        return await_that(shown, f"all windows show the same table ({name})")

    def test_players_and_spectator_see_the_same_table_and_survive_the_server(self):
        ann = self.open("Ann", 0)
        code = await_that(ann.code, "the title shows the join code")
        bob = self.open("Bob", 1, "--match", code)
        self.await_match("Bob joins", phase="aiming")
        wanda = self.open("Wanda", 2, "--match", code, "--watch")
        self.await_match("Wanda watches", spectators=1)
        windows = [ann, bob, wanda]
        before = self.await_same_cloth([bob, wanda], "before")  # Ann's has the base line too

        ann.press("space")  # straight at the 8-ball, as the aim points by itself: the turn passes
        self.await_match("Ann's shot ends", shots=1, phase="aiming")
        after = self.await_same_cloth(windows, "after the shot")
        self.assertGreater(difference(before, after), FEW, "the balls have moved")
        bob.hold("Left", 0.4)
        aimed = self.await_same_cloth(windows, "aimed")
        self.assertGreater(difference(after, aimed), FEW, "the spectator sees the aim turn")

        bob.press("p")
        screenshot = bob.folder / "poolhall-001.png"
        await_that(screenshot.exists, "P saves a screenshot")

        self.server.send_signal(signal.SIGKILL)
        self.server.wait()
        self.server = self.serve()
        match = self.await_match("all come back to the table", shots=1, phase="aiming", spectators=1)
        await_that(lambda: all(seat["connected"] for seat in self.match()["seats"]), "both players have their seats")
        self.assertEqual(["Ann", "Bob"], [seat["name"] for seat in match["seats"]])
        back = self.await_same_cloth(windows, "after the server's end")
        self.assertLess(difference(aimed, back), FEW, "balls and aim are as they were")
        bob.press("space")
        self.await_match("Bob's shot begins", shots=2)
        bob.press("Escape")
        self.assertEqual(0, bob.process.wait(PATIENCE))


if __name__ == "__main__":
    unittest.main(verbosity=2)
