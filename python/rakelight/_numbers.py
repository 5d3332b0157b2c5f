# SPDX-License-Identifier: Apache-2.0
"""Numbers of arguments."""
from __future__ import annotations

from typing import Any

from ._errors import UsageError


def numbers(name: str, values: Any) -> tuple[float, ...]:
    """All as float. Text is refused: "123" is not three numbers.

    Raises:
        UsageError: with the argument's name
    """
    try:
        if isinstance(values, (str, bytes)):
            raise TypeError
        given = list(values)
        if any(isinstance(value, (str, bytes)) for value in given):
            raise TypeError
        return tuple(float(value) for value in given)
    except (TypeError, ValueError, OverflowError):
        raise UsageError(f"{name}: numbers are expected, not {values!r:.60}") from None
