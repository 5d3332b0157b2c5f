// SPDX-License-Identifier: Apache-2.0
// Configuration files: TOML files with only the section [render], for any model.
#pragma once
#include <string>

#include <rakelight/base/export.h>
#include <rakelight/world/world_request.h>

namespace rakelight {

/// Reads a configuration file like read_world_request(). In the result, `applied` has the settings of the file that
/// `overrides` do not replace. at_world_value() adds the place of such a setting to an error.
/// @throws Error not_found; bad_file, with file, line and column; usage: as read_world_request()
RL_API WorldRequest read_settings_file(const std::string& path, const LoadOptions& options,
                                       const RenderOverrides& overrides, Context& context);

}  // namespace rakelight
