// SPDX-License-Identifier: Apache-2.0
// The picture that a world file asks for: its [render], and settings that override it.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// Settings that override those of a world file.
struct RenderOverrides {
    /// Each value overrides the same key in the file. A value that places the camera overrides all keys of the file
    /// that place the camera.
    std::vector<WorldValue> values{};
    /// Whether to use a setting of the file; empty: use all settings. If this function throws an Error, the error gets
    /// the line and column of the setting.
    std::function<bool(std::string_view key)> accepts{};
};

/// The picture of a world file, and its settings.
struct WorldRequest {
    PictureRequest picture{};           ///< picture.load.overridden lists the overridden keys
    std::vector<WorldValue> applied{};  ///< applied settings of the file's [render], with resolved file names
};

/// Reads [render] of a world file and applies `overrides`. File names are relative to the world's folder. The caller
/// sets the output.
/// @throws Error not_found; bad_file, with the file, line and column of the fault; usage: an override is invalid or
///         conflicts with a setting of the file
RL_API WorldRequest read_world_request(const std::string& path, const LoadOptions& options,
                                       const RenderOverrides& overrides, Context& context);
/// The same without overrides.
RL_API PictureRequest request_of_world(const std::string& path, const LoadOptions& options, Context& context);

/// The error with the line and column of its setting, if it is about a setting of the file. Otherwise the same error.
RL_API Error at_world_value(const Error& error, const WorldRequest& world);

/// Whether settings contain the key "preset". If such settings override those of a world file, all keys of
/// is_preset_key() in the file are ignored.
RL_API bool sets_preset(std::span<const WorldValue> settings);
/// Whether settings define the shading of the whole picture. If such settings override those of a world file, the
/// shading of its materials and parts is ignored (RenderSettings::material_shading).
RL_API bool sets_shading(std::span<const WorldValue> settings);

}  // namespace rakelight
