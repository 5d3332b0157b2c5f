// SPDX-License-Identifier: Apache-2.0
// Lines over what is on the screen.
#pragma once
#include <span>

#include <rakelight/engines/line.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"
#include "engines/opengl/picture/screen.h"
#include "shading/picture_camera.h"

namespace rakelight::opengl {

class LinePass {
public:
    /// @param depth  texture of what hides them, as large as the screen, row 0 on top; 0: nothing does
    void draw(std::span<const Line> lines, const shading::PictureCamera& view, const Screen& screen, GLuint depth,
              const Driver& driver);

private:
    GlVertexArray array_;
    GlBuffer vertices_;
    GlProgram program_;
};

}  // namespace rakelight::opengl
