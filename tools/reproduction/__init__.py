# SPDX-License-Identifier: Apache-2.0
"""The figures, claims and tables of three publications, made again: docs/reproduction.md, `./dev reproduce`."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
