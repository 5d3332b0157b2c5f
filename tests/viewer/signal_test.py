#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Signals while the viewer writes files: it ends by the signal and leaves no temporary file.

  signal_test.py PROGRAM VIEWER [unittest arguments]

Skipped as viewer_test.py is."""
import signal
import time

import support
from support import Case, wait_for

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)


class Signals(Case):
    def temporary_files(self):
        return [str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.name.startswith(".rl-") or p.suffix in (".part", ".tmp")]

    def grid(self):
        """A model that takes a while to be written."""
        size = 300
        rows = [f"v {x} {y} {(x * y) % 7}" for y in range(size) for x in range(size)]
        rows += [f"f {y * size + x + 1} {y * size + x + 2} {(y + 1) * size + x + 2} {(y + 1) * size + x + 1}" for y in range(size - 1) for x in range(size - 1)]
        (self.folder / "grid.obj").write_text("\n".join(rows) + "\n")

    def end_while_it_writes(self, number, keys, arguments, begun):
        """begun: whether something is being written."""
        window = self.open(*arguments)
        before = set(self.folder.rglob("*"))
        window.key(*keys)
        end = time.monotonic() + support.PATIENCE
        while not begun(before) and time.monotonic() < end:
            time.sleep(0.0005)
        window.process.send_signal(number)
        _, said = window.process.communicate(timeout=support.PATIENCE)
        self.assertEqual(window.process.returncode, -number, said)
        self.assertEqual(self.temporary_files(), [])
        window.end()
        return said

    def test_no_temporary_file_is_left(self):
        self.grid()
        something_new = lambda before: set(self.folder.rglob("*")) - before  # noqa: E731
        for number in SIGNALS:
            for keys, arguments in ((("F12",), ("parts.obj",)), (("F9",), ("parts.obj",)), (("ctrl+s",), ("parts.obj",)), (("ctrl+shift+s",), ("grid.obj",))):
                with self.subTest(signal=number.name, keys=keys):
                    self.end_while_it_writes(number, keys, arguments, something_new)

    def test_a_copy_of_a_texture_is_not_left_half(self):
        """It lies outside of the scene's folder, so saving copies it."""
        (self.folder / "models").mkdir()
        for name in ("parts.obj", "m.mtl"):
            (self.folder / name).rename(self.folder / "models" / name)
        (self.folder / "env.ppm").write_bytes(b"P6 4000 2000 255\n" + bytes(4000 * 2000 * 3))
        for number in SIGNALS:
            with self.subTest(signal=number.name):
                self.end_while_it_writes(number, ("ctrl+s",), ("models/parts.obj", "--hdri-file", "env.ppm"), lambda before: set(self.folder.rglob("*")) - before)
                for copy in self.folder.rglob("*-files/env.ppm"):
                    self.assertEqual(copy.stat().st_size, (self.folder / "env.ppm").stat().st_size)

    def test_it_ends_by_the_signal_when_it_does_nothing(self):
        for number in SIGNALS:
            window = self.open()
            window.process.send_signal(number)
            _, said = window.process.communicate(timeout=support.PATIENCE)
            self.assertEqual(window.process.returncode, -number, said)
            self.assertEqual(said.splitlines()[-1], "rakelight: ended by a signal")
            window.end()

    def test_what_was_written_before_is_whole(self):
        window = self.open()
        shot = window.screenshot()
        window.key("F9")
        wait_for(lambda: list(self.folder.glob("*-turn*/0003.png")), "nothing was recorded")
        window.process.send_signal(signal.SIGTERM)
        window.process.communicate(timeout=support.PATIENCE)
        for picture in (shot, *self.folder.glob("*-turn*/*.png")):
            support.png(picture)
        self.assertEqual(self.temporary_files(), [])


if __name__ == "__main__":
    support.sys.exit(support.main())
