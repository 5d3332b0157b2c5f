// SPDX-License-Identifier: Apache-2.0
// Words of other programs for what ours call otherwise: they are answered by our name, never by the nearest spelling.
#pragma once
#include <string_view>
#include <vector>

namespace rakelight::apps {

/// "camera-view-angle" for "fov"; those of all commands.
std::vector<std::string_view> our_options_for(std::string_view theirs);

/// "compare" for "diff"; empty: there is none.
std::string_view our_command_for(std::string_view theirs);

}  // namespace rakelight::apps
