// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/features.h"

namespace rakelight::opengl {

std::string definitions_of(const Features& f) {
    std::string text;
    const auto define = [&text](const char* word, std::int32_t value) {
        text += std::string("#define RL_") + word + " " + std::to_string(value) + "\n";
    };
#define RL_DEFINE(name, word) define(word, f.name);
    RL_OPENGL_FEATURES(RL_DEFINE)
#undef RL_DEFINE
    return text;
}

}  // namespace rakelight::opengl
