# SPDX-License-Identifier: Apache-2.0
"""Why pixels are as they are, what is in models, and files written as the program writes them."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _core
from ._camera import CameraLike, camera_settings
from ._errors import UsageError, usage_error
from ._mesh import normals_word, options_of
from ._numbers import number, whole
from ._run import Path, Progress, name_of, quoted, remarks_of, settings_of, suggestion, threads, told
from ._scene import scene_of
from ._session import Resolution, SceneLike, names_of_channels


@dataclass(frozen=True)
class Explanation:
    """Why a pixel has its color: everything that the soft engine computes on the way to it.

    Attributes:
        x, y: [px] from the left, from the top
        color: linear RGB and alpha of the picture's pixel
        sum: of all terms: the same, to the bit
        codes: the pixel of a PNG file, 0 to 255
        is_background: nothing is drawn there
        object, material: names of what is nearest; empty: nothing, or they have none
        triangles: all that cover the pixel, with their fate
        data: all of it, as ``rakelight explain --json`` writes it
        text: for people
    """

    x: int
    y: int
    color: tuple[float, ...]
    sum: tuple[float, ...]
    codes: tuple[int, ...]
    is_background: bool
    object: str
    material: str
    triangles: list[dict[str, Any]] = field(repr=False)
    data: dict[str, Any] = field(repr=False)
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text


def _explanation(x: int, y: int, row: dict[str, Any], text: str) -> Explanation:
    triangles: list[dict[str, Any]] = row.get("triangles", [])
    seen: dict[str, Any] = next((t for t in triangles if t.get("fate") == "visible"), {})
    return Explanation(
        x, y, tuple(row["color"]), tuple(row["sum"]), tuple(row["codes"]), bool(row["is_background"]),
        seen.get("object", ""), seen.get("material_name", ""), triangles, row, text,
    )  # fmt: skip


def _place(pixel: Any) -> tuple[int, int]:
    if not isinstance(pixel, (tuple, list, np.ndarray)) or len(pixel) != 2:
        raise UsageError(f"pixels: (x, y) is expected, not {pixel!r:.60}")
    x, y = (whole(name, value, -(2**31), 2**31 - 1) for name, value in zip("xy", pixel))
    return x, y


def explain_pixels(
    scene: SceneLike,
    pixels: Iterable[tuple[int, int]],
    camera: CameraLike = None,
    *,
    resolution: Resolution | None = None,
    progress: Progress = None,
    **settings: Any,
) -> list[Explanation]:
    """:func:`explain` for several pixels [(x, y), ...] of one picture."""
    places = [_place(pixel) for pixel in pixels]
    scene = scene_of(scene)
    words = settings_of({**settings, **camera_settings(camera, scene.cameras), "resolution": resolution})
    with told(progress) as tell:
        rows, remarks = _core.explain(scene._core, words, places, threads(), tell)
    remarks_of(remarks)
    return [_explanation(x, y, json.loads(row)["rows"][0], text) for (x, y), (row, text) in zip(places, rows)]


def explain(
    scene: SceneLike,
    x: int,
    y: int,
    camera: CameraLike = None,
    *,
    resolution: Resolution | None = None,
    progress: Progress = None,
    **settings: Any,
) -> Explanation:
    """Follows one pixel of the picture that :func:`rakelight.render` draws with the same arguments.

    Args:
        x, y: [px] of the whole picture; 0, 0 is the top left one
    Raises:
        UsageError: the pixel is not in the picture
    """
    return explain_pixels(scene, [(x, y)], camera, resolution=resolution, progress=progress, **settings)[0]


def _limits(check: Mapping[str, Any] | bool | None) -> dict[str, Any] | None:
    """As the extension takes them; without "max-seam" it is 1 degree."""
    if check is None or check is False:
        return None
    if check is True:
        return {}
    if not isinstance(check, Mapping) or not all(isinstance(name, str) for name in check):
        raise UsageError("check: True or limits are expected, such as {'max_seam': 1.0, 'closed': True}")
    words = [word.replace("-", "_") for word in _core.limit_words()]
    for name in check:
        if name.replace("-", "_") not in words:
            raise usage_error("check", f"there is no limit {quoted(name)}", suggestion(name, words, f"use {', '.join(words)}"))
    return {name.replace("_", "-"): value for name, value in check.items()}


def inspect(
    scene: SceneLike,
    *,
    borders: bool = True,
    surfaces: bool = True,
    check: Mapping[str, Any] | bool | None = None,
    progress: Progress = None,
    **settings: Any,
) -> dict[str, Any]:
    """What is in a model: a row of ``rakelight inspect --json``.

    Args:
        borders: look for positions that meshes share (objects, or materials of one object), and their seams
        surfaces: look at edges, faces and normals of each object
        check: limits by the names of the program's options with ``_`` for ``-``: ``{"max_seam": 1.0, "closed": True}``; the result's
            ``"check"`` has {"passed", "failures"} then. As by ``rakelight inspect --check``, "max_seam" is 1 degree where it is not given;
            None allows every seam. True: this limit alone
        settings: ``normals``, ``crease_angle``, ``crease``, ``weight``, ``weld_distance``, ``border_distance``, ``animation_time``, ...
    Returns:
        {"triangles", "bounds", "objects", "seams", "borders", "materials", ...}: docs/inspect.md
    """
    limits = _limits(check)
    if not borders and limits is not None and limits.get("max-seam", 1.0) is not None:
        raise UsageError("max_seam is looked at with borders=True alone")
    with told(progress) as tell:
        text, remarks = _core.inspect(scene_of(scene)._core, settings_of(settings), bool(borders), bool(surfaces), limits, threads(), tell)
    remarks_of(remarks)
    row: dict[str, Any] = json.loads(text)["rows"][0]
    return row


def render_file(
    scene: SceneLike,
    path: Path,
    camera: CameraLike = None,
    *,
    resolution: Resolution | None = None,
    channels: Sequence[str] | str | None = None,
    progress: Progress = None,
    **settings: Any,
) -> dict[str, Any]:
    """Draws a picture into a file, the same bytes as ``rakelight render`` writes: .png .jpg .webp .ppm .exr .hdr, with overlays
    (``grid=True``) and channel files.

    Args:
        channels: data to be written beside the picture, by the names of :func:`rakelight.render`, each into a file or as
            ``channel_files`` says. "image" and "color" are the picture itself, which is written in any case; None: what the world says
    Returns:
        a row of ``rakelight render --json``
    """
    if os.path.splitext(os.fsdecode(name_of(path)))[1].lower() in (".mp4", ".webm", ".gif", ".apng"):
        raise UsageError("Python makes no movies; the program does: rakelight render MODEL -o FILE --turntable N")
    listed = None
    if channels is not None:
        names = names_of_channels(channels)
        listed = ",".join(name.replace("_", "-") for name in names if name not in ("image", "color")) or "none"
    scene = scene_of(scene)
    words = settings_of({**settings, **camera_settings(camera, scene.cameras), "resolution": resolution, "channels": listed})
    with told(progress) as tell:
        text, remarks = _core.render_file(scene._core, name_of(path), words, threads(), tell)
    remarks_of(remarks)
    row: dict[str, Any] = json.loads(text)["rows"][0]
    return row


def convert_file(input: Path, output: Path, *, allow_outside: bool = False, progress: Progress = None) -> dict[str, Any]:
    """Writes a model in another format: .glb, .gltf, .obj or .ply. No normal is computed, and those of the file stay as they are.

    Returns:
        a row of ``rakelight convert --json``
    """
    with told(progress) as tell:
        text, remarks = _core.convert_file(name_of(input), name_of(output), bool(allow_outside), threads(), tell)
    remarks_of(remarks)
    row: dict[str, Any] = json.loads(text)["rows"][0]
    return row


def smooth_file(
    input: Path,
    output: Path,
    *,
    normals: str = "seams",
    scope: str | None = None,
    weight: str = "auto",
    crease_angle: float | None = None,
    crease: str | None = None,
    weld_distance: float | None = None,
    border_distance: float = 0.0,
    tangents: str = "auto",
    allow_outside: bool = False,
    progress: Progress = None,
) -> dict[str, Any]:
    """Writes a model back with seam-free normals and tangents; all else of glTF, GLB and OBJ files stays as it is.

    Args:
        input, output: files; may be the same
        normals: "seams" (the file's stay, and are joined where parts meet), or made anew: "model", "object", "face"
        scope: the old name of ``normals``
        weight, crease_angle, crease, weld_distance: as of :func:`rakelight.attributes`, but ``"auto"`` is the default weight, and the
            rule of creases finds sharp edges if no angle is given
        tangents: "auto", "always", "never"
        border_distance: [m] normals also agree along borders at most this far apart that share no vertices; 0: off
    Returns:
        a row of ``rakelight smooth --json``
    """
    if not isinstance(tangents, str):
        raise UsageError(f"tangents: 'auto', 'always' or 'never' is expected, not {tangents!r:.40}")
    border_distance = number("border_distance", border_distance)
    normals = normals_word(normals, scope, "seams", ("seams", "model", "object", "face"))
    options = options_of("model" if normals == "seams" else normals, weight, crease_angle, crease, weld_distance, True, "averaged")
    with told(progress) as tell:
        text, remarks = _core.smooth_file(
            name_of(input), name_of(output), normals, tangents, border_distance, bool(allow_outside), options, threads(), tell
        )
    remarks_of(remarks)
    row: dict[str, Any] = json.loads(text)["rows"][0]
    return row


