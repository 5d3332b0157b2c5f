# SPDX-License-Identifier: Apache-2.0
"""Cameras."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import UsageError, usage_error
from ._numbers import numbers
from ._run import quoted, suggestion

Vector = Union[Sequence[float], "NDArray[np.floating[Any]]"]

SIDES = ("front", "back", "left", "right", "top", "bottom", "isometric", "default", "file")


def _vector(name: str, values: Any) -> tuple[float, ...]:
    vector = numbers(name, values)
    if len(vector) != 3 or not np.isfinite(vector).all():
        raise UsageError(f"{name}: three finite numbers are expected, not {values!r:.60}")
    return vector


def _check_axes(axes: NDArray[np.float64]) -> None:
    """Refuses what is no rotation with a size. The bound lets float32 and six decimals pass."""
    if np.linalg.det(axes) < 0:
        raise UsageError("to_world: its axes are left-handed (determinant < 0), the picture would be mirrored; turn one of the first three columns around")
    lengths = np.linalg.norm(axes, axis=0)
    unit = axes / lengths
    if np.abs(unit.T @ unit - np.eye(3)).max() > 1e-4:
        raise UsageError("to_world: its axes, the first three columns, are not perpendicular to each other")
    if lengths.max() > lengths.min() * (1 + 1e-4):
        raise UsageError("to_world: its axes, the first three columns, have different lengths")


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
                put(self, name, _vector(name, getattr(self, name)))
        for name in ("vertical_fov", "horizontal_fov", "near", "far"):
            value = getattr(self, name)
            if value is not None:
                put(self, name, numbers(name, [value])[0])
        self._check()

    def _check(self) -> None:
        if self.up is not None and not any(self.up):
            raise UsageError("up: must not be 0, 0, 0")
        if self.position == self.target:
            raise UsageError("position and target are the same point")
        for name in ("vertical_fov", "horizontal_fov"):
            angle = getattr(self, name)
            if angle is not None and not 0 < angle < 180:
                raise UsageError(f"{name}: must be more than 0 and less than 180 degrees, not {angle:g}")
        for name in ("near", "far"):
            distance = getattr(self, name)
            if distance is not None and not 0 < distance < float("inf"):
                raise UsageError(f"{name}: must be more than 0, not {distance:g}")
        if self.near is not None and self.far is not None and self.near >= self.far:
            raise UsageError(f"near must be less than far, not {self.near:g} and {self.far:g}")

    @classmethod
    def from_matrix(cls, to_world: ArrayLike, *, distance: float = 1.0, **others: Any) -> Camera:
        """A camera by its matrix [4, 4], camera to world, that looks along its -Z with +Y up (OpenGL, glTF, Blender).

        ``distance`` [m] is where the target lies: of parallel projection it says how much is seen.

        Raises:
            UsageError: the axes are not perpendicular and of one length, or are left-handed (determinant < 0): such a picture would be
                sheared, stretched or mirrored, which no position, target and up can say
        """
        m = np.asarray(to_world, dtype=np.float64)
        if m.shape != (4, 4) or not np.isfinite(m).all():
            raise UsageError(f"to_world: a finite matrix of shape (4, 4) is expected, not {m.shape}")
        if not np.allclose(m[3], (0, 0, 0, 1), rtol=0, atol=1e-6):
            raise UsageError("to_world: the last row must be 0 0 0 1; the position is the last column")
        if np.linalg.matrix_rank(m[:3, :3]) < 3:
            raise UsageError("to_world: the axes of the camera, its first three columns, must not lie in a plane")
        _check_axes(m[:3, :3])
        position = m[:3, 3]
        return cls(tuple(position), tuple(position - distance * m[:3, 2]), tuple(m[:3, 1]), **others)

    @classmethod
    def orbit(cls, azimuth: float, elevation: float, distance: float, target: Vector = (0.0, 0.0, 0.0), **others: Any) -> Camera:
        """A camera on a sphere about ``target``: azimuth [degrees] from +Z towards +X, elevation [degrees] from the ground, distance [m]."""
        a, e = np.radians(numbers("azimuth, elevation", [azimuth, elevation]))
        (distance,), target = numbers("distance", [distance]), _vector("target", target)
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


def _check_name(camera: str, cameras: Sequence[str]) -> None:
    """A camera of the file by name or by number in digits."""
    if camera in cameras or (camera.isascii() and camera.isdigit() and int(camera) < len(cameras)):
        return
    listed = ", ".join(quoted(name, 24) for name in cameras[:5]) + (f" and {len(cameras) - 5} more" if len(cameras) > 5 else "")
    choice = f"sides are {', '.join(SIDES)}; " + (f"the model's cameras are {listed}" if cameras else "the model has no cameras")
    raise usage_error("camera", f"there is no side or camera {quoted(camera)}", suggestion(camera, [*SIDES, *cameras], choice))


def camera_settings(camera: CameraLike, cameras: Sequence[str]) -> dict[str, Any]:
    """The program's settings that choose a camera.

    Args:
        cameras: names of the scene's own
    """
    if camera is None:
        return {}
    if isinstance(camera, Camera):
        return camera.settings()
    if isinstance(camera, str) and camera in SIDES:
        return {"view": camera}
    if isinstance(camera, (str, int, np.integer)) and not isinstance(camera, bool):
        _check_name(str(camera), cameras)
        return {"camera_index": str(camera)}
    raise UsageError(f"camera: a Camera, a side, or a camera of the file is expected, not {type(camera).__name__}")
