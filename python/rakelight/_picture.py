# SPDX-License-Identifier: Apache-2.0
"""Pictures as dictionaries of arrays."""
from __future__ import annotations

import copy
import os
import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import UsageError
from ._run import Path

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

    def save(self, path: Path) -> None:
        """Writes ``image`` as .png, or all channels with the camera as .npz. Other formats: :func:`rakelight.render_file`."""
        ending = os.path.splitext(os.fspath(path))[1].lower()
        if ending == ".png":
            with open(path, "wb") as file:
                file.write(self.png())
        elif ending == ".npz":
            camera = {"to_world": self.to_world}
            if self.intrinsics is not None:
                camera["intrinsics"] = self.intrinsics
            np.savez_compressed(path, **self, **camera)
        else:
            raise UsageError(f"a picture is saved as .png or .npz, not as '{ending}'")
