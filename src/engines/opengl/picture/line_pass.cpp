// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/line_pass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engines/opengl/picture/picture.h"
#include "engines/opengl/programs/programs.h"

namespace rakelight::opengl {
namespace {

/// A corner of a line's quadrangle, as lines_main.glsl reads it.
struct LineVertex {
    float place[4], color[4], line[2];
};

/// Cut at the near plane. False: nothing is left.
bool keep_before(dvec4& a, dvec4& b, double least_w) {
    if (a.w < least_w && b.w < least_w) return false;
    if (a.w >= least_w && b.w >= least_w) return true;
    const double t = (least_w - a.w) / (b.w - a.w);
    const dvec4 cut = a + (b - a) * t;
    (a.w < least_w ? a : b) = cut;
    return true;
}

void add_line(const Line& line, const dmat4& to_clip, double least_w, int width, int height,
              std::vector<LineVertex>& to) {
    dvec4 a = to_clip * dvec4{line.from.x, line.from.y, line.from.z, 1},
          b = to_clip * dvec4{line.to.x, line.to.y, line.to.z, 1};
    if (!keep_before(a, b, least_w)) return;
    const dvec3 p{a.x / a.w, a.y / a.w, a.z / a.w}, q{b.x / b.w, b.y / b.w, b.z / b.w};
    dvec2 along{(q.x - p.x) * width * 0.5, (q.y - p.y) * height * 0.5};
    const double length = std::sqrt(dot(along, along));
    if (!std::isfinite(length)) return;
    along = length > 1e-9 ? along * (1 / length) : dvec2{1, 0};
    const double half = std::max(0.5 * double(line.width_px), 0.5), reach = half + 1;
    const dvec2 aside{-along.y * reach * 2 / width, along.x * reach * 2 / height};
    const auto corner = [&](const dvec3& end, double side) {
        return LineVertex{
            {float(end.x + aside.x * side), float(end.y + aside.y * side), float(end.z), float(reach * side)},
            {line.color.x, line.color.y, line.color.z, line.color.w},
            {float(half), line.is_overlay ? 1.0f : 0.0f}};
    };
    const LineVertex quad[4] = {corner(p, -1), corner(p, 1), corner(q, -1), corner(q, 1)};
    for (const int k : {0, 1, 2, 2, 1, 3}) to.push_back(quad[k]);
}

std::vector<LineVertex> quads_of(std::span<const Line> lines, const dmat4& to_clip, double least_w,
                                 const Screen& screen) {
    std::vector<LineVertex> vertices;
    for (const Line& line : lines) add_line(line, to_clip, least_w, screen.width(), screen.height(), vertices);
    return vertices;
}

/// Of the array and the buffer that are bound.
void set_attributes() {
    const auto attribute = [](GLuint at, GLint components, std::size_t offset) {
        glEnableVertexAttribArray(at);
        glVertexAttribPointer(at, components, GL_FLOAT, GL_FALSE, sizeof(LineVertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 4, offsetof(LineVertex, place));
    attribute(1, 4, offsetof(LineVertex, color));
    attribute(2, 2, offsetof(LineVertex, line));
}

}  // namespace

void LinePass::draw(std::span<const Line> lines, const shading::PictureCamera& view, const Screen& screen, GLuint depth,
                    const Driver& driver) {
    const DepthRange::Row nearness = DepthRange::nearness(view);
    const dmat4 to_clip =
        clip_matrix(view, {0, 0, screen.width(), screen.height()}, nearness, 1) * view.world_to_camera;
    // Marks between the eye and the near plane are seen: that plane lies close to the model.
    const double least_w = view.orthographic ? 0.5 : 1e-3 * view.z_near;
    const std::vector<LineVertex> vertices = quads_of(lines, to_clip, least_w, screen);
    if (vertices.empty()) return;
    if (!program_) program_ = link_program(line_text(driver));
    screen.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, depth);
    glBindSampler(0, 0);
    const auto place = [&](const char* name) { return glGetUniformLocation(program_.name(), name); };
    glUniform1i(place("rl_depth"), 0);
    glUniform4f(place("rl_show"), float(screen.viewport[0]), float(screen.viewport[1]), depth != 0 ? 1.0f : 0.0f,
                float(screen.height()));
    glUniform1f(place("rl_show_scale"), view.orthographic ? 0.0f : float(nearness.scale));
    glBindVertexArray(array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(LineVertex)), vertices.data(), GL_STREAM_DRAW);
    set_attributes();
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
    glDisable(GL_BLEND);
    check_gl("lines");
}

}  // namespace rakelight::opengl
