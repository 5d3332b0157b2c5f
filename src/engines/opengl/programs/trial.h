// SPDX-License-Identifier: Apache-2.0
// What rakelight-shader-check does with a program: all that a driver does with it until the first pixel is there.
#pragma once
#include <functional>
#include <string>

namespace rakelight::opengl {

/// The words of its answer, before the log.
inline constexpr const char *trial_good = "good", *trial_pixels = "pixels", *trial_vertices = "vertices",
                            *trial_link = "link", *trial_no_context = "no context";

/// Compiles, links and draws one triangle: drivers generate code at the first draw.
/// @param is_ready  called when the driver has been loaded: from then on the program counts
/// @return a word of the above, a line feed, and what the driver says
std::string tried_program(const std::string& vertices, const std::string& pixels,
                          const std::function<void()>& is_ready);

}  // namespace rakelight::opengl
