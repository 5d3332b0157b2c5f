// SPDX-License-Identifier: Apache-2.0
// Scene -> scene, before an engine sees it: texture coordinates, normals and tangents. Untouched blocks are shared.
#pragma once
#include <rakelight/attributes.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Whose normals count. `automatic`: the file's where it has them; else flat for formats that say so (glTF); else smoothing
/// groups where the file has any; else over the model with the crease angle.
enum class NormalSource : std::uint8_t { automatic, file, flat, object, model };

enum class UvProjection : std::uint8_t { none, box, sphere, cylinder };

struct PrepareOptions {
    NormalSource normals = NormalSource::automatic;
    CornerWeight weight = CornerWeight::angle;
    double crease_angle_rad = radians(60);
    UvProjection uv = UvProjection::none;  ///< for meshes without texture coordinates
};

/// A scene that an engine can draw: every triangle mesh has finite unit normals, and tangents where a normal or height map
/// needs them. Says in the report what it replaced (zero or non-finite normals of the file, w = 0 tangents, ...).
Scene prepare_scene(const Scene& scene, const PrepareOptions& options, Context& context);

/// Texture coordinates by projection about the world bounding box, for triangle meshes that have none; said in the report.
Scene project_texcoords(const Scene& scene, UvProjection projection, Context& context);

/// Normals and tangents by the door of <rakelight/attributes.h> over the whole scene.
struct SmoothSceneOptions {
    AttributeOptions attributes;
    bool only_missing = false;  ///< keep normals that are there; make the others
};
Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context);

/// The Utah teapot from Newell's 32 Bezier patches, as six objects (rim, body, handle, spout, lid, bottom) with their
/// patch u, v; no normals (prepare makes them). `divisions` quads a side of each patch, 1..256.
Scene make_teapot(int divisions = 10);

}  // namespace rakelight
