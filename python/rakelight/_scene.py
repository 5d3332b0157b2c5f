# SPDX-License-Identifier: Apache-2.0
"""Scenes."""
from __future__ import annotations

import operator
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import UsageError
from ._mesh import Mesh, MeshLike, creases_of, dicts_of, mesh_of, meshes_of, options_of, scope_of
from ._numbers import MAX_MEMORY, number, whole
from ._run import Path, Progress, Remark, name_of, remarks_of, threads, told

if TYPE_CHECKING:
    from ._camera import CameraLike
    from ._picture import Picture
    from ._reports import Explanation


@dataclass(frozen=True, eq=False)
class Object:
    """A node of the scene that has meshes."""

    name: str
    node: int
    """Its number, which the channel ``object`` has."""
    meshes: tuple[int, ...]
    """Into :attr:`Scene.meshes`."""
    to_world: NDArray[np.float64]
    """[4, 4] object space to world."""


class Scene:
    """A model or a world: objects, meshes, materials, lights, cameras. It does not change: what changes it returns a new one, which shares
    all that stays. Made by :func:`rakelight.load` or :meth:`from_meshes`."""

    def __init__(self, core: _core.Scene, remarks: list[Remark] | None = None) -> None:
        self._core = core
        self._meshes: tuple[Mesh, ...] | None = None
        self.remarks: list[Remark] = remarks or []
        """What was changed, guessed or dropped on the way here, notes too."""

    @classmethod
    def from_meshes(cls, meshes: MeshLike | Iterable[MeshLike] | Mapping[str, MeshLike]) -> Scene:
        """A scene of one mesh, of several, or of {name: mesh}: :class:`Mesh`, or anything with ``.vertices`` and ``.faces``. Arrays are copied.

        float64 positions that float32 would not hold (far from zero for the model's size) count from an origin, as those of files do.
        Meshes without ``to_world``, or with the same, have the same origin. Of meshes of trimesh and Open3D the colors and the texture come
        along; what of their materials does not is among the :attr:`remarks`.

        Raises:
            UsageError: shapes, types or indices that do not fit
        """
        dropped: list[str] = []
        core = _core.scene_of_meshes(dicts_of(meshes_of(meshes, dropped)))
        return cls(core, _told_dropped(dropped))

    @property
    def source(self) -> str:
        """The file that it comes from; empty: none."""
        return self._core.source

    @property
    def meshes(self) -> tuple[Mesh, ...]:
        """All meshes, each once, in object space. They and their arrays are the scene's own and cannot be written to: reading costs
        nothing, and :meth:`with_meshes` makes a scene with others."""
        if self._meshes is None:
            self._meshes = tuple(_mesh(self._core, index) for index in range(self._core.mesh_count))
        return self._meshes

    def with_meshes(self, meshes: Mapping[int, MeshLike]) -> Scene:
        """The scene with the arrays of other meshes in the place of some of its own: {number in :attr:`meshes`: mesh}.

        All arrays are the new mesh's: where it has no ``normals``, ``uv``, ``colors`` or ``arrays``, the scene's mesh has none either.
        Its ``name`` and ``material`` (a number in :attr:`materials`) stay where the new mesh has none; a ``color`` or ``texture`` makes a material of
        its own. Places, animations and further sets of texture coordinates stay; smoothing groups and polygons do where the faces are
        the very same.

            mesh = scene.meshes[0]
            taller = scene.with_meshes({0: dataclasses.replace(mesh, vertices=mesh.vertices * (1, 2, 1))})

        Raises:
            UsageError: shapes, types or indices that do not fit; another number of vertices for a mesh that is animated or has further
                sets of texture coordinates; a ``material`` that the scene does not have; a ``to_world``
        """
        if not isinstance(meshes, Mapping) or not all(hasattr(number, "__index__") for number in meshes):
            raise UsageError("with_meshes: {number: mesh} is expected")
        dropped: list[str] = []
        given = {operator.index(number): mesh_of(mesh, dropped) for number, mesh in meshes.items()}
        for number in given:
            if not 0 <= number < self._core.mesh_count:
                raise UsageError(f"mesh {number} is not one of the {self._core.mesh_count}")
        return Scene(_core.with_meshes(self._core, dict(zip(given, dicts_of(list(given.values()))))), self.remarks + _told_dropped(dropped))

    @property
    def objects(self) -> list[Object]:
        """What is placed where."""
        return [Object(name, node, tuple(meshes), to_world) for name, node, meshes, to_world in self._core.objects()]

    def placed_meshes(self) -> list[Mesh]:
        """The meshes of all objects, each with its ``to_world`` and its object's name; a mesh that stands twice is here twice."""
        meshes = self.meshes
        return [
            replace(meshes[index], name=thing.name or meshes[index].name, to_world=thing.to_world)
            for thing in self.objects
            for index in thing.meshes
        ]

    @property
    def nodes(self) -> list[str]:
        """Names, by the numbers of the channel ``object``."""
        return self._core.nodes

    @property
    def materials(self) -> list[str]:
        """Names, by the numbers of the channel ``material``."""
        return self._core.materials

    @property
    def cameras(self) -> list[str]:
        """Names of the file's cameras."""
        return self._core.cameras

    @property
    def animations(self) -> list[str]:
        """Names of the file's clips."""
        return self._core.animations

    @property
    def bounds(self) -> NDArray[np.float64] | None:
        """[2, 3] low and high corner [m] of the world's box about all that is drawn; None: nothing is."""
        box = self._core.bounds()
        return None if box is None else np.stack(box)

    def smooth(
        self,
        normals: str = "model",
        *,
        scope: str | None = None,
        weight: str = "auto",
        crease_angle: float | None = None,
        crease: str | None = None,
        weld_distance: float | None = None,
        tangents: bool = True,
        tangent_mode: str = "averaged",
        progress: Progress = None,
    ) -> Scene:
        """The scene with new seam-free normals, and tangents where there are texture coordinates. Arguments: :func:`rakelight.attributes`,
        but ``"auto"`` is the default weight, and the rule of creases finds sharp edges if no angle is given.
        To join the file's normals instead: :meth:`repair_seams`."""
        options = options_of(scope_of(normals, scope), weight, crease_angle, crease, weld_distance, tangents, tangent_mode)
        with told(progress) as tell:
            core, rows = _core.smooth(self._core, options, threads(), tell)
        return Scene(core, self.remarks + remarks_of(rows))

    def repair_seams(
        self, *, crease_angle: float | None = None, crease: str | None = None, border_distance: float = 0.0, progress: Progress = None
    ) -> Scene:
        """The scene with the file's normals, joined where meshes meet: what ``rakelight smooth`` does by default. Where the file has none
        they are made over the whole model.

        Args:
            crease_angle: [degrees] 0 to 180; edges bent more stay sharp
            crease: "auto": the rule of creases finds the sharp edges, and the angle (60) only limits which borders agree; or "angle".
                None: "angle" if an angle is given, else "auto"
            border_distance: [m] normals also agree along borders at most this far apart that share no vertices; 0: off
        """
        border_distance = number("border_distance", border_distance)
        if crease_angle is not None and not 0 <= number("crease_angle", crease_angle) <= 180:
            raise UsageError("crease_angle: must be 0 to 180 degrees")
        if not 0 <= border_distance < float("inf"):
            raise UsageError("border_distance: must be 0 or more")
        with told(progress) as tell:
            core, rows = _core.repair(self._core, creases_of(crease_angle, crease), border_distance, threads(), tell)
        return Scene(core, self.remarks + remarks_of(rows))

    def save(self, path: Path, *, progress: Progress = None) -> None:
        """Writes .glb or .gltf, .obj (without motion), or .ply (triangles alone). To keep all else of a file as it is:
        :func:`rakelight.smooth_file`, :func:`rakelight.convert_file`."""
        with told(progress) as tell:
            remarks_of(_core.save(self._core, name_of(path), threads(), tell))

    def render(self, camera: CameraLike = None, **options: Any) -> Picture:
        """:func:`rakelight.render` of this scene."""
        from ._session import render

        return render(self, camera, **options)

    def inspect(self, **options: Any) -> dict[str, Any]:
        """:func:`rakelight.inspect` of this scene."""
        from ._reports import inspect

        return inspect(self, **options)

    def explain(self, x: int, y: int, **options: Any) -> Explanation:
        """:func:`rakelight.explain` of this scene."""
        from ._reports import explain

        return explain(self, x, y, **options)

    def __copy__(self) -> Scene:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Scene:
        return self

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Scene cannot be pickled: send the name of its file, or its placed_meshes()")

    def _repr_png_(self) -> bytes:
        return self.render(resolution=(640, 480)).png()

    def __repr__(self) -> str:
        return f"<rakelight.Scene {self.source or 'of arrays'}: {len(self._core.objects())} objects, {self._core.mesh_count} meshes>"


