# SPDX-License-Identifier: Apache-2.0
"""Pictures as dictionaries of arrays."""
from __future__ import annotations

import copy
import io
import os
import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import UsageError, file_error
from ._run import Path, name_of

NONE = 0xFFFFFFFF
"""In the channels ``object``, ``material``, ``mesh`` and ``triangle``: there is nothing at the pixel."""


def _png(image: NDArray[np.uint8]) -> bytes:
    """PNG (third edition), 8 bits, color type 2 or 6."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width, channels = image.shape
    rows = np.zeros((height, 1 + width * channels), dtype=np.uint8)  # each row begins with its filter: none
    rows[:, 1:] = image.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b"")


class Picture(dict[str, "NDArray[Any]"]):
    """What was drawn: {channel: array}, row 0 on top. It shows itself in Jupyter.

    Attributes:
        to_world: [4, 4] float64, the camera's matrix: camera to world, it looks along its -Z, +Y up
        intrinsics: [3, 3] float64, pixels of points in the camera's axes with y down and z ahead; None: parallel projection
        near, far: [m] between which it sees
    """

    to_world: NDArray[np.float64]
    intrinsics: NDArray[np.float64] | None
    near: float
    far: float

    def __init__(self, drawn: dict[str, Any]) -> None:
        camera = drawn.pop("camera")
        super().__init__(drawn)
        self.to_world, self.intrinsics = camera["to_world"], camera["intrinsics"]
        self.near, self.far = camera["near"], camera["far"]

    def copy(self) -> Picture:
        """The same channels and camera; as of any dictionary, the arrays are shared. ``copy.deepcopy`` copies them, too."""
        return copy.copy(self)

    def png(self) -> bytes:
        """The channel ``image`` as the bytes of a PNG file."""
        if "image" not in self:
            raise UsageError("the picture has no channel 'image'")
        return _png(self["image"])

    def _repr_png_(self) -> bytes | None:
        return self.png() if "image" in self else None

    def _npz(self) -> bytes:
        camera = {"to_world": self.to_world}
        if self.intrinsics is not None:
            camera["intrinsics"] = self.intrinsics
        file = io.BytesIO()
        np.savez_compressed(file, **self, **camera)
        return file.getvalue()

    def save(self, path: Path) -> None:
        """Writes ``image`` as .png, or all channels with the camera as .npz, and makes the folder. Other formats:
        :func:`rakelight.render_file`."""
        name = os.fsdecode(name_of(path))
        ending = os.path.splitext(name)[1].lower()
        if ending not in (".png", ".npz"):
            raise UsageError(f"a picture is saved as .png or .npz, not as '{ending}'")
        data = self.png() if ending == ".png" else self._npz()
        try:
            os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
            with open(name, "wb") as file:
                file.write(data)
        except OSError as error:
            raise file_error(name, f"cannot be written: {error.strerror}") from None

    def __repr__(self) -> str:
        channels = (f"{name} {list(array.shape)} {array.dtype}" for name, array in self.items())
        return f"<rakelight.Picture {', '.join(channels)}>"
