# SPDX-License-Identifier: Apache-2.0
"""Cameras."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import UsageError
from ._numbers import numbers

Vector = Union[Sequence[float], "NDArray[np.floating[Any]]"]

SIDES = ("front", "back", "left", "right", "top", "bottom", "isometric", "default", "file")


@dataclass(frozen=True)
class Camera:
    """A camera that stands at ``position`` and looks at ``target``; right-handed world, +Y up. Cameras with the same numbers are equal.

    Args:
        position: [m] world
        target: [m] world; what it looks at
        up: which way is up in the picture, any length; None: as in the world
        vertical_fov: [degrees] 0 to 180; None: 40, or what ``horizontal_fov`` gives
        horizontal_fov: [degrees]; with both, pixels need not be square
        near, far: [m] nothing nearer, nothing farther is drawn; None: about the model
        orthographic: parallel projection that shows what the perspective one shows at the target
    """

    position: Vector
    target: Vector = (0.0, 0.0, 0.0)
    up: Vector | None = None
    vertical_fov: float | None = None
    horizontal_fov: float | None = None
    near: float | None = None
    far: float | None = None
    orthographic: bool = False

    def __post_init__(self) -> None:
        put = object.__setattr__  # as the class is frozen
        for name in ("position", "target", "up"):
            if name != "up" or self.up is not None:
                put(self, name, numbers(name, getattr(self, name)))
        for name in ("vertical_fov", "horizontal_fov", "near", "far"):
            value = getattr(self, name)
            if value is not None:
                put(self, name, numbers(name, [value])[0])

    @classmethod
    def from_matrix(cls, to_world: ArrayLike, *, distance: float = 1.0, **others: Any) -> Camera:
        """A camera by its matrix [4, 4], camera to world, that looks along its -Z with +Y up (OpenGL, glTF, Blender).

        ``distance`` [m] is where the target lies: of parallel projection it says how much is seen.
        """
        m = np.asarray(to_world, dtype=np.float64)
        if m.shape != (4, 4) or not np.isfinite(m).all():
            raise UsageError(f"to_world: a finite matrix of shape (4, 4) is expected, not {m.shape}")
        position = m[:3, 3]
        return cls(tuple(position), tuple(position - distance * m[:3, 2]), tuple(m[:3, 1]), **others)

    @classmethod
    def orbit(cls, azimuth: float, elevation: float, distance: float, target: Vector = (0.0, 0.0, 0.0), **others: Any) -> Camera:
        """A camera on a sphere about ``target``: azimuth [degrees] from +Z towards +X, elevation [degrees] from the ground, distance [m]."""
        a, e = np.radians(azimuth), np.radians(elevation)
        direction = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
        return cls(tuple(np.asarray(target, dtype=np.float64) + distance * direction), target, **others)

    def settings(self) -> dict[str, Any]:
        """The program's settings that place this camera."""
        return {
            "camera_position": self.position,
            "camera_focal_point": self.target,
            "camera_view_up": self.up,
            "camera_view_angle": self.vertical_fov,
            "camera_horizontal_angle": self.horizontal_fov,
            "near": self.near,
            "far": self.far,
            "camera_orthographic": self.orthographic or None,
        }


CameraLike = Union[Camera, str, int, None]
"""A Camera; a side (``"front"``, ``"isometric"``, ...); the name or number of a camera of the file; None: the file's first, or one that
shows all of the model."""


def camera_settings(camera: CameraLike) -> dict[str, Any]:
    if camera is None:
        return {}
    if isinstance(camera, Camera):
        return camera.settings()
    if isinstance(camera, str) and camera in SIDES:
        return {"view": camera}
    if isinstance(camera, (str, int, np.integer)) and not isinstance(camera, bool):
        return {"camera_index": str(camera)}
    raise UsageError(f"camera: a Camera, a side, or a camera of the file is expected, not {type(camera).__name__}")
