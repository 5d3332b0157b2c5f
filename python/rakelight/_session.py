# SPDX-License-Identifier: Apache-2.0
"""Pictures."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NoReturn, Union

from . import _core
from ._camera import CameraLike, camera_settings
from ._errors import UsageError, usage_error
from ._mesh import Mesh
from ._numbers import MAX_MEMORY, whole
from ._picture import Picture
from ._run import Path, Progress, remarks_of, settings_of, threads, told
from ._scene import Scene, scene_of

SceneLike = Union[Scene, Path, Mesh, Any]
"""A :class:`Scene`, a file's name, or what :meth:`Scene.from_meshes` takes."""

Resolution = Sequence[int]
Window = Sequence[int]


def names_of_channels(channels: Sequence[str] | str) -> list[str]:
    names = [channels] if isinstance(channels, str) else list(channels) if isinstance(channels, Iterable) else []
    if not names or not all(isinstance(name, str) for name in names):
        raise UsageError("channels: a name or several are expected, such as 'image'")
    return names


def _channels(channels: Sequence[str] | str) -> tuple[int, bool, bool]:
    names = names_of_channels(channels)
    bits = 0
    for name in names:
        if name not in ("image", "color"):
            bits |= _core.channel_bits(name.replace("_", "-"))
    return bits, "image" in names, "color" in names


class Session:
    """Many pictures of one scene: what was made for one is kept for the next. One thread at a time; a session for each thread.

    What nobody names (light, samples, background, exposure) is decided at the first picture, as the program decides it, and stays.

        session = rakelight.Session("model.glb", resolution=(256, 256))
        for camera in cameras:
            picture = session.render(camera, channels=["image", "depth"])

    Args:
        scene: a :class:`Scene`, a file's name, or meshes
        resolution: (width, height) [px] of pictures that name none; None: 1280 x 720
        max_memory: [bytes] that textures may ask for; 0: 2 GiB
        settings: the options of ``rakelight render`` with ``_`` for ``-``: ``shadows=True``, ``samples=8``, ``background="white"``,
            ``light=["point:0,2,3", "ambient:0.1,0.1,0.1"]``
    Raises:
        UsageError: a setting that is not there, with the nearest that is; a value that it cannot have
    """

    def __init__(
        self, scene: SceneLike, *, resolution: Resolution | None = None, max_memory: int = 0, **settings: Any
    ) -> None:
        self.scene = scene_of(scene)
        _refuse(settings)
        words = settings_of({"resolution": resolution, **settings})
        self._core = _core.Session(self.scene._core, words, threads(), whole("max_memory", max_memory, 0, MAX_MEMORY))

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Session cannot be pickled: make one in each process")

    def render(
        self,
        camera: CameraLike = None,
        *,
        resolution: Resolution | None = None,
        window: Window | None = None,
        channels: Sequence[str] | str = ("image",),
        progress: Progress = None,
        **others: NoReturn,
    ) -> Picture:
        """Draws one view. Arguments: :func:`rakelight.render`, but no settings: they are the session's."""
        for name in others:
            settings_of({name: None})  # refused where there is none
            raise usage_error(name, "is no argument of a session's render()", "settings are arguments of Session(scene, ...)")
        bits, has_image, has_color = _channels(channels)
        view = settings_of({**camera_settings(camera, self.scene.cameras), "resolution": resolution, "window": window})
        with told(progress) as tell:
            drawn = self._core.render(view, bits, has_image, has_color, tell)
        remarks_of(self._core.take_remarks())
        return Picture(drawn)


def _refuse(settings: dict[str, Any]) -> None:
    for name in ("channels", "channel_files", "window"):
        if name in settings:
            raise UsageError(f"{name}: is for render(), not for a session or a file")


def render(
    scene: SceneLike,
    camera: CameraLike = None,
    *,
    resolution: Resolution | None = None,
    window: Window | None = None,
    channels: Sequence[str] | str = ("image",),
    progress: Progress = None,
    **settings: Any,
) -> Picture:
    """Draws a picture: the same pixels, to the bit, as ``rakelight render`` writes with the same settings.

    Args:
        scene: a :class:`Scene`, a file's name, or meshes
        camera: a :class:`Camera`; a side ("front", "isometric", ...); a camera of the file by name or number; None: the file's first, or one
            that shows all
        resolution: (width, height) [px]; None: 1280 x 720
        window: (x, y, width, height) [px] the part of the picture that is drawn
        channels: what the result has, row 0 on top:

            - image: [H, W, 3] uint8, sRGB; [H, W, 4] with ``background="transparent"``
            - color: [H, W, 4] float32, linear RGB and alpha
            - depth: [H, W] float32 [m] along the view axis; infinity where nothing is
            - normal, face_normal: [H, W, 3] float32, unit, world; tangent: [H, W, 4]
            - position: [H, W, 3] float32 [m] world
            - object, mesh, material, triangle: [H, W] uint32; :data:`NONE` where nothing is; overdraw: [H, W] uint32
            - uv, uv1: [H, W, 2] float32; barycentric: [H, W, 3] float32
            - base_color, ambient, diffuse, specular, emission: [H, W, 3] float32, linear; "lighting": the last four; "all": all so far but image
              and color
            - ambient_occlusion: [H, W] float32, with ``ambient_occlusion=True``; of ``engine="trace", method="path"``: albedo, direct,
              indirect: [H, W, 3] float32, variance: [H, W]; "paths": these four
        settings: as :class:`Session`
    Raises:
        UsageError, NotFoundError, BadFileError
    """
    session = Session(scene, resolution=resolution, **settings)
    return session.render(camera, window=window, channels=channels, progress=progress)
