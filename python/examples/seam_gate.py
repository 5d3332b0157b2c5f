#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A gate for CI: fails where parts of a model meet with seams, says where, and writes the repaired model where it is asked to.

    python3 seam_gate.py assets/*.glb --max-seam 1 --repair fixed
"""
import argparse
import pathlib
import sys

import rakelight


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", type=pathlib.Path)
    parser.add_argument("--max-seam", type=float, default=1.0, help="[degrees]")
    parser.add_argument("--repair", type=pathlib.Path, metavar="FOLDER", help="write models that fail here, without their seams")
    arguments = parser.parse_args()
    failed = 0
    for model in arguments.models:
        try:
            found = rakelight.inspect(rakelight.load(model), surfaces=False, check={"max_seam": arguments.max_seam})
        except rakelight.Error as error:
            print(f"FAIL  {error}")
            failed += 1
            continue
        if found["check"]["passed"]:
            print(f"ok    {model}")
            continue
        failed += 1
        for failure in found["check"]["failures"]:
            print(f"FAIL  {model}: {failure['message']}")
        if arguments.repair:
            arguments.repair.mkdir(parents=True, exist_ok=True)
            rakelight.smooth_file(model, arguments.repair / model.name)
            print(f"      repaired: {arguments.repair / model.name}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
