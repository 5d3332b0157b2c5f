// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

namespace rakelight::opengl {

/// What of the caller's is bound: pictures end there.
struct Screen {
    GLint frame = 0, viewport[4]{};  ///< [px] x, y up, width, height

    static Screen current();  ///< of the current context
    /// With what this library takes for granted of a context, whatever the caller set before.
    static Screen with_own_state(bool is_es);
    int width() const { return viewport[2]; }
    int height() const { return viewport[3]; }
    void bind() const;
};

}  // namespace rakelight::opengl
