# SPDX-License-Identifier: Apache-2.0
"""Meshes as arrays, and their normals and tangents."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from types import MappingProxyType
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import UsageError, usage_error
from ._numbers import number, numbers, whole
from ._positions import split
from ._run import Progress, remarks_of, threads, told
from ._surface import has_alpha, png_of, surface_of

Floats = NDArray[np.float32]
Indices = NDArray[np.uint32]


def _check_shape(name: str, values: Any, columns: int) -> None:
    """Looks at the shape alone: whether numbers and indices can be, is known when the mesh is used. Nothing at all has any shape."""
    if values is None:
        raise UsageError(f"{name}: an array is expected, not None")
    try:
        shape = np.shape(values)
    except (TypeError, ValueError):
        raise UsageError(f"{name}: an array of the shape (n, {columns}) is expected, not rows of several lengths") from None
    if shape != (0,) and (len(shape) != 2 or shape[1] != columns):
        raise UsageError(f"{name}: the shape must be (n, {columns}), not {shape}")


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles of one material. It does not change: ``dataclasses.replace(mesh, normals=...)`` makes another.

    Arrays are taken as they are: float32 and 32-bit integers, row by row, are never copied for :func:`attributes`, and once for a
    :class:`Scene`, which does not see what is done to them later. Those of a scene are its own memory and cannot be written to.

    Args:
        vertices: [V, 3] positions [m], object space. float32 in a scene; of float64 that are so far away that float32 would not hold them,
            ``origin`` is taken off first
        faces: [T, 3] integers < V; counter-clockwise seen from outside
        normals: [V, 3] unit, object space
        tangents: [V, 4] xyz unit, w = +1 or -1: bitangent = cross(normal, xyz) * w
        uv: [V, 2] texture coordinates, v down
        colors: [V, 4] linear RGBA
        name: of its object
        color: linear RGB or RGBA of its surface, 0 to 1; None: the default material
        texture: [H, W], [H, W, 3] or [H, W, 4] uint8 sRGB, its first row at v = 0; multiplies ``color``
        to_world: [4, 4] object space to world; None: the same
        arrays: {name: [V] or [V, n]} other numbers of the vertices, n <= 16
        material: number of its material in the scene that it comes from; :meth:`Scene.with_meshes` takes it, :meth:`Scene.from_meshes`
            makes materials of ``color`` and ``texture`` alone
        topology: "triangles", or "lines" or "points" of loaded meshes: faces are [L, 2] or [P, 1] then
        origin: [m] vertices count from here; not 0 where they are far away: :meth:`positions` has the sum
    """

    vertices: ArrayLike
    faces: ArrayLike
    normals: ArrayLike | None = None
    tangents: ArrayLike | None = None
    uv: ArrayLike | None = None
    colors: ArrayLike | None = None
    name: str = ""
    color: ArrayLike | None = None
    to_world: ArrayLike | None = None
    arrays: Mapping[str, Floats] = field(default_factory=dict)
    material: int | None = None
    topology: str = "triangles"
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    texture: ArrayLike | None = None

    def __post_init__(self) -> None:
        origin = numbers("origin", self.origin)
        if len(origin) != 3 or not np.isfinite(origin).all():
            raise UsageError(f"origin: three finite numbers are expected, not {self.origin!r:.60}")
        object.__setattr__(self, "origin", origin)
        columns = {"lines": 2, "points": 1}.get(self.topology, 3)
        _check_shape("vertices", self.vertices, 3)
        _check_shape("faces", self.faces, columns)
        for name, count in (("normals", 3), ("tangents", 4), ("uv", 2), ("colors", 4)):
            if getattr(self, name) is not None:
                _check_shape(name, getattr(self, name), count)
        if self.to_world is not None and np.shape(self.to_world) != (4, 4):
            raise UsageError(f"to_world: the shape must be (4, 4), not {np.shape(self.to_world)}")

    @property
    def vertex_normals(self) -> ArrayLike | None:
        """The name that trimesh has for ``normals``."""
        return self.normals

    def positions(self, *, world: bool = False) -> NDArray[np.float64]:
        """[V, 3] float64 [m] positions with ``origin``, in object space, or placed by ``to_world`` in the world."""
        out = np.asarray(self.vertices, dtype=np.float64) + np.asarray(self.origin, dtype=np.float64)
        if world and self.to_world is not None:
            place = np.asarray(self.to_world, dtype=np.float64)
            out = out @ place[:3, :3].T + place[:3, 3]
        return out

    def __reduce__(self) -> tuple[Any, ...]:
        values = (getattr(self, part.name) for part in fields(self))
        return Mesh, tuple(dict(value) if isinstance(value, MappingProxyType) else value for value in values)

    def trimesh_arguments(self) -> dict[str, Any]:
        """``trimesh.Trimesh(**mesh.trimesh_arguments())``: vertices and faces as they are, nothing merged."""
        vertices = self.positions() if any(self.origin) else self.vertices
        return {"vertices": vertices, "faces": self.faces, "vertex_normals": self.normals, "process": False}


