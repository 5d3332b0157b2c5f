#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives rakelight-view in a real window by real key and mouse events.

  viewer_test.py PROGRAM VIEWER [unittest arguments]

Runs itself under xvfb-run. Without xvfb-run, xdotool or python3-xlib it is skipped, loudly (exit code 77)."""
import os
import shutil
import subprocess
import sys

import support
from support import MATERIALS, PARTS, PATIENCE, SIZE, Case, png, wait_for


class Viewer(Case):
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

    def test_engines_one_after_the_other_leave_the_scene_as_it_was(self):
        window = self.open()
        before = window.save()[1]
        self.assertEqual(before["render"]["samples"], 4)
        picture = png(window.screenshot())  # the display also has messages that come and go
        for _ in range(5):  # gl, trace, paths, auto, and soft again
            window.key("r")
            window.settled_picture()
        self.assertEqual(window.save()[1], before)
        self.assertTrue(png(window.screenshot()) == picture)
        window.close()

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

    def test_a_file_that_the_model_names_is_watched_too(self):
        window = self.open()
        before = window.settled_picture()
        (self.folder / "m.mtl").write_text(MATERIALS.replace("0.8 0.1 0.1", "0.1 0.8 0.1"))
        window.differs_from(before, 2000)

    def test_shapes_are_saved_with_seam_free_normals_in_the_working_folder(self):
        window = self.open("builtin:teapot")
        window.key("ctrl+shift+s")
        wait_for((self.folder / "teapot-seamless.glb").exists, "no seamless model was saved")

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
        self.assertTrue([row[:middle] for row in before[40:400]] == [row[:middle] for row in after[40:400]])  # but for labels and texts

    def test_files_are_written_before_the_viewer_ends(self):
        window = self.open()
        window.key("F12", "ctrl+F12", "ctrl+s", "ctrl+q")
        window.process.communicate(timeout=3 * PATIENCE)
        self.assertEqual(len(list(self.folder.glob("*.png"))) - (self.folder / "display.png").exists(), 2)
        self.assertEqual(len(list(self.folder.glob("*.scene.toml"))), 1)

    def test_a_file_that_cannot_be_written_is_told_of_when_the_viewer_has_ended(self):
        window = self.open("builtin:teapot")
        shutil.rmtree(self.folder)  # the working folder
        window.key("F12")
        code, err = window.close()
        self.assertEqual(code, 1)
        self.assertIn("teapot-1.png", err)

    def test_a_clean_screenshot_is_transparent(self):
        window = self.open()
        self.assertEqual(png(window.screenshot("ctrl+F12"))[2], 4)

    def set_record_frames(self, count):
        config = self.folder / "config" / "rakelight"
        config.mkdir(parents=True)
        (config / "view.conf").write_text(f"record-frames = {count}\n")

    def test_files_asked_for_one_after_the_other_are_all_written(self):
        window = self.open("builtin:teapot:tolerance=1e-4", "--samples", "8")  # so that each takes a while
        window.settled_picture()
        window.key("F12", "ctrl+F12", "F12", "ctrl+s", "ctrl+s")
        pictures = lambda: sorted(self.folder.glob("teapot*-?.png"))
        wait_for(lambda: len(pictures()) == 3 and len(list(self.folder.glob("*.scene.toml"))) == 2, f"not all files were written: {sorted(x.name for x in self.folder.iterdir())}")
        self.assertEqual([png(path)[2] for path in pictures()], [3, 4, 3])  # the second one is transparent

    def test_a_recording_is_not_broken_off_by_what_comes_after(self):
        self.set_record_frames(12)
        window = self.open()
        window.key("F9", "F12", "p")
        window.tool("mousemove", 320, 240, "click", 1)  # explains a pixel
        wait_for((self.folder / "parts-1.png").exists, "no screenshot was written")
        self.assertEqual(len(list((self.folder / "parts-turn-1").glob("*.png"))), 12)

    def test_escape_keeps_the_pictures_of_a_recording_that_are_written(self):
        self.set_record_frames(500)
        window = self.open()
        window.key("F9")
        wait_for((self.folder / "parts-turn-1" / "0003.png").exists, "no turn was recorded")
        window.key("Escape")
        window.screenshot()  # waits for the end of the recording
        self.assertLess(len(list((self.folder / "parts-turn-1").glob("*.png"))), 500)
        self.assertEqual(window.close()[0], 0)

    def test_escape_cancels_a_load(self):
        shapes = [f"[[primitive]]\ntype = 'sphere'\nname = '{i}'\nradius = {1 - 0.05 * i}\ntolerance = 3e-6\n" for i in range(8)]
        (self.folder / "slow.scene.toml").write_text("".join(shapes))
        window = self.open("parts.obj", "slow.scene.toml")
        before = window.settled_picture()
        window.tool("key", "--delay", 0, "Right", "Escape")
        window.differs_from(before, 50)  # the message
        window.settled_picture()
        self.assertTrue(before[:400] == window.picture()[:400])  # texts stand below
        self.assertEqual(window.save()[1]["model"][0]["file"], "parts.obj")
        code, err = window.close()
        self.assertEqual(code, 0)
        self.assertRegex(err, "^rakelight: error: .*cancelled")

    def test_a_turn_is_recorded(self):
        self.set_record_frames(3)
        window = self.open()
        window.key("F9")
        wait_for(lambda: (self.folder / "parts-turn-1" / "0003.png").exists(), "no turn was recorded")
        self.assertTrue(png(self.folder / "parts-turn-1" / "0001.png") == png(window.screenshot()))

    def test_seamless_models_are_saved(self):
        (self.folder / "parts-seamless.obj").write_text("mine")
        window = self.open()
        window.key("ctrl+shift+s")
        out = self.folder / "parts-seamless-2.obj"
        wait_for(out.exists, "no seamless model was saved")
        self.assertEqual((self.folder / "parts-seamless.obj").read_text(), "mine")
        done = subprocess.run([support.PROGRAM, "inspect", str(out), "--check", "--max-seam", "0.1"], capture_output=True, text=True)
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
            done = subprocess.run([support.VIEWER, *arguments], capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, code)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_rakelight_view_becomes_the_viewer(self):
        done = subprocess.run([support.PROGRAM, "view", "parts.obj"], capture_output=True, text=True, timeout=PATIENCE,
                              env={k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")})
        self.assertEqual(done.returncode, 1)
        self.assertIn("no window can be opened", done.stderr)

    def test_rakelight_says_where_no_viewer_is_installed(self):
        alone = self.folder / "rakelight"
        shutil.copy(support.PROGRAM, alone)
        done = subprocess.run([alone, "view", "parts.obj"], capture_output=True, text=True, timeout=PATIENCE, env={"PATH": str(self.folder)})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "^rakelight: error: the viewer 'rakelight-view' is neither beside this program nor in PATH.*\n$")

    def test_a_model_alone_opens_the_viewer(self):
        process = subprocess.Popen([support.PROGRAM, "parts.obj"], cwd=self.folder, env=dict(os.environ, XDG_CONFIG_HOME=str(self.folder)))
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
        process = subprocess.Popen([support.VIEWER, "nowhere.glb"], cwd=self.folder, stderr=subprocess.PIPE, text=True, env=dict(os.environ, XDG_CONFIG_HOME=str(self.folder)))
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertRegex(process.stderr.readline(), "^rakelight: error: .*nowhere.glb")

    def test_a_world_that_names_glsl_is_told_of_too(self):
        (self.folder / "own.glsl").write_text("user_terms")
        (self.folder / "w.scene.toml").write_text("[[primitive]]\ntype = 'sphere'\n[render]\nlighting = 'own.glsl'\n")
        process = subprocess.Popen([support.VIEWER, "w.scene.toml"], cwd=self.folder, stderr=subprocess.PIPE, text=True, env=dict(os.environ, XDG_CONFIG_HOME=str(self.folder)))
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertRegex(process.stderr.readline(), "^rakelight: error: .*w.scene.toml: line 4, column 1: .*allow-shaders")


if __name__ == "__main__":
    sys.exit(support.main())
