#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A small version of each entry of docs/reproduction.md: the numbers of its claim, from small pictures, within tools/reproduction/ranges.py. No times.

  reproduction_test.py PROGRAM [unittest arguments]"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import reproduce  # noqa: E402
from reproduction import pending  # noqa: E402
from reproduction.kit import Kit  # noqa: E402
from reproduction.ranges import ORDERS, RANGES  # noqa: E402

PROGRAM = ""
SCALE = 0.3


class Claims(unittest.TestCase):
    """One test for each entry, added below."""

    def hold(self, entry):
        with tempfile.TemporaryDirectory() as folder:
            kit = Kit(PROGRAM, folder, SCALE)
            why = pending.lacks(kit, entry.name)
            if why:
                self.skipTest(why)
            self.assertEqual(reproduce.faults(entry.name, entry.measure(kit)), [])


for _entry in reproduce.ENTRIES.values():
    setattr(Claims, "test_" + _entry.name.replace("-", "_"), lambda self, entry=_entry: self.hold(entry))


class Book(unittest.TestCase):
    def setUp(self):
        self.page = (ROOT / "docs/reproduction.md").read_text()

    def test_every_entry_has_its_heading_its_command_and_its_numbers(self):
        for name, entry in reproduce.ENTRIES.items():
            found = re.search(rf"^### {re.escape(name)}\b.*?(?=^##|\Z)", self.page, re.M | re.S)
            self.assertTrue(found, name)
            self.assertIn(f"reproduce.py {name}", found.group(), name)
            shown = dict(re.findall(r"^\| (.+) \| (-?[\d.e-]+) \| .+ \|$", found.group(), re.M))
            self.assertEqual(reproduce.faults(name, {what: float(value) for what, value in shown.items()}), [])
            self.assertRegex(found.group(), r"\*\*(Held|Held in part|Did not hold)", name)
            if entry.draw:
                self.assertIn(f"images/reproduction/{name}.png", found.group(), name)

    def test_the_page_has_no_entry_that_is_not_made(self):
        self.assertEqual(set(re.findall(r"^### (s\d-[\w-]+)", self.page, re.M)), set(reproduce.ENTRIES))

    def test_ranges_are_those_of_the_entries_and_leave_something_out(self):
        self.assertEqual(set(RANGES), set(reproduce.ENTRIES))
        for name, ranges in RANGES.items():
            for what, (low, high) in ranges.items():
                self.assertTrue(low <= high and (low > 0 or high < float("inf")), f"{name}: {what}")

    def test_numbers_outside_of_their_range_and_without_one_are_faults(self):
        right = {"pixels of the wall, parallax over none": 1, "with --bump-silhouette over without": 0.9}
        self.assertEqual(reproduce.faults("s3-border", right), [])
        self.assertIn("1, not 0 to 0.999", reproduce.faults("s3-border", {**right, "with --bump-silhouette over without": 1})[0])
        self.assertIn("no range", reproduce.faults("s3-border", {**right, "more": 1})[0])
        self.assertIn("not measured", reproduce.faults("s3-border", {"with --bump-silhouette over without": 0.9})[0])


    def test_numbers_in_the_wrong_order_are_faults(self):
        right = {what: (low + min(high, 3 * low + 1)) / 2 for what, (low, high) in RANGES["s3-fig13"].items()}
        pairs = ORDERS["s3-fig13"]
        for mild, strong in pairs:
            right[mild], right[strong] = 3, 6
        self.assertEqual(reproduce.faults("s3-fig13", right), [])
        found = reproduce.faults("s3-fig13", {**right, pairs[1][0]: 6})
        self.assertEqual(found, [f"s3-fig13: {pairs[1][0]}: 6, not below 6 of {pairs[1][1]}"])

    def test_orders_are_of_numbers_that_have_ranges(self):
        for name, pairs in ORDERS.items():
            self.assertLessEqual({what for pair in pairs for what in pair}, set(RANGES[name]), name)


class Command(unittest.TestCase):
    def run_tool(self, *words):
        return subprocess.run([sys.executable, ROOT / "tools/reproduce.py", "--program", PROGRAM, *map(str, words)], capture_output=True, text=True)

    def test_a_name_makes_picture_and_numbers(self):
        with tempfile.TemporaryDirectory() as folder:
            done = self.run_tool("s1-large-face", "--out", folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(sorted(p.name for p in pathlib.Path(folder).iterdir()), ["numbers.json", "s1-large-face.png"])
            self.assertIn("spot light, phong: middle minus side", done.stdout)

    def test_an_unknown_name_is_refused(self):
        done = self.run_tool("s9")
        self.assertEqual((done.returncode, done.stderr), (1, "reproduce: no entry begins with 's9'; --list shows them\n"))

    def test_a_claim_that_fails_gives_exit_code_1(self):
        entry = reproduce.ENTRIES["s3-fig11"]
        self.assertNotEqual(reproduce.faults(entry.name, {"objects": 5, "teapot with a map and --bump none vs. no map [% of pixels]": 0}), [])


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
