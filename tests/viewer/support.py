# SPDX-License-Identifier: Apache-2.0
"""What the tests of rakelight-view share: the running window, driven by real key and mouse events, and a display for it."""
import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli" / "support"))
from program import png  # noqa: E402

import xdnd  # noqa: E402

PROGRAM, VIEWER = "", ""
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NEEDED = ("xvfb-run", "xdotool")
SHARED = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", ROOT.parent / "shared"))
SIZE = (640, 480)
PATIENCE = 30  # [s] for what has to happen; a wait ends as soon as it has
STILL = 0.6  # [s] without a change, after which nothing more is expected: the next finer picture takes less

PARTS = ("mtllib m.mtl\no left\nv -2 -1 0\nv 0 -1 0\nv 0 1 0.6\nv -2 1 0\nusemtl red\nf 1 2 3 4\n"
         "o right\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0.6\nusemtl gray\nf 5 6 7 8\n")
MATERIALS = "newmtl red\nKd 0.8 0.1 0.1\nKs 0.3 0.3 0.3\nNs 20\nnewmtl gray\nKd 0.5 0.5 0.5\n"


class Window:
    """A running viewer."""

    def __init__(self, folder, *arguments, waits=True):
        """waits: until the first picture stands still."""
        environment = dict(os.environ, XDG_CONFIG_HOME=str(folder / "config"))
        settings = folder / "config" / "rakelight" / "view.conf"
        if not settings.exists():  # what keys did would be said over the pictures that are compared
            settings.parent.mkdir(parents=True)
            settings.write_text("announce = off\n")
        self.folder, self.other = folder, None
        self.process = subprocess.Popen([VIEWER, "--resolution", "%dx%d" % SIZE, "--stats", *map(str, arguments)], cwd=folder, env=environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.window = wait_for(lambda: self.process.poll() is not None or self.tool("search", "--onlyvisible", "--pid", self.process.pid),
                               "no window appeared")
        if self.process.poll() is not None:
            raise AssertionError(f"the viewer ended with {self.process.returncode}: {self.process.stderr.read()}")
        self.tool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        wait_for(self.shows_a_picture, "no picture appeared")
        if waits:
            self.settled_picture()

    @contextlib.contextmanager
    def stopped(self):
        """What happens meanwhile reaches the viewer at once."""
        self.process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self.process.send_signal(signal.SIGCONT)

    def tool(self, *arguments):
        done = subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True)
        return done.stdout

    def key(self, *keys):
        """Each has reached the display before the next one is sent: of presses of one key within a millisecond, which a display that waits
        for its turn gives to all that came meanwhile, GLFW takes the first alone."""
        for key in keys:
            self.tool("key", key)

    def drag(self, button, dx, dy, modifier=None):
        x, y = SIZE[0] // 2, SIZE[1] // 2
        held = ["keydown", modifier] if modifier else []
        released = ["keyup", modifier] if modifier else []
        moves = [word for i in range(10) for word in ("mousemove_relative", "--", str(dx // 10), str(dy // 10), "sleep", "0.01")]
        self.tool(*held, "mousemove", x, y, "mousedown", button, *moves, "mouseup", button, *released)

    def picture(self):
        """Rows of the display's pixels; the panels and texts are in it."""
        return self.desktop().pixels(*SIZE)

    def settled_picture(self):
        """The display once it stands still: coarse pictures become fine ones."""
        end, last, since = time.monotonic() + 3 * PATIENCE, self.picture(), time.monotonic()
        while time.monotonic() - since < STILL:
            if time.monotonic() > end:
                raise AssertionError("the picture does not stand still")
            time.sleep(0.1)
            now = self.picture()
            if now != last:
                last, since = now, time.monotonic()
        return last

    def shows_a_picture(self):
        rows = self.picture()
        return len({bytes(row[3 * x:3 * x + 3]) for row in rows[::8] for x in range(0, SIZE[0], 8)}) > 8

    def differs_from(self, before, least=200, after=""):
        """Once as many pixels differ from those of `before`, which it waits for."""
        def differing():
            now = self.picture()
            changed = [(a, b) for a, b in zip(now, before) if a != b]
            return sum(a[3 * x:3 * x + 3] != b[3 * x:3 * x + 3] for a, b in changed for x in range(SIZE[0])) >= least
        wait_for(differing, f"the picture did not change {after}")

    def drop(self, *files, x=SIZE[0] // 2, y=SIZE[1] // 2, held=()):
        """Files from another program. held: names of modifier keys."""
        self.desktop().drop(self.window.split()[0], [self.folder / file for file in files], x, y, held)

    def clipboard(self):
        return self.desktop().clipboard()

    def desktop(self):
        if self.other is None:
            self.other = xdnd.Desktop()
        return self.other

    def save(self):
        """The saved scene: its path, and its [render]."""
        before = set(self.folder.glob("*.scene.toml"))
        self.key("ctrl+s")
        path = wait_for(lambda: next(iter(set(self.folder.glob("*.scene.toml")) - before), None), "no scene was saved")
        return path, tomllib.loads(path.read_text())

    def screenshot(self, keys="F12"):
        before = set(self.folder.glob("*-?.png"))
        self.key(keys)
        return wait_for(lambda: next(iter(set(self.folder.glob("*-?.png")) - before), None), "no screenshot was written")

    def end(self):
        """Whatever it does."""
        if self.other:
            self.other.close()
            self.other = None
        self.process.kill()
        self.process.communicate()

    def close(self):
        self.key("ctrl+q")
        out, err = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, err


def wait_for(happened, message):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if result := happened():
            return result
        time.sleep(0.05)
    raise AssertionError(message)


class Case(unittest.TestCase):
    """A test with a folder of its own, in which a model lies."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rakelight_viewer_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "parts.obj").write_text(PARTS)
        (self.folder / "m.mtl").write_text(MATERIALS)
        self.addTypeEqualityFunc(list, self.are_same)

    def are_same(self, a, b, msg=None):
        """Rows of pictures are not told apart line by line: that takes minutes."""
        if len(a) < 100:
            self.assertListEqual(a, b, msg)
        elif a != b:
            rows = [i for i, (x, y) in enumerate(zip(a, b)) if x != y]
            self.fail(f"{msg or 'two pictures differ'}: {len(rows)} of {len(a)} and {len(b)} rows, the first is {rows[:1]}")

    def open(self, *arguments):
        window = Window(self.folder, *(arguments or ("parts.obj",)))
        self.addCleanup(window.end)
        return window

    def position(self, window):
        world = window.save()[1]
        if "camera-position" in world["render"]:
            return [float(n) for n in world["render"]["camera-position"].split(",")]
        return next(c["position"] for c in world["camera"] if c["name"] == world["render"]["camera-index"])  # with recorded keys

    def render(self, *arguments):
        out = self.folder / "rendered.png"
        done = subprocess.run([PROGRAM, "render", *map(str, arguments), "-o", str(out)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return png(out)


def under_xvfb():
    """Runs this program again in a display of its own."""
    environment = dict(os.environ, RAKELIGHT_VIEWER_TEST_DISPLAY="1")
    return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x900x24 -noreset", sys.executable, *sys.argv], env=environment).returncode


def main():
    missing = [tool for tool in NEEDED if not shutil.which(tool)] + ([] if xdnd.is_there() else ["python3-xlib"])
    if missing:
        print(f"SKIPPED: the viewer is not tested: {', '.join(missing)} not installed", file=sys.stderr)
        return 77
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        return under_xvfb()
    global PROGRAM, VIEWER
    PROGRAM, VIEWER = (os.path.abspath(path) for path in sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
