// SPDX-License-Identifier: Apache-2.0
// The engine `gl`: the scene's equations on the GPU, or on Mesa's llvmpipe, without a window.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight::opengl {

/// @throws Error failed: there is no usable OpenGL (no libEGL, no driver, too old)
std::unique_ptr<Engine> make_engine();
/// Null where no GPU draws: `why` then says so.
std::unique_ptr<Engine> make_gpu_engine(std::string& why);

/// What the lighting text of the user declares as terms, at a pixel of the picture that was drawn last.
/// @param engine  of make_engine()
/// @return of up to eight lights, in their order
std::vector<std::array<vec4, 4>> user_terms(Engine& engine, int x, int y, Context& context);

}  // namespace rakelight::opengl
