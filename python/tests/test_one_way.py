# SPDX-License-Identifier: Apache-2.0
"""A picture is the same to the bit by Python as by the program, for every key: the table of tests/one_way/settings.json."""
import json

import numpy as np
import pytest
from conftest import DATA

import rakelight

ROOT = DATA.parent
TABLE = json.loads((ROOT / "tests" / "one_way" / "settings.json").read_text())
MODEL = ROOT / "tests" / "one_way" / "moving.glb"
ELSEWHERE = {"window": "an argument of render()", "channels": "an argument of render()", "channel-files": "of files", "exr-colors": "of files"}
TAKES_FILES = ("vertex-shader", "height-map", "texture-base-color", "texture-normal", "hdri-file")


def settings_of(name):
    row = TABLE["keys"][name]
    values = {key: words for key, words in TABLE["base"].items() if key not in row.get("without", ())}
    values |= row.get("with", {}) | {name.split(" ")[0]: row["words"]}
    return {key: [str(ROOT / word) for word in words] if key in TAKES_FILES else words for key, words in values.items()}


def options_of(values):
    """Of the program: a flag stands alone."""
    words = []
    for key, value in values.items():
        for word in value:
            words += [f"--{key}"] if word == "on" else [f"--{key}", word]
    return words


@pytest.mark.parametrize("name", [n for n, row in TABLE["keys"].items() if row.get("needs") != "gl" and n.split(" ")[0] not in ELSEWHERE])
def test_the_picture_is_the_program_s(program, name):
    row, values = TABLE["keys"][name], settings_of(name)
    if row.get("needs") and row["needs"] not in rakelight.build_info()["engines"]:
        pytest.skip(f"there is no engine {row['needs']}")
    if "python" in row.get("differs", {}):
        pytest.skip(row["differs"]["python"])
    for moment in ("0", "0.5", "1"):
        moved = values if "animation-time" in values else values | {"animation-time": [moment]}
        keywords = {key.replace("-", "_"): words if len(words) > 1 else words[0] == "on" or words[0] for key, words in moved.items()}
        image = rakelight.render(MODEL, **keywords)["image"]
        np.testing.assert_array_equal(image, program.image(MODEL, *options_of(moved)), err_msg=f"{name} at {moment} s")
