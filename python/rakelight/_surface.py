# SPDX-License-Identifier: Apache-2.0
"""Colors and textures of other libraries' meshes."""
from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import UsageError

_DEFAULT_DIFFUSE = (102, 102, 102, 255)
"""What trimesh has for a color that nobody gave."""

_FACTORS = ("metallicFactor", "roughnessFactor", "emissiveFactor")
_MAPS = ("metallicRoughnessTexture", "normalTexture", "occlusionTexture", "emissiveTexture")


@dataclass
class Surface:
    """What was found. Colors are linear RGBA. ``corner_...`` have a row for each corner of each face: such a mesh must be split."""

    colors: NDArray[Any] | None = None
    corner_colors: NDArray[Any] | None = None
    corner_uv: NDArray[Any] | None = None
    color: NDArray[Any] | None = None
    texture: NDArray[Any] | None = None
    dropped: list[str] = field(default_factory=list)
    """What is not taken over, in words."""


def linear(codes: NDArray[Any]) -> NDArray[np.float32]:
    """sRGB codes, integers 0..255 or floats 0..1, as linear light; a fourth column is alpha."""
    c = codes.astype(np.float64) / (255.0 if codes.dtype.kind in "iub" else 1.0)
    rgb = c[..., :3]
    out = np.array(c)
    out[..., :3] = np.where(rgb <= 0.04045, rgb / 12.92, ((np.maximum(rgb, 0.04045) + 0.055) / 1.055) ** 2.4)
    return out.astype(np.float32)


def _rows(values: Any, count: int, what: str, found: Surface) -> NDArray[Any] | None:
    """[count, 4] linear; None, and said, where there is not one color for each."""
    try:
        array = np.asarray(values)
        if array.shape in ((3,), (4,)):
            array = np.tile(array, (count, 1))
        if array.shape in ((count, 3), (count, 4)) and array.dtype.kind in "iuf":
            out = linear(array)
            return out if out.shape[1] == 4 else np.concatenate([out, np.ones((count, 1), np.float32)], axis=1)
    except ValueError:  # rows of several lengths
        pass
    found.dropped.append(f"its {what} are not one color for each")
    return None


def _pixels(image: Any) -> NDArray[np.uint8] | None:
    """[H, W, 3 or 4] of a picture of PIL or of an array; None: it is neither."""
    if hasattr(image, "convert"):
        has_alpha = "A" in getattr(image, "mode", "RGB") or "transparency" in getattr(image, "info", {})
        image = image.convert("RGBA" if has_alpha else "RGB")
    array = np.asarray(image)
    return array if array.dtype == np.uint8 and array.ndim in (2, 3) and array.size > 0 else None


def _take_texture(image: Any, has_uv: bool, found: Surface) -> None:
    if image is None:
        return
    if not has_uv:
        found.dropped.append("its texture, because it has no texture coordinates")
        return
    found.texture = _pixels(image)
    if found.texture is None:
        found.dropped.append("its texture is no picture of 8 bits")


def _of_material(material: Any, has_uv: bool, found: Surface) -> None:
    """Of trimesh: PBRMaterial has linear factors, SimpleMaterial has codes of sRGB."""
    is_physical = hasattr(material, "baseColorTexture")
    _take_texture(material.baseColorTexture if is_physical else getattr(material, "image", None), has_uv, found)
    factor = getattr(material, "baseColorFactor" if is_physical else "diffuse", None)
    if factor is not None and is_physical:
        array = np.asarray(factor)
        found.color = (array / (255.0 if array.dtype.kind in "iu" else 1.0)).astype(np.float32)
    elif factor is not None and found.texture is None and tuple(np.asarray(factor).tolist()) != _DEFAULT_DIFFUSE:
        found.color = linear(np.asarray(factor))
    if is_physical and found.texture is not None and getattr(material, "alphaMode", None) in (None, "OPAQUE") and found.texture.ndim == 3:
        found.texture = np.ascontiguousarray(found.texture[:, :, :3])
    left = [name for name in (*_MAPS, *_FACTORS) if getattr(material, name, None) is not None and np.size(getattr(material, name)) > 0]
    left = [name for name in left if name != "emissiveFactor" or np.any(np.asarray(material.emissiveFactor))]
    if getattr(material, "alphaMode", None) == "MASK":
        left.append("alphaMode")
    if hasattr(material, "materials"):
        left.append(f"its {len(material.materials)} materials")
    if left:
        found.dropped.append(f"of its material {', '.join(left)}")


