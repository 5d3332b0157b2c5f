# SPDX-License-Identifier: Apache-2.0
"""What all calls share: threads, progress, remarks, and settings as words."""
from __future__ import annotations

import importlib
import inspect
import os
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple, Union

from . import _core
from ._errors import RakelightWarning, UsageError, usage_error
from ._numbers import whole

Progress = Union[bool, None, Callable[[str, float], None]]
"""None: nothing is shown. True: a bar by tqdm, where it is installed. A function: called with a stage and how far it is, 0 to 1."""

Path = Union[str, "os.PathLike[str]"]

_threads = 0


class Remark(NamedTuple):
    """What was changed, guessed or dropped, or is to be known."""

    kind: str
    """"note", "changed", "guessed", "dropped" or "warning"."""
    file: str
    place: str
    message: str
    times: int
    """How often."""


def set_threads(count: int) -> None:
    """Sets how many threads each later call uses; 0 (the default): all processors. Results do not depend on it."""
    global _threads
    _threads = whole("threads", count, 0, 1024)


def threads() -> int:
    return _threads


@contextmanager
def told(progress: Progress) -> Iterator[Callable[[str, float], None] | None]:
    """The function that the extension calls."""
    if progress is None or progress is False:
        yield None
    elif progress is not True:
        if not callable(progress):
            raise UsageError(f"progress: True or a function is expected, not {type(progress).__name__}")
        yield progress
    else:
        try:
            tqdm = importlib.import_module("tqdm.auto").tqdm
        except ImportError:
            yield None
            return
        with tqdm(total=100, unit="%", leave=False) as bar:

            def tell(stage: str, fraction: float) -> None:
                bar.set_description(stage)
                bar.n = round(100 * fraction)
                bar.refresh()

            yield tell


def remarks_of(rows: list[tuple[str, str, str, str, int]]) -> list[Remark]:
    """Remarks that are no notes become warnings."""
    remarks = [Remark(*row) for row in rows]
    level, frame = 1, inspect.currentframe()
    while frame is not None and frame.f_globals.get("__package__") == __package__:  # the caller's line is what is shown
        level, frame = level + 1, frame.f_back
    for remark in remarks:
        if remark.kind != "note":
            where = ": ".join(part for part in (remark.file, remark.place) if part)
            warnings.warn(f"{where}: {remark.message}" if where else remark.message, RakelightWarning, stacklevel=level)
    return remarks


def name_of(path: Path) -> bytes:
    """A file's name as the system has it. Bytes are refused: they are more likely a file's content."""
    if not isinstance(path, (str, os.PathLike)):
        raise UsageError(f"a file's name is expected, not {type(path).__name__}")
    return os.fsencode(path)


def _word(key: str, value: Any) -> str:
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return ",".join(_word(key, part) for part in value)
    if isinstance(value, (int, float)):
        return repr(value)
    raise UsageError(f"{key}: {type(value).__name__} is no value of a setting")


_lists: dict[str, bool] = _core.setting_keys()

_other_names = {"background-color": "background", "coloring-array": "scalars"}
"""That the program's options have."""

_elsewhere = {
    "threads": "use set_threads()",
    "output": "use render_file() or Picture.save()",
    "allow-outside": "it is an argument of load()",
    "allow-shaders": "it is an argument of load()",
    "max-memory": "it is an argument of load() and of Session",
    "turntable": "draw the frames with Session and Camera.orbit()",
    "frames": "draw each frame with animation_time",
    "movie": "draw the frames and join them with another program",
    "ref": "compare the arrays",
    "json": "render_file() and inspect() return dictionaries",
}
"""Options of the program that are no settings here, and what does the same."""

_of_the_program = (
    "as-one config format fps keep-frames keep-partial quiet recursive ref-diff ref-measure ref-threshold skip-existing stats verbose watch"
).split()


def quoted(text: str, most: int = 40) -> str:
    """'text' for a message of one line, cut to ``most`` characters."""
    return "'" + "".join(c if c.isprintable() else "?" for c in text[:most]) + "'"


def suggestion(name: str, names: Iterable[str], otherwise: str = "") -> str:
    """Names the word that was meant, in the spelling of ``names``."""
    nearest = _core.nearest_word(name, list(names))
    return f"did you mean {quoted(nearest)}?" if nearest else otherwise


def _check_key(name: str, key: str) -> None:
    if key in _lists:
        return
    if key in _elsewhere or key in _of_the_program:
        raise usage_error(name, "is an option of the program, not of Python", _elsewhere.get(key, ""))
    known = [key.replace("-", "_") for key in _lists]
    raise UsageError("; ".join(filter(None, [f"there is no setting {quoted(name)}", suggestion(name, known)])))


def settings_of(settings: Mapping[str, Any]) -> list[tuple[str, list[str]]]:
    """Keyword arguments as settings: ``crease_angle=40`` is the program's ``--crease-angle 40``; None leaves a setting out."""
    out = []
    for name, value in settings.items():
        key = name.replace("_", "-")
        key = _other_names.get(key, key)
        _check_key(name, key)
        if value is None:
            continue
        several = _lists.get(key, False) and isinstance(value, (list, tuple))
        out.append((key, [_word(name, part) for part in value] if several else [_word(name, value)]))
    return out
