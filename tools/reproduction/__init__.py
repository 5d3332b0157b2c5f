# SPDX-License-Identifier: Apache-2.0
"""The figures, claims and tables of three publications, made again: docs/reproduction.md, `./dev reproduce`."""
