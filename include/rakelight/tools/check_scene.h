// SPDX-License-Identifier: Apache-2.0
// What a scene file holds, for people who want to know whether it loads: `rakelight check`.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/error.h>
#include <rakelight/export.h>
#include <rakelight/picture.h>
#include <rakelight/report.h>
#include <rakelight/scene.h>

namespace rakelight {

/// How much there is of a scene.
struct SceneSummary {
    bool is_world = false;                                 ///< it came from a world file
    std::uint64_t objects = 0, meshes = 0, triangles = 0;  ///< objects and triangles: instances counted each time
    std::uint64_t materials = 0, textures = 0, skins = 0, animations = 0;  ///< as many as the tables of the scene have
    std::vector<std::string> parts{};               ///< of a world: names of its models and primitives
    std::vector<std::string> cameras{};             ///< names, by number
    std::vector<std::string> lights{};              ///< "photometric point 'lamp'", "ambient"
    bool has_fog = false, has_environment = false;  ///< whether there are such
};

/// Counts what is in a scene.
RL_API SceneSummary summarize(const Scene& scene);

/// Whether the picture that is asked of a loaded scene can be drawn, as far as can be told without drawing it.
/// @throws Error usage: its shadow maps are too large for the context's memory
RL_API void check_picture(const Scene& scene, const PictureRequest& request, Context& context);

/// A few lines for people. @param file  as the caller named it
RL_API std::string to_text(const std::string& file, const SceneSummary& summary);

}  // namespace rakelight
