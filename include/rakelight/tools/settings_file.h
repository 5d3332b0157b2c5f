// SPDX-License-Identifier: Apache-2.0
// Configurations: TOML files with [render] alone, whose settings are for any model.
#pragma once
#include <string>

#include <rakelight/export.h>
#include <rakelight/request.h>

namespace rakelight {

/// What a configuration says, as read_world_request() reads a world: `taken` are the settings that `overrides` leave, and
/// at_world_value() finds their places.
/// @throws Error not_found, bad_file: with the file, line and column of what is wrong; usage: as read_world_request()
RL_API WorldRequest read_settings_file(const std::string& path, const LoadOptions& options,
                                       const RenderOverrides& overrides, Context& context);

}  // namespace rakelight
