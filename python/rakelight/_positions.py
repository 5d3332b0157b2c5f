# SPDX-License-Identifier: Apache-2.0
"""Positions in double precision, as float32 and the point from which they count."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from ._mesh import Mesh

Doubles = NDArray[np.float64]


def _array(values: ArrayLike) -> NDArray[Any]:
    try:
        return np.asarray(values)
    except ValueError:  # rows of different lengths: the extension refuses them
        return np.zeros(0)


def _exact(mesh: Mesh) -> Doubles | None:
    """Positions that float32 need not hold; None: it holds them, or they are none."""
    vertices = _array(mesh.vertices)
    is_wide = vertices.dtype.kind in "fiu" and vertices.dtype.itemsize >= 4 and vertices.dtype.type is not np.float32
    if not is_wide or vertices.ndim != 2 or vertices.shape[1] != 3:
        return None
    return vertices.astype(np.float64) + np.asarray(mesh.origin, dtype=np.float64)


def _origin(arrays: Iterable[Doubles]) -> Doubles:
    """Zero, unless float32 loses more of a coordinate than 2^-22 of the diagonal of the box about all; then the middle of the box, rounded:
    the rule of loaders (src/io/position_origin.h)."""
    low, high, error = np.full(3, np.inf), np.full(3, -np.inf), 0.0
    largest = float(np.finfo(np.float32).max)
    for array in arrays:
        finite = np.where(np.abs(array) <= largest, array, np.nan)
        low = np.fmin(low, np.fmin.reduce(finite, axis=0, initial=np.inf))
        high = np.fmax(high, np.fmax.reduce(finite, axis=0, initial=-np.inf))
        error = max(error, float(np.fmax.reduce(np.abs(finite.astype(np.float32) - finite), axis=None, initial=0.0)))
    diagonal = float(np.linalg.norm(np.maximum(high - low, 0.0)))
    if not diagonal > 0 or error <= np.ldexp(diagonal, -22):
        return np.zeros(3)
    unit = np.ldexp(1.0, int(np.frexp(diagonal)[1]) - 3)
    return np.where(low <= high, np.floor((low + high) / 2 / unit + 0.5) * unit, 0.0)


def _place(mesh: Mesh) -> bytes:
    """Equal for meshes that stand in one place, whatever the type of their matrices; None is the identity."""
    try:
        matrix = np.eye(4) if mesh.to_world is None else np.asarray(mesh.to_world, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):  # the extension refuses it
        return b""
    return (matrix + 0.0).tobytes()  # -0 becomes 0


def split(meshes: Sequence[Mesh]) -> list[tuple[ArrayLike, tuple[float, float, float]]]:
    """[(vertices, origin)] of each mesh. One origin for all that stand in one place, so that equal positions stay equal."""
    exact = [_exact(mesh) for mesh in meshes]
    places = [_place(mesh) for mesh in meshes]
    together: dict[bytes, list[Doubles]] = {place: [] for place in places}
    for array, place in zip(exact, places):
        if array is not None:
            together[place].append(array)
    out: list[tuple[ArrayLike, tuple[float, float, float]]] = []
    with np.errstate(over="ignore"):
        origins = {place: _origin(arrays) for place, arrays in together.items()}
        for mesh, array, place in zip(meshes, exact, places):
            origin = origins[place]
            if array is None or not (origin.any() or any(mesh.origin)):
                out.append((mesh.vertices, mesh.origin))
            else:
                x, y, z = origin.tolist()
                out.append(((array - origin).astype(np.float32), (x, y, z)))
    return out
