// SPDX-License-Identifier: Apache-2.0
// The engine `gl`: the scene's equations on the GPU, or on Mesa's llvmpipe, without a window.
#pragma once
#include <memory>
#include <string>

#include <rakelight/engine.h>

namespace rakelight::opengl {

/// @throws Error failed: there is no usable OpenGL (no libEGL, no driver, too old)
std::unique_ptr<Engine> make_engine();
/// Null where no GPU draws: `why` then says so.
std::unique_ptr<Engine> make_gpu_engine(std::string& why);

}  // namespace rakelight::opengl
