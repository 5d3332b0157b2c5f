// SPDX-License-Identifier: Apache-2.0
// Texture coordinates for meshes without any.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Texture coordinates by projection about the world bounding box, for triangle meshes of a valid scene that have none;
/// reported.
Scene project_texcoords(Scene scene, UvProjection projection, Context& context);

}  // namespace rakelight
