#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vcpkg.json, the conda recipe, the workflows and the action: their form (schemas.json holds the parts of the formats that we use), their agreement with the
project, and their shell steps as far as they run without a network. recipes_test.py PROGRAM [unittest arguments]

Needs Debian's python3-yaml and python3-jsonschema; exit code 77 (skipped) without them."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

SYSTEM = "/usr/bin/python3"
try:
    import jsonschema
    import yaml
except ImportError:
    if os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    print("skipped: python3-yaml and python3-jsonschema are not there")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCHEMAS = json.loads((pathlib.Path(__file__).parent / "schemas.json").read_text())
ACTION = ROOT / ".github/actions/check"
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))


def load(path):
    """YAML, where `on:` is a key and not the truth."""
    data = yaml.safe_load(path.read_text())
    return {"on" if key is True else key: {} if value is None else value for key, value in data.items()}


def recipe():
    """The conda recipe with what its templates stand for."""
    text = (ROOT / "packages/conda/meta.yaml").read_text()
    for name, value in re.findall(r'\{% set (\w+) = "([^"]*)" %\}', text):
        text = re.sub(r"\{\{ *" + name + r" *\}\}", f'"{value}"', text)
    text = re.sub(r"\{\{ *compiler\('cxx'\) *\}\}", "gxx_linux-64", re.sub(r"\{%.*?%\}", "", text))
    return yaml.safe_load(text)


def steps():
    """(place, step, whether it is the action's)"""
    for path in WORKFLOWS:
        for name, job in load(path)["jobs"].items():
            for step in job["steps"]:
                yield f"{path.name}: {name}", step, False
    for step in load(ACTION / "action.yml")["runs"]["steps"]:
        yield "action", step, True


