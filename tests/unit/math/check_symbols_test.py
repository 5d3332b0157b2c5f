#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The symbol check finds what it is there for, and nothing else. Usage: check_symbols_test.py TOOLS_FOLDER"""
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop())
import check_symbols  # noqa: E402


class CheckSymbols(unittest.TestCase):
    def test_finds_elementary_functions_of_libm(self):
        text = "scene.o:\n                 U sinf\n                 U pow@GLIBC_2.29\n                 U __exp_finite\n                 U sqrt\n                 U floorf\n"
        self.assertEqual(check_symbols.libm_calls(text), ["__exp_finite", "pow", "sinf"])

    def test_own_functions_of_these_names_are_not_libm(self):
        text = "0000000000000000 T sin\n                 U _ZN9rakelight4math3sinEd\n                 U mpfr_sin\n"
        self.assertEqual(check_symbols.libm_calls(text), [])

    def test_finds_weak_symbols_without_their_flavour(self):
        text = ("0000000000000000 W std::vector<float>::push_back(float const&)\n"
                "0000000000000000 W xsimd::kernel::add(xsimd::avx2)\n"
                "0000000000000000 V rakelight::table\n"
                "0000000000000000 T shade_avx2(float)\n")
        self.assertEqual(len(check_symbols.nameless_symbols(text, "avx2")), 4)

    def test_a_flavour_of_another_object_is_no_excuse(self):
        text = "0000000000000000 W rakelight::raster::avx2::shade(float)\n"
        self.assertEqual(len(check_symbols.nameless_symbols(text, "avx512")), 1)
        self.assertEqual(check_symbols.nameless_symbols(text, "avx2"), [])

    def test_named_local_undefined_and_instrumentation_symbols_pass(self):
        text = ("0000000000000000 W rakelight::lighting::sse2::phong_lobe(float, float)\n"
                "0000000000000000 W xsimd_sse2::kernel::add(int)\n"
                "0000000000000000 t helper(float)\n"
                "                 U memcpy\n"
                "0000000000000000 B __odr_asan.table\n")
        self.assertEqual(check_symbols.nameless_symbols(text, "sse2"), [])

    def test_what_is_not_built_is_no_symbol_fault(self):
        with tempfile.TemporaryDirectory() as folder:
            built, names = os.path.join(folder, "built here.o"), os.path.join(folder, "list.txt")
            with open(built, "wb"):
                pass
            lines = [f"module {built}", f"isa avx2 {built}", f"isa sse2 {folder}/not here.o"]
            self.assertEqual(check_symbols.not_built(lines), [f"{folder}/not here.o"])
            with open(names, "w", encoding="utf-8") as file:
                file.write("\n".join(lines))
            done = subprocess.run([sys.executable, check_symbols.__file__, names], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn("1 of 3 files are not built yet", done.stderr)
            self.assertIn("build all targets", done.stderr)


if __name__ == "__main__":
    unittest.main()
