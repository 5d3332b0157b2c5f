#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The progress line on a pseudo terminal: phase, file, time; nothing of it anywhere else.

  progress_test.py PROGRAM [unittest arguments]"""
import fcntl
import os
import pathlib
import pty
import re
import select
import struct
import subprocess
import sys
import termios
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

# Enough work for a line to be seen on any machine.
WORK = ("--engine", "trace", "--method", "path", "--samples", "4096", "--resolution", "320,240", "--threads", "1")


class Progress(program.Case):
    def on_terminal(self, *arguments, until=None, seconds=60, term="xterm", columns=100, **environment):
        """What stands on a terminal when something is there, when the program ends, or at the latest after a while."""
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        running = subprocess.Popen([program.PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=slave, env={**os.environ, "TERM": term, **environment})
        os.close(slave)
        text, last = "", time.monotonic() + seconds
        while time.monotonic() < last and not (until and re.search(until, text)):
            if not select.select([master], [], [], 0.1)[0]:
                continue
            try:
                text += os.read(master, 4096).decode()
            except OSError:  # the program has ended
                break
        running.kill()
        running.wait()
        return text

    def lines(self, text):
        """Those that were written one over the other, but for the last, which may not be whole."""
        return text.split("\r\033[K")[1:-1]

    def test_the_line_says_phase_and_time_and_is_rewritten(self):
        text = self.on_terminal("render", "builtin:teapot", "-o", "a.png", *WORK, until=r"(render.*){3}")
        self.assertGreater(len(self.lines(text)), 1)
        for line in self.lines(text):
            self.assertRegex(line, r"^builtin:teapot: (begin|load|prepare|render)( \d+ %)?, \d+ s")
            self.assertNotIn("\n", line)
            self.assertNotIn("\033", line)

    def test_a_long_picture_says_how_long_it_takes(self):
        expected = r"render \d+ %, \d+ s, about \d+ (s|min|h) left"
        self.assertRegex(self.on_terminal("render", "builtin:teapot", "-o", "a.png", *WORK, until=expected), expected)

    def test_files_are_counted(self):
        self.write("first.obj"), self.write("second.obj")
        text = self.on_terminal("render", "first.obj", "second.obj", "-o", "{model}.png", *WORK, until=r"first.*\r")
        self.assertTrue(self.lines(text)[0].startswith("[1/2] first.obj: "), text)

    def test_a_long_path_leaves_room_for_the_rest(self):
        (self.folder / ("folder" * 10)).mkdir()
        self.write("folder" * 10 + "/first.obj")
        text = self.on_terminal("render", "folder" * 10 + "/first.obj", "-o", "a.png", *WORK, until=r"render.*\r")
        self.assertRegex(self.lines(text)[0], r"^first\.obj: ")

    def test_narrow_terminals_get_one_line(self):
        text = self.on_terminal("render", "builtin:teapot", "-o", "a.png", *WORK, columns=20, until=r"(teapot.*){3}")
        self.assertTrue(self.lines(text))
        self.assertTrue(all(len(line) < 20 for line in self.lines(text)), text)

    def test_every_verb_shows_it(self):
        for verb in (("compare", "--engines", "trace,trace", "builtin:teapot", *WORK[2:]),
                     ("bench", "smooth", "--triangles", "3000000", "--repetitions", "50")):
            with self.subTest(verb=verb[0]):
                self.assertIn(": ", self.on_terminal(*verb, until=r": .*, \d+ s"))

    def test_it_is_silent_where_it_may_not_be_seen(self):
        for words, term in ((("--quiet",), "xterm"), ((), "dumb")):
            self.assertEqual(self.on_terminal("render", "builtin:teapot", "-o", "a.png", *WORK, *words, term=term, seconds=2), "")
        piped = self.run_program("render", "builtin:teapot", "-o", "a.png", *WORK[:4], "--samples", "16", "--resolution", "160,120")
        self.assertEqual((piped.code, piped.err), (0, ""))

    def test_it_leaves_nothing_behind_and_has_no_colors(self):
        text = self.on_terminal("render", "builtin:teapot", "-o", "a.png", *WORK[:4], "--samples", "64", "--resolution", "320,240", NO_COLOR="1")
        self.assertNotRegex(text, r"\033\[[0-9;]*m")
        self.assertTrue(text == "" or text.endswith("\r\033[K"), repr(text[-80:]))
        self.assertTrue((self.folder / "a.png").exists())


if __name__ == "__main__":
    program.main()
