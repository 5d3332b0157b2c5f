// SPDX-License-Identifier: Apache-2.0
// A program of two texts, compiled and linked: by the engine, and before that in a process of its own (shader_check.h).
#pragma once
#include <optional>
#include <span>
#include <string>

#include "engines/opengl/context/gl_objects.h"

namespace rakelight::opengl {

/// What the driver says is wrong.
struct CompileFault {
    enum class Part { pixels, vertices, both };  ///< both: they do not link
    Part part = Part::both;
    std::string log;  ///< at most 4096 bytes, of any kind
};

struct StageTexts {
    const std::string& vertices;
    const std::string& pixels;
};

/// @param caught  what transform feedback catches of the vertices, a buffer each
/// @return none: the program is good
std::optional<CompileFault> compile_program(GLuint program, const StageTexts& texts,
                                            std::span<const char* const> caught = {});

bool is_linked(GLuint program);

}  // namespace rakelight::opengl