def _of_trimesh(visual: Any, vertices: int, faces: int, has_uv: bool, found: Surface) -> None:
    kind = getattr(visual, "kind", "unknown")  # None: what vertex_colors says is made up
    if kind in ("vertex", "unknown") and getattr(visual, "vertex_colors", None) is not None:
        found.colors = _rows(visual.vertex_colors, vertices, "vertex colors", found)
    elif kind in ("face", "unknown") and getattr(visual, "face_colors", None) is not None:
        colors = _rows(visual.face_colors, faces, "face colors", found)
        found.corner_colors = None if colors is None else np.repeat(colors, 3, axis=0)
    if kind in ("texture", "unknown") and getattr(visual, "material", None) is not None:
        _of_material(visual.material, has_uv, found)


def _of_open3d(thing: Any, vertices: int, faces: int, found: Surface) -> None:
    colors = getattr(thing, "vertex_colors", None)
    if colors is not None and len(colors) > 0:
        found.colors = _rows(colors, vertices, "vertex colors", found)
    textures = getattr(thing, "textures", None)
    if textures is None or len(textures) == 0:
        return
    ids = set(np.asarray(getattr(thing, "triangle_material_ids", [])).ravel().tolist()) or {0}
    uv = np.asarray(getattr(thing, "triangle_uvs", []), dtype=np.float64)
    if uv.shape != (3 * faces, 2):
        found.dropped.append("its textures have no coordinates for each corner")
    elif len(ids) > 1 or not 0 <= min(ids) < len(textures):
        found.dropped.append(f"its {len(textures)} textures are of several materials")
    else:
        found.corner_uv = uv  # their row 0 is at v = 0: pictures are turned over as they are read
        _take_texture(textures[min(ids)], True, found)


def surface_of(thing: Any, vertices: int, faces: int, has_uv: bool) -> Surface:
    """What a mesh of trimesh or Open3D has. ``has_uv``: texture coordinates of its vertices."""
    found = Surface()
    if getattr(thing, "visual", None) is not None:
        _of_trimesh(thing.visual, vertices, faces, has_uv, found)
    else:
        _of_open3d(thing, vertices, faces, found)
    if found.color is None and (found.colors is not None or found.corner_colors is not None):
        found.color = np.ones(3, np.float32)
    return found


def png_of(pixels: Any, name: str) -> bytes:
    """A texture as a file."""
    array = np.asarray(pixels)
    if array.ndim == 2:
        array = array[:, :, None]
    if array.dtype != np.uint8 or array.ndim != 3 or array.shape[2] not in (1, 3, 4) or array.size == 0:
        raise UsageError(f"{name}: uint8 of the shape (H, W), (H, W, 3) or (H, W, 4) is expected, not {array.dtype} of {np.shape(pixels)}")
    height, width, channels = array.shape
    rows = np.zeros((height, 1 + width * channels), np.uint8)  # each begins with its filter: none
    rows[:, 1:] = array.reshape(height, -1)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + chunk(b"IEND", b"")


def has_alpha(color: Any, colors: Any, texture: Any) -> bool:
    """Whether something of it is transparent."""
    if color is not None and np.size(color) == 4 and np.asarray(color).ravel()[3] < 1:
        return True
    if colors is not None and np.size(colors) > 0 and np.ndim(colors) == 2 and np.asarray(colors)[:, 3].min() < 1:
        return True
    return texture is not None and np.ndim(texture) == 3 and np.shape(texture)[2] == 4 and bool(np.asarray(texture)[:, :, 3].min() < 255)