MeshLike = Union[Mesh, Any]
"""A :class:`Mesh`, or anything with ``.vertices`` and ``.faces`` (trimesh) or ``.triangles`` (Open3D): normals, texture coordinates, a
name, colors of vertices and faces, and the color and texture of its one material are taken where they have the usual names; or a tuple
(vertices, faces). ``.visual.uv`` (trimesh) is v up, ``.uv`` is v down. Colors are sRGB: integers 0 to 255 or floats 0 to 1."""


def _first(thing: object, *names: str) -> Any:
    """The first attribute that is there and not empty."""
    for name in names:
        value: Any = thing
        for part in name.split("."):
            value = value.get(part) if isinstance(value, Mapping) else getattr(value, part, None)
        if value is not None and (not hasattr(value, "__len__") or len(value) > 0):
            return value
    return None


def _per_vertex(values: Any, vertices: NDArray[Any]) -> NDArray[Any] | None:
    """Open3D has texture coordinates of corners under like names: those are left out."""
    if values is None:
        return None
    array = np.asarray(values)
    return array if array.ndim == 2 and len(array) == len(vertices) else None


def _with_surface(mesh: Mesh, thing: object, dropped: list[str]) -> Mesh:
    """With the colors and the texture of a mesh of another library. Vertices are split where corners have their own."""
    vertices, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
    surface = surface_of(thing, len(vertices), len(faces), mesh.uv is not None)
    where = f"mesh '{mesh.name}'" if mesh.name else "a mesh"
    dropped += [f"{where}: not taken over: {what}" for what in surface.dropped]
    mesh = replace(mesh, colors=surface.colors, color=surface.color, texture=surface.texture)
    if surface.corner_colors is None and surface.corner_uv is None:
        return mesh
    if faces.shape[1:] != (3,) or (faces.size > 0 and not (0 <= faces.min() and faces.max() < len(vertices))):
        return mesh  # refused later, with words of its own
    corners = faces.reshape(-1).astype(np.int64)

    def split(values: ArrayLike | None) -> NDArray[Any] | None:
        return None if values is None else np.asarray(values)[corners]

    return replace(
        mesh,
        vertices=vertices[corners],
        faces=np.arange(len(corners), dtype=np.uint32).reshape(-1, 3),
        normals=split(mesh.normals),
        uv=split(mesh.uv) if surface.corner_uv is None else surface.corner_uv,
        colors=split(mesh.colors) if surface.corner_colors is None else surface.corner_colors,
    )


def mesh_of(thing: MeshLike, dropped: list[str] | None = None) -> Mesh:
    """Makes a :class:`Mesh` of anything that is like one.

    Args:
        dropped: gets what of its surface is not taken over; None: surfaces are not looked at
    """
    if isinstance(thing, Mesh):
        return thing
    if isinstance(thing, tuple) and len(thing) == 2:
        return Mesh(thing[0], thing[1])
    faces = _first(thing, "faces", "triangles")
    if not hasattr(thing, "vertices") or not (hasattr(thing, "faces") or hasattr(thing, "triangles")):
        raise UsageError(f"a mesh with .vertices and .faces is expected, not {type(thing).__name__}")
    vertices = np.asarray(thing.vertices)
    name = _first(thing, "name", "metadata.name")
    uv = _per_vertex(_first(thing, "visual.uv"), vertices)
    if uv is not None:  # trimesh: v up
        uv = np.stack([uv[:, 0], 1 - uv[:, 1]], axis=1)
    else:
        uv = _per_vertex(_first(thing, "uv"), vertices)
    mesh = Mesh(
        vertices,
        np.zeros((0, 3), np.uint32) if faces is None else np.asarray(faces),
        normals=_per_vertex(_first(thing, "vertex_normals", "normals"), vertices),
        uv=uv,
        name=name if isinstance(name, str) else "",
    )
    return mesh if dropped is None else _with_surface(mesh, thing, dropped)


