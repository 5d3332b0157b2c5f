// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/marks.h"

#include <vector>

#include "shading/mark_color.h"

namespace rakelight::opengl {
namespace {

using Mark = PictureDrawer::Mark;

/// In the order of the scene: its lines and points, edges, vertices.
std::vector<Marks::Planned> plan(const shading::DrawList& list, const RenderSettings& s) {
    std::vector<Marks::Planned> out;
    const Mark::Shape point = s.points == PointShape::square ? Mark::square : Mark::disc;
    const auto own = [&](const shading::Draw& draw, Mark::Kind kind, Mark::Shape shape, float size) {
        const bool has_colors = !list.scene.meshes[draw.mesh].colors.empty();
        out.push_back({&draw, {kind, shape, size, shading::mark_color(list.material(draw)), has_colors}});
    };
    for (const shading::Draw& draw : list.line_draws) {
        const bool is_line = list.scene.meshes[draw.mesh].topology == Topology::lines;
        own(draw, is_line ? Mark::lines : Mark::points, is_line ? Mark::line : point,
            is_line ? s.line_width : s.point_size);
    }
    const bool is_over = s.surfaces && s.line_color.w == 0;
    const vec4 color = is_over ? vec4{0, 0, 0, 1} : s.line_color;
    const auto of_triangles = [&](Mark::Kind kind, Mark::Shape shape, float size) {
        for (const shading::Draw& draw : list.draws)
            if (color.w > 0)
                out.push_back({&draw, {kind, shape, size, color, false}});
            else
                own(draw, kind, shape, size);
    };
    if (s.edges) of_triangles(Mark::edges, Mark::line, s.line_width);
    if (s.points != PointShape::none) of_triangles(Mark::vertices, point, s.point_size);
    return out;
}

constexpr float least_filling = 3;  ///< [px] of points: few pixels lie in smaller ones as a whole

bool is_colored_point(const Mark& m) { return m.shape != Mark::line && m.has_vertex_colors; }

bool are_of_one_color(const Mark& a, const Mark& b) {
    return !a.has_vertex_colors && !b.has_vertex_colors && a.color == b.color;
}

constexpr const char* lay_text =
    "uniform highp sampler2D rl_picture;\nout vec4 o_color;\nvoid main()\n{\n"
    "    o_color = texelFetch(rl_picture, ivec2(gl_FragCoord.xy), 0);\n"
    "    if (o_color.w == 0.0) {\n        discard;  // not counted\n    }\n}\n";

}  // namespace

bool Marks::are_in(const shading::DrawList& list, const RenderSettings& s) {
    return !list.line_draws.empty() || s.edges || s.points != PointShape::none;
}

void Marks::reserve(const Target& to) {
    if (width_ != to.width() || height_ != to.height()) {
        width_ = height_ = 0;
        glActiveTexture(GL_TEXTURE0);
        set_texels(layer_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, to.width(), to.height());
        glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, to.width(), to.height());
        check_gl("lines and points");
        width_ = to.width(), height_ = to.height();
    }
    const auto attach = [this](GlFramebuffer& frame, GLuint colors) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colors, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    };
    attach(over_frame_, to.texture());
    attach(layer_frame_, layer_.name());
}

/// Where opaque marks hold the middles of pixels, they hide those behind them. Points of many colors hold
/// whole pixels, lest what is behind a cloud shows through the pixels of their borders.
void Marks::draw_depth(const PictureDrawer& drawer, std::span<const Planned> marks, const Target& to) {
    const DepthRange range(drawer.driver());
    const GLfloat far = range.far_depth();
    constexpr GLenum none = GL_NONE, all = GL_COLOR_ATTACHMENT0;
    glBindFramebuffer(GL_FRAMEBUFFER, layer_frame_.name());
    glDrawBuffers(1, &none);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(range.nearer());
    glClearBufferfv(GL_DEPTH, 0, &far);
    for (const Planned& m : marks) {
        if (m.mark.color.w < 1) continue;
        Mark holding = m.mark;
        holding.fills = is_colored_point(m.mark) && m.mark.size >= least_filling;
        drawer.draw_marks(*m.draw, holding, Output::numbers, to.depth_texture());
    }
    glDrawBuffers(1, &all);
    glDepthMask(GL_FALSE);
    glDepthFunc(range.not_farther());
}

/// Marks of one color, or one draw's of many.
void Marks::draw_run(const PictureDrawer& drawer, std::span<const Planned> run, const Target& to, PassMeter& meter) {
    const bool in_layer = !run[0].mark.has_vertex_colors;
    glBindFramebuffer(GL_FRAMEBUFFER, in_layer ? layer_frame_.name() : over_frame_.name());
    constexpr GLfloat nothing[4] = {0, 0, 0, 0};
    if (in_layer) glClearBufferfv(GL_COLOR, 0, nothing);
    glBlendEquation(in_layer ? GL_MAX : GL_FUNC_ADD);
    {
        const PassMeter::Pass pass(meter, pass_name, !in_layer);
        const DepthRange range(drawer.driver());
        if (!in_layer && is_colored_point(run[0].mark) && run[0].mark.size < least_filling) {
            glDepthFunc(range.farther());  // what is hidden shows through the borders of what is not
            drawer.draw_marks(*run[0].draw, run[0].mark, Output::color, to.depth_texture());
            glDepthFunc(range.not_farther());
        }
        for (const Planned& m : run) drawer.draw_marks(*m.draw, m.mark, Output::color, to.depth_texture());
    }
    glBlendEquation(GL_FUNC_ADD);
    if (in_layer) lay(to, drawer.driver(), meter);
}

void Marks::lay(const Target& to, const Driver& driver, PassMeter& meter) {
    if (!lay_) lay_ = link_program(screen_text(driver, lay_text));
    glBindFramebuffer(GL_FRAMEBUFFER, to.color_frame());  // without depth: nothing is tested
    glUseProgram(lay_.name());
    glUniform1i(glGetUniformLocation(lay_.name(), "rl_picture"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, layer_.name());
    glBindSampler(0, 0);
    glBindVertexArray(no_arrays_.get());
    const PassMeter::Pass pass(meter, pass_name);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Marks::draw(const PictureDrawer& drawer, const PictureState& state, const Target& to, PassMeter& meter) {
    const std::vector<Planned> marks = plan(state.list, state.settings);
    const auto run_end = [&](std::size_t first) {
        std::size_t end = first + 1;
        while (end < marks.size() && are_of_one_color(marks[first].mark, marks[end].mark)) ++end;
        return end;
    };
    if (marks.empty()) return;
    reserve(to);
    glViewport(0, 0, to.width(), to.height());
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    if (run_end(0) < marks.size() || marks[0].mark.has_vertex_colors) draw_depth(drawer, marks, to);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t first = 0, end = 0; first < marks.size(); first = end) {
        end = run_end(first);
        draw_run(drawer, std::span(marks).subspan(first, end - first), to, meter);
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDepthFunc(DepthRange(drawer.driver()).nearer());
    check_gl("lines and points");
}

void Marks::draw_channels(const PictureDrawer& drawer, const PictureState& state, Output group, const Target& from,
                          float far_depth) const {
    if (group == Output::count) return;
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);  // they are hidden by surfaces with a tolerance, by one another without
    for (const Planned& m : plan(state.list, state.settings))
        if (m.mark.color.w >= 1) drawer.draw_marks(*m.draw, m.mark, group, from.depth_texture());
}

}  // namespace rakelight::opengl
