#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""cmake/units.py: which sources may be compiled as one.   units_test.py FOLDER"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1) if len(sys.argv) > 1 else str(pathlib.Path(__file__).resolve().parents[3] / "cmake"))
import units  # noqa: E402

HEAD = "#include <string>\nnamespace rakelight {\nnamespace {\n"


class Units(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.count = 0

    def tearDown(self):
        self.folder.cleanup()

    def source(self, hidden, outside="", before=""):
        self.count += 1
        path = pathlib.Path(self.folder.name) / f"{self.count}.cpp"
        path.write_text(before + HEAD + hidden + "\n}  // namespace\n" + outside + "\n}  // namespace rakelight\n")
        return units.Source(str(path))

    def fit(self, a, b, outside="", before=""):
        first, second = self.source(a), self.source(b, outside, before)
        self.assertEqual(first.fits(second), second.fits(first))
        return len(units.units_of([first, second], 8)) == 1

    def test_names_that_are_defined_twice_keep_sources_apart(self):
        for a in ("int twice(int x) { return 2 * x; }", "constexpr double twice = 2;", "struct twice { int x; };", "enum class twice { no, yes };",
                  "using twice = int;", "using other::twice;", "template <class T>\nT twice(T x) { return x + x; }", "class twice final : public Base {};", "constexpr int once = 1, twice = 2;", "const char* const twice[] = {\"a\"};",
                  "std::vector<std::pair<int, double>> twice(int x,\n    double y) {\n  return {};\n}"):
            self.assertFalse(self.fit(a, "double twice(double x) { return 2 * x; }"), a)
            self.assertTrue(self.fit(a, "double thrice(double x) { return 3 * x; }"), a)

    def test_a_call_of_a_name_of_another_source_keeps_them_apart(self):
        better = "std::string counted(int n) { return {}; }"
        self.assertFalse(self.fit(better, "int other() { return 0; }", "void f() { counted(3); }"))
        self.assertFalse(self.fit("int x() { return 0; }\nstatic int hidden(int y) { return y; }", "int z() { return hidden(1); }"))

    def test_a_call_in_a_header_keeps_them_apart_too(self):
        (pathlib.Path(self.folder.name) / "base.h").write_text("inline int twice(int n) { return sum(n, n); }\nint other(int n);\n")
        (pathlib.Path(self.folder.name) / "above.h").write_text('#include "base.h"\n')
        includes = '#include "above.h"\n'
        self.assertFalse(self.fit("long sum(int a, int b) { return a + b; }", "int c = 2;", before=includes))
        self.assertTrue(self.fit("long other(long a) { return a; }", "int c = 2;", before=includes))

    def test_members_and_other_namespaces_text_and_comments_do_not_count(self):
        hidden = "int size(int n) { return n; }"
        for text in ("int f(const std::string& s) { return int(s.size()); }", "int f(const std::string* s) { return int(s->size()); }",
                     "int f() { return other::size(1); }", 'const char* text = "size(1)";', "// size(1)\nint g = 0;", 'const char* raw = R"(size(1))";'):
            self.assertTrue(self.fit(hidden, text), text)

    def test_a_variable_of_its_own_is_no_call_of_the_other(self):
        hidden = "int count(int n) { return n; }"
        for text in ("int f(int count) { return count; }", "int f() { const int count = 3; return count; }", "int f(const int& count) { return count; }",
                     "int f(S s) { auto [count, rest] = s; return count; }"):
            self.assertTrue(self.fit(hidden, text), text)
        for text in ("int f() { return count(3); }", "int f(bool a) { return a && count(3); }", "bool f(int a) { return a > count(3); }", "int f(int a) { return a & count(3); }"):
            self.assertFalse(self.fit(hidden, text), text)

    def test_declarations_to_use_the_same_name_agree(self):
        use, calls = "using other::taken;", "int f() { return taken(1); }"
        self.assertTrue(self.fit(use + "\nint a = 1;", use + "\nint b = 2;", calls))
        self.assertTrue(self.fit(use, "int b = 2;", "int f() { return third::taken(1); }"))
        self.assertFalse(self.fit(use, "using third::taken;", calls))
        self.assertFalse(self.fit(use, "int b = 2;", calls))
        self.assertTrue(self.fit("using Json = nlohmann::json;", "using Json = nlohmann::json;", "Json f();"))
        self.assertFalse(self.fit("using Json = nlohmann::json;", "using Json = nlohmann::ordered_json;", "Json f();"))

    def test_what_reaches_beyond_its_source_stays_alone(self):
        self.assertFalse(self.fit("int a = 1;", "int b = 2;", before="#define MANY 3\n"))
        self.assertFalse(self.fit("int a = 1;", "int b = 2;", before="using namespace std;\n"))

    def test_units_have_at_most_so_many_sources(self):
        sources = [self.source(f"int name_{n} = 0;") for n in range(7)]
        self.assertEqual([len(unit) for unit in units.units_of(sources, 3)], [3, 3])


if __name__ == "__main__":
    unittest.main()
