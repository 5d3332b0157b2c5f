# SPDX-License-Identifier: Apache-2.0
"""Numbers of arguments."""
from __future__ import annotations

import operator
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


def number(name: str, value: Any) -> float:
    """One as float.

    Raises:
        UsageError: with the argument's name
    """
    return numbers(name, [value])[0]


def whole(name: str, value: Any, low: int | None = None, high: int | None = None) -> int:
    """One as int, in low..high. 1.5 and "1" are refused.

    Raises:
        UsageError: with the argument's name
    """
    try:
        given = operator.index(value)
    except TypeError:
        raise UsageError(f"{name}: a whole number is expected, not {value!r:.60}") from None
    if (low is not None and given < low) or (high is not None and given > high):
        raise UsageError(f"{name}: must be {low} " + ("or more" if high is None else f"to {high}") + f", not {str(given):.40}")
    return given


MAX_MEMORY = 2**63
"""[bytes]"""
