// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/covered.h"

#include <algorithm>
#include <vector>

#include "engines/opengl/programs/programs.h"

namespace rakelight::opengl {

std::uint64_t CoveredCounter::count(const Target& of, float far_depth) {
    const int width = of.width(), height = of.height();
    glActiveTexture(GL_TEXTURE0);
    if (width != width_ || height != height_) {
        width_ = height_ = 0;
        set_texels(texels_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
        check_gl("the picture");
        width_ = width, height_ = height;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texels_.name(), 0);
    if (!program_)
        program_ = link_program(screen_text(driver_,
                                            "uniform highp sampler2D rl_depth;\nuniform float rl_far;\n"
                                            "out vec4 o_color;\nvoid main()\n{\n"
                                            "    float depth = texelFetch(rl_depth, ivec2(gl_FragCoord.xy), 0).x;\n"
                                            "    o_color = vec4(depth != rl_far ? 1.0 : 0.0);\n}\n"));
    glUseProgram(program_.name());
    glUniform1i(glGetUniformLocation(program_.name(), "rl_depth"), 0);
    glUniform1f(glGetUniformLocation(program_.name(), "rl_far"), far_depth);
    glBindTexture(GL_TEXTURE_2D, of.depth_texture());
    glBindSampler(0, 0);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_arrays_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::uint32_t> codes(std::size_t(width) * std::size_t(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
    check_gl("the picture");
    return std::uint64_t(std::ranges::count_if(codes, [](std::uint32_t code) { return code != 0; }));
}

}  // namespace rakelight::opengl
