# SPDX-License-Identifier: Apache-2.0
"""Exceptions and warnings."""


class Error(Exception):
    """What the library says of bad input or of its surroundings, in one line: ``str(error)``.

    Attributes:
        reason: what is wrong, without file and place
        file: the file that it is about; empty: none
        place: where in the file: "line 12", "mesh 3 'body'"; may be empty
        advice: what to do; may be empty
        setting: the setting that it is about, as the program's options are named: "crease-angle"; may be empty
    """

    reason: str = ""
    file: str = ""
    place: str = ""
    advice: str = ""
    setting: str = ""


class UsageError(Error, ValueError):
    """An argument that cannot be: a wrong word, shape, type or number."""


def usage_error(setting: str, reason: str, advice: str = "") -> UsageError:
    """As the library's own: "setting: reason; advice"."""
    error = UsageError(f"{setting}: {reason}" + (f"; {advice}" if advice else ""))
    error.setting, error.reason, error.advice = setting, reason, advice
    return error


def file_error(file: str, reason: str) -> Error:
    """As the library's own: "file: reason"."""
    error = Error(f"{file}: {reason}")
    error.file, error.reason = file, reason
    return error


class NotFoundError(Error, FileNotFoundError):
    """A file that is not there or cannot be read."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class BadFileError(Error):
    """A file that is broken or of no known format, or a scene in which there is nothing to draw."""


class RakelightWarning(UserWarning):
    """What was changed, guessed or dropped on the way."""
