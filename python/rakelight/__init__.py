# SPDX-License-Identifier: Apache-2.0
"""Renders 3D models made of many parts, and makes their normals and tangents without seams.

    import rakelight

    scene = rakelight.load("helmet.glb")
    rakelight.render(scene, "front", resolution=(640, 480)).save("helmet.png")
    scene.smooth(normals="model").save("smooth.glb")

Models      load, load_bytes, Scene: objects, meshes, materials; smooth, repair_seams, with_meshes, save
Pictures    render, Session (many views), render_file, Camera, Picture (arrays: image, depth, normal, object, ...), NONE
Attributes  attributes, Mesh, Attributes, smooth_file
Formats     convert_file
Reports     inspect, explain, explain_pixels, Explanation, build_info
Errors      Error: UsageError, NotFoundError, BadFileError; RakelightWarning, Remark
Settings    the options of ``rakelight render`` with ``_`` for ``-``: ``shadows=True``; set_threads

Lengths are in meters, angles in degrees, axes right-handed with +Y up, colors linear unless they are said to be sRGB, texture
coordinates v-down. Results have the same bits whatever the threads and the processor.
"""
from typing import Any

from . import _core
from ._camera import SIDES, Camera, CameraLike
from ._core import __version__
from ._errors import BadFileError, Error, NotFoundError, RakelightWarning, UsageError
from ._mesh import Attributes, Mesh, MeshLike, attributes
from ._picture import NONE, Picture
from ._reports import Explanation, convert_file, explain, explain_pixels, inspect, render_file, smooth_file
from ._run import Progress, Remark, set_threads
from ._scene import Object, Scene, load, load_bytes
from ._session import SceneLike, Session, render


def build_info() -> "dict[str, Any]":
    """What this build can do: version, engines, formats, instruction set, parts that were left out."""
    return _core.build_info()


__all__ = [
    "Attributes",
    "BadFileError",
    "Camera",
    "CameraLike",
    "Error",
    "Explanation",
    "Mesh",
    "MeshLike",
    "NONE",
    "NotFoundError",
    "Object",
    "Picture",
    "Progress",
    "RakelightWarning",
    "Remark",
    "SIDES",
    "Scene",
    "SceneLike",
    "Session",
    "UsageError",
    "__version__",
    "attributes",
    "build_info",
    "explain",
    "explain_pixels",
    "inspect",
    "load",
    "load_bytes",
    "render",
    "render_file",
    "set_threads",
    "smooth_file",
]
