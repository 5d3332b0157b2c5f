// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/screen.h"

#include <initializer_list>

namespace rakelight::opengl {

Screen Screen::current() {
    Screen s;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &s.frame);
    glGetIntegerv(GL_VIEWPORT, s.viewport);
    return s;
}

Screen Screen::with_own_state(bool is_es) {
    for (const GLenum what :
         {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_RASTERIZER_DISCARD,
          GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE})
        glDisable(what);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glBlendEquation(GL_FUNC_ADD);
    for (const GLenum what : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER}) glBindBuffer(what, 0);
    for (const GLenum what : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH,
                              GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(what, 0);
    if (!is_es) {
        glDisable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_COLOR_LOGIC_OP);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    return current();
}

void Screen::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(frame));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

}  // namespace rakelight::opengl
