// SPDX-License-Identifier: Apache-2.0
// The way of a scene to the GPU, in two steps: what the processor does, on any thread, and the uploads, piece by piece.
#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "engines/opengl/scene/environment.h"
#include "engines/opengl/scene/meshes.h"
#include "engines/opengl/scene/textures.h"
#include "geometry/pose/mesh_pose.h"
#include "shading/draw_list.h"

namespace rakelight::opengl {

/// A scene as pictures are drawn of it, with its pictures decoded.
struct TakenScene {
    shading::DrawList list;
    shading::TextureCache cache;
    shading::EnvironmentCache environments;
    std::optional<shading::UsedEnvironment> environment;
    geometry::MeshPoses poses;  ///< of meshes that are in bind pose yet
};

/// A scene as it comes to be drawn.
struct GivenScene {
    Scene scene;
    std::shared_ptr<const geometry::MeshPoses> poses{};  ///< as Engine::prepare_unposed() has them
};

/// From any thread.
/// @param poses_here  the poses are taken by the processor, for a driver that would be slower
/// @param before  what was decoded for the scene before: what is used again is not decoded again
/// @throws Error failed: cancelled
TakenScene take_scene(GivenScene given, bool poses_here, shading::TextureCache cache,
                      shading::EnvironmentCache environments, Context& context);

/// What a scene's materials read.
std::vector<TextureStore::Wish> wishes_of(const shading::DrawList& list, const shading::TextureCache& cache);

using Clock = std::chrono::steady_clock;

/// Uploads textures and meshes until the time is over, something at least. @return all of them are there
bool upload_some(const TakenScene& scene, TextureStore& textures, MeshStore& meshes, Clock::time_point end,
                 Context& context);

}  // namespace rakelight::opengl
