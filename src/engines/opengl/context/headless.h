// SPDX-License-Identifier: Apache-2.0
// A context without a window, by EGL: on the GPU, or on Mesa's llvmpipe where there is none.
#pragma once
#include <memory>

namespace rakelight::opengl {

class HeadlessContext {
public:
    /// Makes one and makes it current on the calling thread, which alone may use it from then on.
    /// OpenGL 3.3 core, else OpenGL ES 3.0; RAKELIGHT_GL=es asks for the latter.
    /// @throws Error failed: no usable libEGL, no display, no context
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight::opengl