def _told_dropped(dropped: list[str]) -> list[Remark]:
    """As remarks, each once, and warnings."""
    return remarks_of([("dropped", "", "", what, dropped.count(what)) for what in dict.fromkeys(dropped)])


def _mesh(core: _core.Scene, index: int) -> Mesh:
    arrays = _core.mesh(core, index)
    sets = arrays.pop("uv_sets")
    vertices, faces = arrays.pop("vertices"), arrays.pop("faces")
    return Mesh(
        np.zeros((0, 3), np.float32) if vertices is None else vertices,
        np.zeros((0, 3), np.uint32) if faces is None else faces,
        uv=sets[0] if sets else None,
        arrays=MappingProxyType(arrays.pop("arrays")),
        **arrays,
    )


def load(
    path: Path, *, allow_outside: bool = False, allow_shaders: bool = False, max_memory: int = 0, progress: Progress = None
) -> Scene:
    """Loads a model (glTF, GLB, OBJ, PLY, FBX, DAE, 3DS, STL, ...), a world (.scene.toml), or ``"builtin:teapot"``.

    Args:
        allow_outside: the file may refer to files outside of its own folder
        allow_shaders: a world may name GLSL files in [render], which the OpenGL driver compiles and runs
        max_memory: [bytes] that its data may ask for; 0: 2 GiB, or 64 bytes for each byte of its files
    Raises:
        NotFoundError, BadFileError: with file and place
    """
    memory = whole("max_memory", max_memory, 0, MAX_MEMORY)
    if isinstance(path, (bytes, bytearray, memoryview)):
        raise UsageError("a file's name is expected, not bytes; load_bytes(data, 'model.glb') loads what lies in memory")
    with told(progress) as tell:
        core, rows = _core.load(name_of(path), bool(allow_outside), bool(allow_shaders), threads(), memory, tell)
    return Scene(core, remarks_of(rows))


def load_bytes(data: bytes, name: str, *, max_memory: int = 0, progress: Progress = None) -> Scene:
    """Loads a model that lies in memory. ``name`` says the format by its ending, as "model.glb"."""
    if not isinstance(data, (bytes, bytearray, memoryview)):
        raise UsageError(f"data: bytes are expected, not {type(data).__name__}")
    memory = whole("max_memory", max_memory, 0, MAX_MEMORY)
    with told(progress) as tell:
        core, rows = _core.load_bytes(bytes(data), name_of(name), threads(), memory, tell)
    return Scene(core, remarks_of(rows))


def scene_of(thing: Any) -> Scene:
    """A scene as it is; a path is loaded; all else is taken as meshes."""
    if isinstance(thing, Scene):
        return thing
    if isinstance(thing, (str, os.PathLike, bytes, bytearray, memoryview)):
        return load(thing)  # type: ignore[arg-type]  # bytes are refused there
    return Scene.from_meshes(thing)
