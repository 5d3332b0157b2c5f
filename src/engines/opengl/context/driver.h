// SPDX-License-Identifier: Apache-2.0
// What the driver of the current context is and can do. Queried once per context.
#pragma once
#include <string>

#include <rakelight/engines/engine.h>

namespace rakelight::opengl {

struct Driver {
    bool is_es = false;               ///< OpenGL ES 3.0, else OpenGL 3.3 core
    std::string renderer;             ///< GL_RENDERER
    std::string identity;             ///< vendor, renderer and version: what binary programs depend on
    bool is_software = false;         ///< llvmpipe and the like: no GPU
    bool poses_meshes = true;         ///< skins and morph targets by the driver (poses.h), not by the processor
    bool has_reversed_depth = false;  ///< glClipControl: depth 0..1, so that reversed floats keep their precision
    bool has_sample_mask = false;     ///< fragments know which of their samples are covered
    bool has_timer = false;
    bool has_program_binaries = false;
    bool filters_floats = false;  ///< textures of 32-bit floats can be filtered
    int texture_units = 16;       ///< in a fragment shader
    int texture_size = 4096;      ///< [texels] a side
    int picture_size = 4096;      ///< [px] a side of what can be drawn at once
    int samples = 1;              ///< most a pixel of half floats
};

/// @throws Error failed: the context is too old, or cannot draw half floats
Driver ask_driver();

/// What pictures of this driver can show.
EngineCapabilities abilities_of(const Driver& driver);

/// @throws Error failed: what GL_OUT_OF_MEMORY or another error of the calls before says of `what`
void check_gl(const char* what);

}  // namespace rakelight::opengl