def meshes_of(things: MeshLike | Iterable[MeshLike] | Mapping[str, MeshLike], dropped: list[str] | None = None) -> list[Mesh]:
    """One mesh, several, or {name: mesh}; of a trimesh scene all, placed. ``dropped``: :func:`mesh_of`."""
    if isinstance(things, Mapping):
        meshes = []
        for name, thing in things.items():
            mesh = mesh_of(thing, dropped)
            meshes.append(replace(mesh, name=mesh.name or str(name)))
        return meshes
    if hasattr(things, "dump") and hasattr(things, "geometry"):
        return meshes_of(list(things.dump()), dropped)
    is_one = isinstance(things, Mesh) or hasattr(things, "vertices") or (isinstance(things, tuple) and len(things) == 2)
    if is_one:
        return [mesh_of(things, dropped)]
    if not isinstance(things, Iterable):
        raise UsageError(f"a mesh or several are expected, not {type(things).__name__}")
    return [mesh_of(thing, dropped) for thing in things]


def dicts_of(meshes: Sequence[Mesh]) -> list[dict[str, Any]]:
    """As the extension takes them."""
    keys = ("faces", "normals", "tangents", "uv", "colors", "name", "color", "to_world", "material")
    out = []
    for mesh, (vertices, origin) in zip(meshes, split(meshes)):
        if mesh.topology != "triangles":
            raise UsageError(f"a mesh of triangles is expected, not one of {mesh.topology}")
        if not isinstance(mesh.arrays, Mapping):
            raise UsageError(f"arrays: {{name: array}} is expected, not {type(mesh.arrays).__name__}")
        texture = None if mesh.texture is None else png_of(mesh.texture, "texture")
        if texture is not None and mesh.uv is None:
            raise UsageError("texture: it needs texture coordinates, uv")
        out.append({"vertices": vertices, "origin": origin, "arrays": dict(mesh.arrays), **{key: getattr(mesh, key) for key in keys},
                    "texture": texture, "blend": has_alpha(mesh.color, mesh.colors, mesh.texture)})
    return out


@dataclass(eq=False)
class Attributes:
    """Normals and tangents of one mesh. A vertex whose corners differ is split: V' >= V, the first V keep their numbers.

    Attributes:
        normals: [V', 3] float32, unit, object space
        tangents: [V', 4] float32, xyz unit and perpendicular to the normal, w = +1 or -1; None without texture coordinates
        faces: [T, 3] uint32 < V'; where nothing was split the very array that was given
        source: [V'] uint32, the vertex of the input that each is
        degenerate_faces: without area or with a corner that is not finite: they had no say
        isolated_vertices: that no other face touches: their normal is (0, 0, 1)
    """

    normals: Floats
    tangents: Floats | None
    faces: ArrayLike
    source: Indices
    degenerate_faces: int
    isolated_vertices: int

    def expand(self, values: ArrayLike) -> NDArray[Any]:
        """Numbers of the input's vertices [V, ...] as those of the split ones [V', ...]."""
        return np.asarray(values)[self.source]


def normals_word(normals: str, scope: str | None, default: str, words: tuple[str, ...], advice: str = "") -> str:
    """The word of ``normals``, or of ``scope``, its old name."""
    if scope is not None and normals not in (default, scope):
        raise usage_error("scope", "is the old name of normals", "give one of them")
    word: object = normals if scope is None else scope
    if word == "flat":
        return "face"
    if isinstance(word, str) and word in words:
        return word
    raise usage_error("normals", f"unknown word {word!r:.40}", f"use one of {', '.join(words)}" + advice)


