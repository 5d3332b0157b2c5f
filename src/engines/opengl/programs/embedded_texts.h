// SPDX-License-Identifier: Apache-2.0
// The GLSL files as the build found them (cmake/EmbedText.cmake).
#pragma once
#include <span>
#include <string_view>

namespace rakelight::opengl {

struct EmbeddedText {
    std::string_view path;  ///< below src/
    std::string_view text;
};
extern const std::span<const EmbeddedText> embedded_texts;

}  // namespace rakelight::opengl
