// SPDX-License-Identifier: Apache-2.0
// A summary of a scene file: `rakelight check`.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/export.h>
#include <rakelight/base/report.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/scene.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// Counts of a scene.
struct SceneSummary {
    bool is_world = false;                                 ///< loaded from a world file
    std::uint64_t objects = 0, meshes = 0, triangles = 0;  ///< objects and triangles count each instance
    std::uint64_t materials = 0, textures = 0, skins = 0, animations = 0;  ///< sizes of the scene's tables
    std::vector<std::string> parts{};               ///< world files: names of models and primitives
    std::vector<std::string> cameras{};             ///< names, by index
    std::vector<std::string> lights{};              ///< "photometric point 'lamp'", "ambient"
    bool has_fog = false, has_environment = false;  ///< present
};

/// Counts the contents of a scene.
RL_API SceneSummary summarize(const Scene& scene);

/// Checks whether a picture of a loaded scene can be drawn, as far as this is possible without drawing.
/// @throws Error usage: the shadow maps of the picture are too large for the context's memory budget
RL_API void check_picture(const Scene& scene, const PictureRequest& request, Context& context);

/// A few readable lines.
/// @param file as the caller named it
RL_API std::string to_text(const std::string& file, const SceneSummary& summary);

/// A row of `check --json`.
struct CheckRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<SceneSummary> summary{};
};

/// {"schema": "rakelight.check/1", "rows": [...]}
RL_API std::string to_json(std::span<const CheckRow> rows);

}  // namespace rakelight