def version():
    return re.search(r"project\(rakelight VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class Form(unittest.TestCase):
    def test_files_keep_to_their_schemas(self):
        for kind, data in [("vcpkg", json.loads((ROOT / "vcpkg.json").read_text())), ("recipe", recipe()), ("action", load(ACTION / "action.yml")), *(("workflow", load(path)) for path in WORKFLOWS)]:
            with self.subTest(kind=kind):
                jsonschema.Draft202012Validator(SCHEMAS[kind]).validate({key: value if key != "on" else {event: how or {} for event, how in value.items()} for key, value in data.items()})

    def test_schemas_refuse_what_is_wrong(self):
        wrong = json.loads((ROOT / "vcpkg.json").read_text()) | {"dependancies": []}
        self.assertFalse(jsonschema.Draft202012Validator(SCHEMAS["vcpkg"]).is_valid(wrong))
        broken = load(ACTION / "action.yml")
        del broken["runs"]["steps"][0]["shell"]
        self.assertFalse(jsonschema.Draft202012Validator(SCHEMAS["action"]).is_valid(broken))

    def test_versions_and_options_are_those_of_the_project(self):
        self.assertEqual(json.loads((ROOT / "vcpkg.json").read_text())["version-semver"], version())
        self.assertEqual(recipe()["package"]["version"], version())
        known = set(re.findall(r"option\((RAKELIGHT_[A-Z]+)", (ROOT / "cmake/RakelightOptions.cmake").read_text()))
        used = set(re.findall(r"RAKELIGHT_[A-Z]+", (ROOT / "vcpkg.json").read_text() + (ROOT / "packages/conda/meta.yaml").read_text()))
        self.assertTrue(used and used <= known, used - known)

    def test_both_recipes_name_the_same_libraries(self):
        def names(words):
            return {re.split(r" |-devel", word)[0].replace("_", "-") for word in words}
        vcpkg = json.loads((ROOT / "vcpkg.json").read_text())
        wanted = list(vcpkg["dependencies"]) + [name for feature in vcpkg["default-features"] for name in vcpkg["features"][feature]["dependencies"]]
        wanted = {"embree" if name == "embree3" else name for name in (entry if isinstance(entry, str) else entry["name"] for entry in wanted)}
        self.assertEqual(names(recipe()["requirements"]["host"]), wanted)
        required = re.findall(r"pkg_check_modules\(\w+ REQUIRED IMPORTED_TARGET(?: GLOBAL)? (\w+)\)", (ROOT / "src/io/CMakeLists.txt").read_text())
        self.assertIn("expat", required)
        self.assertEqual({name.removeprefix("lib") for name in required} - {name.removeprefix("lib") for name in wanted}, set())

    def test_steps_are_shell_and_inputs_reach_them_by_the_environment(self):
        for place, step, _ in steps():
            if "run" in step:
                with self.subTest(place=place, run=step["run"]):
                    subprocess.run(["bash", "-n"], input=step["run"], text=True, check=True)
                    self.assertNotIn("${{", step["run"])
                    for script in re.findall(r"(?:^|\s)\./([\w./]+)", step["run"]):
                        self.assertTrue(os.access(ROOT / script, os.X_OK), script)
            elif step["uses"].startswith("./"):
                self.assertTrue((ROOT / step["uses"] / "action.yml").exists())
                self.assertLessEqual(set(step["with"]), set(load(ROOT / step["uses"] / "action.yml")["inputs"]))


class Action(unittest.TestCase):
    """The action's steps as a runner runs them: inputs put into `env`, then `run` by bash."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "models/in side").mkdir(parents=True)
        spot = (ROOT / "data/spot/spot_slab5.glb").read_bytes()
        (self.folder / "models/in side/spot 5.glb").write_bytes(spot)
        (self.folder / "models/broken.glb").write_bytes(spot[:1000])
        subprocess.run([PROGRAM, "smooth", "models/in side/spot 5.glb", "-o", "models/whole.glb", "--quiet"], cwd=self.folder, check=True)

    def run_action(self, **given):
        action = load(ACTION / "action.yml")
        inputs = {name: entry.get("default", "") for name, entry in action["inputs"].items()} | {"program": str(PROGRAM)} | given
        step = next(step for step in action["runs"]["steps"] if step.get("id") == "check")
        values = {key: re.sub(r"\$\{\{ inputs\.([\w-]+) \}\}", lambda match: inputs[match[1]], value) for key, value in step["env"].items()}
        output = self.folder / "output"
        output.write_text("")
        done = subprocess.run(["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", "-c", step["run"]], cwd=self.folder, capture_output=True, text=True,
                              env=os.environ | values | {"GITHUB_ACTION_PATH": str(ACTION), "GITHUB_OUTPUT": str(output)})
        self.assertEqual(output.read_text(), f"exit-code={done.returncode}\n")
        return done, inputs["report"]

    def failures(self, report):
        return {case.get("name"): case.find("failure") is not None or case.find("error") is not None
                for case in xml.etree.ElementTree.parse(self.folder / report).getroot().iter("testcase")}

    def test_a_model_without_seams_passes(self):
        done, report = self.run_action(models="models/whole.glb\n", page="page.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(False, self.failures(report).values())
        self.assertIn("</html>", (self.folder / "page.html").read_text())

    def test_a_seam_ends_with_5_an_annotation_and_a_failure_in_the_report(self):
        done, report = self.run_action(models="models/**/spot*.glb", limits="--max-seam 2 --no-degenerate", report="out/checks.xml")
        self.assertEqual(done.returncode, 5)
        self.assertRegex(done.stdout + done.stderr, r"::error title=rakelight::models/in side/spot 5\.glb: max-seam: seam of 30\.26")
        self.assertEqual(self.failures(report), {"load": False, "max-seam": True, "no-degenerate": False})

    def test_a_broken_model_ends_with_4_and_a_missing_one_with_3(self):
        self.assertEqual(self.run_action(models="models/whole.glb\nmodels/broken.glb")[0].returncode, 4)
        done, _ = self.run_action(models="models/none*.glb")
        self.assertEqual(done.returncode, 3)
        self.assertIn("no model matches 'models/none*.glb'", done.stdout)

    def test_inputs_are_no_shell_text(self):
        done, _ = self.run_action(models="models/whole.glb", limits="--max-seam 1; touch gone")
        self.assertEqual(done.returncode, 2)
        self.assertFalse((self.folder / "gone").exists())


if __name__ == "__main__":
    PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
