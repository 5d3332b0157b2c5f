#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives rakelight-view in a real window by real key and mouse events.

  viewer_test.py PROGRAM VIEWER [unittest arguments]

Runs itself under xvfb-run. Without xvfb-run, xdotool or ImageMagick it is skipped, loudly (exit code 77)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from program import png  # noqa: E402

PROGRAM, VIEWER = "", ""
NEEDED = ("xvfb-run", "xdotool", "import")
SIZE = (640, 480)
PATIENCE = 10  # [s] for what has to happen; a wait ends as soon as it has

PARTS = ("mtllib m.mtl\no left\nv -2 -1 0\nv 0 -1 0\nv 0 1 0.6\nv -2 1 0\nusemtl red\nf 1 2 3 4\n"
         "o right\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0.6\nusemtl gray\nf 5 6 7 8\n")
MATERIALS = "newmtl red\nKd 0.8 0.1 0.1\nKs 0.3 0.3 0.3\nNs 20\nnewmtl gray\nKd 0.5 0.5 0.5\n"


class Window:
    """A running viewer."""

    def __init__(self, folder, *arguments):
        environment = dict(os.environ, XDG_CONFIG_HOME=str(folder / "config"))
        self.folder = folder
        self.process = subprocess.Popen([VIEWER, "--resolution", "%dx%d" % SIZE, "--stats", *map(str, arguments)], cwd=folder, env=environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.window = wait_for(lambda: self.process.poll() is not None or self.tool("search", "--onlyvisible", "--pid", self.process.pid),
                               "no window appeared")
        if self.process.poll() is not None:
            raise AssertionError(f"the viewer ended with {self.process.returncode}: {self.process.stderr.read()}")
        self.tool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        wait_for(self.shows_a_picture, "no picture appeared")
        self.settled_picture()

    def tool(self, *arguments):
        done = subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True)
        return done.stdout

    def key(self, *keys):
        self.tool("key", "--delay", 20, *keys)

    def drag(self, button, dx, dy, modifier=None):
        x, y = SIZE[0] // 2, SIZE[1] // 2
        held = ["keydown", modifier] if modifier else []
        released = ["keyup", modifier] if modifier else []
        moves = [word for i in range(10) for word in ("mousemove_relative", "--", str(dx // 10), str(dy // 10), "sleep", "0.01")]
        self.tool(*held, "mousemove", x, y, "mousedown", button, *moves, "mouseup", button, *released)

    def picture(self):
        """Rows of the display's pixels; the panels and texts are in it."""
        path = self.folder / "display.png"
        subprocess.run(["import", "-silent", "-window", "root", "-crop", "%dx%d+0+0" % SIZE, "+repage", "-depth", "8", "-type", "TrueColor", f"png24:{path}"], check=True)
        return png(path)[3]

    def settled_picture(self):
        """The display once it stands still: coarse pictures become fine ones."""
        last = self.picture()
        for _ in range(100):
            time.sleep(0.15)
            now = self.picture()
            if now == last:
                return now
            last = now
        raise AssertionError("the picture does not stand still")

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


class Viewer(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rakelight_viewer_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "parts.obj").write_text(PARTS)
        (self.folder / "m.mtl").write_text(MATERIALS)

    def open(self, *arguments):
        window = Window(self.folder, *(arguments or ("parts.obj",)))
        self.addCleanup(window.end)
        return window

    def position(self, window):
        return [float(n) for n in window.save()[1]["render"]["camera-position"].split(",")]

    def render(self, *arguments):
        out = self.folder / "rendered.png"
        done = subprocess.run([PROGRAM, "render", *map(str, arguments), "-o", str(out)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return png(out)

    def test_a_saved_scene_is_rendered_to_the_pixel_and_shown_again(self):
        window = self.open()
        window.drag(1, 90, 40)
        window.key("s", "Shift+l", "q", "a", "t")
        path, scene = window.save()
        shot = png(window.screenshot())
        self.assertTrue(self.render(path) == shot)
        self.assertEqual(shot[:2], SIZE)
        self.assertEqual(scene["render"]["shading"], ["gouraud"] if isinstance(scene["render"]["shading"], list) else "gouraud")
        self.assertEqual(window.close()[0], 0)
        again = self.open(path)
        self.assertTrue(png(again.screenshot()) == shot)
        again.close()

    def test_the_window_shows_what_render_draws(self):
        window = self.open()
        window.key("n")  # the file's name goes away
        expected = self.render("parts.obj", "--resolution", "%d,%d" % SIZE)[3]
        wait_for(lambda: window.picture() == expected, "the display does not hold the picture of render")

    def test_the_pointer_orbits_pans_and_zooms(self):
        window = self.open()
        window.key("1", "5", "5")
        start = self.position(window)
        window.drag(1, 120, 0)
        turned = self.position(window)
        self.assertLess(turned[0], start[0] - 0.5)
        self.assertAlmostEqual(turned[1], start[1], 6)
        window.drag(1, 60, 60, "shift")
        panned = self.position(window)
        self.assertGreater(panned[1], turned[1] + 0.1)
        distance = lambda p: sum(x * x for x in p) ** 0.5
        window.key("Home", "1", "5", "5")
        window.tool("click", "4", "click", "4")
        self.assertLess(distance(self.position(window)), 0.9 * distance(start))

    def test_walking_goes_ahead_and_turns_the_head(self):
        window = self.open()
        window.key("1", "5", "5")
        start = self.position(window)
        window.key("grave")
        window.tool("keydown", "w", "sleep", "0.5", "keyup", "w")
        ahead = self.position(window)
        self.assertLess(ahead[2], start[2] - 0.1)
        window.tool("mousemove_relative", "80", "0")
        window.tool("keydown", "w", "sleep", "0.5", "keyup", "w")
        self.assertGreater(abs(self.position(window)[0] - ahead[0]), 0.02)  # to the side
        window.key("Escape")
        before = self.position(window)
        window.tool("keydown", "d", "sleep", "0.3", "keyup", "d")
        self.assertEqual(self.position(window), before)

    def test_each_panel_opens_and_closes(self):
        window = self.open()
        closed = window.settled_picture()
        for key in ("F2", "F3", "F4", "F5", "F6", "F7", "F8"):
            window.key(key)
            window.differs_from(closed, 2000)
            window.key(key)
            wait_for(lambda: window.picture() == closed, f"{key} does not close its panel")

    def test_marks_help_and_theme_are_seen(self):
        window = self.open("parts.obj", "--normals", "object")  # so that there is a seam
        for key in ("g", "x", "d", "shift+n", "v", "h", "e", "w", "o", "c", "F10"):
            before = window.settled_picture()
            window.key(key)
            window.differs_from(before, 20, f"after {key}")
            if key == "h":
                window.key("Escape")

    def test_files_are_stepped_through_and_loaded_again_when_they_change(self):
        window = self.open("parts.obj", "builtin:teapot", "--view", "front")
        first = window.settled_picture()
        window.key("Right")
        window.differs_from(first, 5000)
        window.key("Left")
        wait_for(lambda: window.picture() == first, "the first file did not come back")
        (self.folder / "parts.obj").write_text(PARTS.replace("v 0 1 0.6\n", "v 0 2 0.6\n"))
        window.differs_from(first, 2000)

    def test_a_broken_file_is_told_of_and_the_window_lives_on(self):
        (self.folder / "broken.glb").write_bytes(b"glTF nonsense")
        window = self.open("parts.obj", "broken.glb")
        before = window.settled_picture()
        window.key("Right")
        window.differs_from(before, 200)  # the message
        window.key("Left")
        wait_for(lambda: window.picture() == before, "the first file did not come back")
        self.assertEqual(window.close()[0], 0)

    def test_a_split_shows_two_looks_and_the_second_view_turns_alone(self):
        window = self.open()
        window.key("n", "backslash")
        window.settled_picture()
        window.tool("mousemove", 20, 200, "click", 1)
        before = window.settled_picture()
        window.key("c")  # another channel, of the left picture alone
        window.differs_from(before, 2000)
        after = window.settled_picture()
        middle = 3 * (SIZE[0] // 2)
        self.assertFalse([row[:middle - 9] for row in before] == [row[:middle - 9] for row in after])
        self.assertTrue([row[middle + 9:] for row in before] == [row[middle + 9:] for row in after])
        window.key("c", "shift+backslash")
        window.differs_from(after, 5000)
        before = window.settled_picture()
        window.tool("mousemove", 480, 240, "mousedown", 1, *["mousemove_relative", "5", "0", "sleep", "0.01"] * 12, "mouseup", 1)
        window.differs_from(before, 1000)
        after = window.settled_picture()
        self.assertTrue([row[:middle] for row in before[:400]] == [row[:middle] for row in after[:400]])  # texts stand below

    def test_a_clean_screenshot_is_transparent(self):
        window = self.open()
        self.assertEqual(png(window.screenshot("ctrl+F12"))[2], 4)

    def test_a_turn_is_recorded(self):
        config = self.folder / "config" / "rakelight"
        config.mkdir(parents=True)
        (config / "view.conf").write_text("record-frames = 3\n")
        window = self.open()
        window.key("F9")
        wait_for(lambda: (self.folder / "parts-turn-1" / "0003.png").exists(), "no turn was recorded")
        self.assertTrue(png(self.folder / "parts-turn-1" / "0001.png") == png(window.screenshot()))

    def test_seamless_models_are_saved(self):
        window = self.open()
        window.key("ctrl+shift+s")
        out = self.folder / "parts-seamless.obj"
        wait_for(out.exists, "no seamless model was saved")
        done = subprocess.run([PROGRAM, "inspect", str(out), "--check", "--max-seam", "0.1"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_settings_are_remembered(self):
        window = self.open()
        window.key("F10", "F3")
        self.assertEqual(window.close()[0], 0)
        text = (self.folder / "config" / "rakelight" / "view.conf").read_text()
        self.assertIn("dark = off", text)
        self.assertIn("panel-Shading = on", text)

    def test_wrong_options_are_refused_before_a_window_opens(self):
        for arguments, code in ((["--shading", "nonsense"], 2), (["--no-such-option"], 2)):
            done = subprocess.run([VIEWER, *arguments], capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, code)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_rakelight_view_becomes_the_viewer(self):
        done = subprocess.run([PROGRAM, "view", "parts.obj"], capture_output=True, text=True, timeout=PATIENCE,
                              env={k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")})
        self.assertEqual(done.returncode, 1)
        self.assertIn("no window can be opened", done.stderr)


    def test_rakelight_says_where_no_viewer_is_installed(self):
        alone = self.folder / "rakelight"
        shutil.copy(PROGRAM, alone)
        done = subprocess.run([alone, "view", "parts.obj"], capture_output=True, text=True, timeout=PATIENCE, env={"PATH": str(self.folder)})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "^rakelight: error: the viewer 'rakelight-view' is neither beside this program nor in PATH.*\n$")

    def test_a_model_alone_opens_the_viewer(self):
        process = subprocess.Popen([PROGRAM, "parts.obj"], cwd=self.folder, env=dict(os.environ, XDG_CONFIG_HOME=str(self.folder)))
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        wait_for(lambda: subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(process.pid)], capture_output=True).stdout, "no window appeared")

    def test_lights_are_dragged_in_the_picture(self):
        (self.folder / "lamp.scene.toml").write_text("[[model]]\nfile = 'parts.obj'\n[[light]]\ntype = 'point'\nposition = [0, 0.5, 1]\n"
                                                     "[[camera]]\nposition = [0, 0.5, 6]\ntarget = [0, 0.5, 0]\n")
        window = self.open("lamp.scene.toml")
        before = window.settled_picture()
        window.key("d")
        window.differs_from(before, 20, "after d")
        before = window.settled_picture()
        window.drag(1, 100, 0)  # the lamp is in the middle
        window.differs_from(before, 200, "when the lamp was dragged")
        _, scene = window.save()
        self.assertGreater(scene["light"][0]["position"][0], 0.3)
        self.assertAlmostEqual(scene["light"][0]["position"][1], 0.5, 6)
        self.assertNotIn("camera-position", scene.get("render", {}))

    def test_a_pixel_is_explained(self):
        window = self.open()
        before = window.settled_picture()
        window.key("p")
        window.tool("mousemove", 320, 240, "click", 1)
        window.differs_from(before, 10000)  # the panel with its text

    def test_a_missing_file_is_told_of_on_the_terminal_too(self):
        process = subprocess.Popen([VIEWER, "nowhere.glb"], cwd=self.folder, stderr=subprocess.PIPE, text=True, env=dict(os.environ, XDG_CONFIG_HOME=str(self.folder)))
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertRegex(process.stderr.readline(), "^rakelight: error: .*nowhere.glb")


def main():
    missing = [tool for tool in NEEDED if not shutil.which(tool)]
    if missing:
        print(f"SKIPPED: the viewer is not tested: {', '.join(missing)} not installed", file=sys.stderr)
        return 77
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        environment = dict(os.environ, RAKELIGHT_VIEWER_TEST_DISPLAY="1")
        return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x900x24 -noreset", sys.executable, *sys.argv], env=environment).returncode
    global PROGRAM, VIEWER
    PROGRAM, VIEWER = (os.path.abspath(path) for path in sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])


if __name__ == "__main__":
    sys.exit(main())