def scope_of(normals: str, scope: str | None) -> str:
    """Where all normals are made anew."""
    return normals_word(normals, scope, "model", ("model", "object", "face"), "; repair_seams() of a scene joins the normals that it has")


def creases_of(crease_angle: float | None, crease: str | None) -> dict[str, Any]:
    """Without a word: by the angle if there is one, else by the rule."""
    if crease is None:
        crease = "auto" if crease_angle is None else "angle"
    if not isinstance(crease, str):
        raise UsageError(f"crease: a word is expected, not {type(crease).__name__}")
    return {"crease_angle_rad": number("crease_angle", 60.0 if crease_angle is None else crease_angle) * (np.pi / 180.0), "crease": crease}


def options_of(
    scope: str, weight: str, crease_angle: float | None, crease: str | None, weld_distance: float | None, tangents: bool, tangent_mode: str
) -> dict[str, Any]:
    distance = -1.0 if weld_distance is None else number("weld_distance", weld_distance)
    if weld_distance is not None and not distance >= 0:
        raise UsageError("weld_distance: must be 0 or more")
    for name, word in (("weight", weight), ("tangent_mode", tangent_mode)):
        if not isinstance(word, str):
            raise UsageError(f"{name}: a word is expected, not {type(word).__name__}")
    return {
        "scope": scope,
        "weight": weight.replace("_", "-"),
        **creases_of(crease_angle, crease),
        "weld_distance": distance,
        "tangents": bool(tangents),
        "tangent_mode": tangent_mode.replace("_", "-"),
    }


def attributes(
    meshes: MeshLike | Iterable[MeshLike] | Mapping[str, MeshLike],
    *,
    normals: str = "model",
    scope: str | None = None,
    weight: str = "angle",
    crease_angle: float = 60.0,
    crease: str = "angle",
    weld_distance: float | None = None,
    tangents: bool = True,
    tangent_mode: str = "averaged",
    objects: Sequence[int] | None = None,
    progress: Progress = None,
) -> list[Attributes]:
    """Seam-free normals, and tangents where there are texture coordinates. Arrays of the right type are read where they lie.

    Args:
        meshes: one mesh, several that are one model, or {name: mesh}
        normals: over which faces they are smoothed: "model" (no seams between meshes), "object", "face" (flat)
        scope: the old name of ``normals``
        weight: how strongly a triangle pulls on its corners: "angle", "area", "angle_area", "max", "fit", "auto", "uniform"
        crease_angle: [degrees] 0 to 180; edges bent more stay sharp
        crease: "angle", or "auto": no angle, but the rule of creases finds the sharp edges
        weld_distance: [m] positions at most this far apart are one; None: equal, but for rounding; 0: equal
        tangents: also make tangents
        tangent_mode: "averaged", "mikktspace", "published", "published_no_handedness"
        objects: [meshes] meshes of one number are one object; None: each is one
    Returns:
        one entry for each mesh
    Raises:
        UsageError: shapes, types or indices that do not fit
    """
    given = meshes_of(meshes)
    options = options_of(scope_of(normals, scope), weight, crease_angle, crease, weld_distance, tangents, tangent_mode)
    numbers = list(range(len(given))) if objects is None else [whole("objects", thing, 0, 2**32 - 1) for thing in objects]
    if len(numbers) != len(given):
        raise UsageError(f"objects: there are {len(numbers)} numbers for {len(given)} meshes")
    with told(progress) as tell:
        made, remarks = _core.attributes(dicts_of(given), numbers, options, threads(), tell)
    remarks_of(remarks)
    out = []
    for mesh, new in zip(given, made):
        split: Indices = new["split_from"]
        kept = np.arange(len(new["normals"]) - len(split), dtype=np.uint32)
        faces = mesh.faces if new["faces"] is None else new["faces"]
        source = np.concatenate([kept, split]) if len(split) else kept
        out.append(Attributes(new["normals"], new["tangents"], faces, source, new["degenerate_faces"], new["isolated_vertices"]))
    return out
