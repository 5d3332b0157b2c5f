// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/features.h"

#include "base/format_text.h"

namespace rakelight::opengl {

std::string definitions_of(const Features& f) {
    std::string text;
    const auto define = [&text](const char* word, std::int32_t value) {
        text += format_text("#define RL_{} {}\n", word, value);
    };
#define RL_DEFINE(name, word) define(word, f.name);
    RL_OPENGL_FEATURES(RL_DEFINE)
#undef RL_DEFINE
    return text;
}

}  // namespace rakelight::opengl
