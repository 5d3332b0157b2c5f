// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/marks.h"

#include <functional>
#include <vector>

namespace rakelight::opengl {
namespace {

enum Kind { kind_lines, kind_points, kind_edges, kind_vertices };
enum Shape { shape_line, shape_square, shape_disc };

struct PlannedMark {
    const shading::Draw* draw;
    PictureDrawer::Mark mark;
};

vec4 color_of(const shading::DrawMaterial& m) {
    const float* const c = m.factors.base_color;
    return {c[0] + m.factors.emission[0], c[1] + m.factors.emission[1], c[2] + m.factors.emission[2],
            m.factors.blend ? c[3] : 1.0f};
}

/// In the order of the scene: its lines and points, edges, vertices.
std::vector<PlannedMark> plan(const shading::DrawList& list, const RenderSettings& s) {
    std::vector<PlannedMark> out;
    const int point = s.points == PointShape::square ? shape_square : shape_disc;
    const auto own = [&](const shading::Draw& draw, int kind, int shape, float size) {
        const bool has_colors = !list.scene.meshes[draw.mesh].colors.empty();
        out.push_back({&draw, {kind, shape, size, color_of(list.material(draw)), has_colors}});
    };
    for (const shading::Draw& draw : list.line_draws) {
        const bool is_line = list.scene.meshes[draw.mesh].topology == Topology::lines;
        own(draw, is_line ? kind_lines : kind_points, is_line ? shape_line : point,
            is_line ? s.line_width : s.point_size);
    }
    const bool is_over = s.surfaces && s.line_color.w == 0;
    const vec4 color = is_over ? vec4{0, 0, 0, 1} : s.line_color;
    const auto of_triangles = [&](int kind, int shape, float size) {
        for (const shading::Draw& draw : list.draws)
            if (color.w > 0)
                out.push_back({&draw, {kind, shape, size, color, false}});
            else
                own(draw, kind, shape, size);
    };
    if (s.edges) of_triangles(kind_edges, shape_line, s.line_width);
    if (s.points != PointShape::none) of_triangles(kind_vertices, point, s.point_size);
    return out;
}

bool are_of_one_color(const std::vector<PlannedMark>& marks) {
    for (const PlannedMark& m : marks)
        if (m.mark.has_vertex_colors || !(m.mark.color == marks[0].mark.color)) return false;
    return true;
}

ProgramText lay_text(const Driver& driver) {
    ProgramText text = display_text(driver, -1);
    text.pixels = (driver.is_es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n") +
                  std::string(
                      "uniform highp sampler2D rl_picture;\nout vec4 o_color;\nvoid main() { o_color = "
                      "texelFetch(rl_picture, ivec2(gl_FragCoord.xy), 0); }\n");
    return text;
}

}  // namespace

bool Marks::are_in(const shading::DrawList& list, const RenderSettings& s) {
    return !list.line_draws.empty() || s.edges || s.points != PointShape::none;
}

void Marks::draw(const PictureDrawer& drawer, const PictureState& state, const Target& to) {
    const std::vector<PlannedMark> marks = plan(state.list, state.settings);
    if (marks.empty()) return;
    const bool in_layer = are_of_one_color(marks);
    if (in_layer && (width_ != to.width() || height_ != to.height())) {
        width_ = to.width(), height_ = to.height();
        layer_.reset(), layer_frame_.reset();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, layer_.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width_, height_, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, layer_frame_.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer_.name(), 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, in_layer ? layer_frame_.name() : to.color_frame());
    constexpr GLfloat nothing[4] = {0, 0, 0, 0};
    if (in_layer) glClearBufferfv(GL_COLOR, 0, nothing);
    glViewport(0, 0, to.width(), to.height());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(in_layer ? GL_MAX : GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const PlannedMark& m : marks) drawer.draw_marks(*m.draw, m.mark, Output::color, to.depth_texture());
    glBlendEquation(GL_FUNC_ADD);
    if (in_layer) {
        if (!lay_) lay_ = link_program(lay_text(drawer.driver()));
        glBindFramebuffer(GL_FRAMEBUFFER, to.color_frame());
        glUseProgram(lay_.name());
        glUniform1i(glGetUniformLocation(lay_.name(), "rl_picture"), 0);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, layer_.name());
        glBindSampler(0, 0);
        glBindVertexArray(no_arrays_.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_BLEND);
    check_gl("lines and points");
}

void Marks::draw_channels(const PictureDrawer& drawer, const PictureState& state, Output group, const Target& from,
                          float far_depth) const {
    if (group == Output::count) return;
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);  // they are hidden by surfaces with a tolerance, by one another without
    for (const PlannedMark& m : plan(state.list, state.settings))
        if (m.mark.color.w >= 1) drawer.draw_marks(*m.draw, m.mark, group, from.depth_texture());
}

}  // namespace rakelight::opengl
