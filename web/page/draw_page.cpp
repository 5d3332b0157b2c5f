// SPDX-License-Identifier: Apache-2.0
// The pictures of the page: by OpenGL, or by the engine soft.
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include <rakelight/render/render.h>

#include "hard_edges.h"
#include "page.h"
#include "paint_lines.h"

namespace rakelight::web {
namespace {

constexpr int coarser_in_motion = 3;         // pictures of the engine soft
constexpr std::size_t most_gl_draws = 4096;  // browsers take 10 to 20 us for each; beyond, soft is faster
constexpr std::chrono::milliseconds slow_compilation(400);

std::size_t draw_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes) count += node.meshes.size();
    return count;
}

}  // namespace

void Page::start_gl() {
    end_gl();
    halves_[0].view.emplace();
    has_gl_ = true;
    next_ = Next::coarse;
}

void Page::end_gl() {
    for (Half& half : halves_) half.view.reset();
    has_gl_ = false;
}

std::string Page::renderer() const { return halves_[0].view ? halves_[0].view->renderer() : ""; }

Shot Page::plan(Half& half, PictureRequest& request, Context& context) const {
    const ExaminedModel& shown = shown_in(half);
    request.engine = "soft";  // scenes are prepared alike for every engine
    const Camera camera = viewer::camera_of(half.look, *shown.model, width_, height_);
    const Shot shot = half.studio.plan(shown.model, half.look, request, camera, context);
    half.studio.prepare(shot, context);
    return shot;
}

std::vector<Line> Page::lines_of(Half& half, Marks marks, const Scene& prepared) const {
    std::vector<Line> lines;
    if (marks.seams) lines = shown_in(half).heat_map;
    if (!marks.hard_edges) return lines;
    if (half.hard_edges_of != half.studio.prepared()) {
        half.hard_edges = hard_edge_lines(prepared);
        half.hard_edges_of = half.studio.prepared();
    }
    lines.insert(lines.end(), half.hard_edges.begin(), half.hard_edges.end());
    return lines;
}

SoftPicture Page::drawn_by_soft(Half& half, Marks marks, bool is_moving, Context& context) const {
    const int coarser = is_moving ? coarser_in_motion : 1;
    SoftPicture picture{std::max(1, width_ / coarser), std::max(1, height_ / coarser), {}};
    PictureRequest request = viewer::request_of(half.look, picture.width, picture.height);
    if (is_moving || half.channel != 0) request.settings.samples = 1;
    request.settings.channels = half.channel;
    const Shot shot = plan(half, request, context);
    Frame frame;
    half.studio.draw(shot, marks.any() ? std::uint32_t(channel_depth) : 0u, frame, context);
    const Bounds& bounds = shown_in(half).model->box.bounds();
    picture.codes = half.channel != 0 ? channel_codes(frame, half.channel, channel_range_of(bounds, shot.camera))
                                      : to_srgb8(frame, request.tone, shot.behind);
    paint_lines(picture.codes, lines_of(half, marks, scene_of(*half.studio.prepared())), shot.camera, frame.depth,
                picture.width, picture.height, bounds.diagonal());
    return picture;
}

void Page::show_soft(Half& half, Marks marks, bool is_moving, Context& context) {
    const SoftPicture picture = drawn_by_soft(half, marks, is_moving, context);
    half.view->show(picture.width, picture.height, picture.codes);
}

void Page::draw_by_gl(Half& half, Marks marks, bool is_moving, Context& context) {
    if (!half.view) half.view.emplace();
    if (half.channel != 0 || draw_count(shown_in(half).model->scene) > most_gl_draws)
        return show_soft(half, marks, is_moving, context);
    PictureRequest request = viewer::request_of(half.look, width_, height_);
    const Shot shot = plan(half, request, context);
    while (!half.view->upload(half.studio.prepared(), 1000, context)) context.progress("upload", 0);
    try {
        half.view->draw(shot, request.tone, context);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::usage) throw;
        return show_soft(half, marks, is_moving, context);  // settings that OpenGL does not have
    }
    half.view->lines(shot.camera, lines_of(half, marks, scene_of(*half.studio.prepared())));
}

/// Into a buffer of its own, of which the part on the right of the line is copied.
void Page::draw_right_by_gl(int line, Marks marks, bool is_moving, Context& context) {
    GLint shown = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &shown);
    GLuint frame = 0, colors = 0;
    glGenFramebuffers(1, &frame), glGenRenderbuffers(1, &colors);
    glBindRenderbuffer(GL_RENDERBUFFER, colors);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
    const auto end = [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, GLuint(shown));
        glDeleteFramebuffers(1, &frame), glDeleteRenderbuffers(1, &colors);
    };
    try {
        draw_by_gl(halves_[1], marks, is_moving, context);
    } catch (...) {
        end();
        throw;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(shown));
    glBlitFramebuffer(line, 0, width_, height_, line, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    end();
}

bool Page::draw(int width, int height, int line, Marks marks, bool is_moving, Context& context) {
    if (!has(halves_[0].version) || !has(halves_[1].version)) throw Error(ErrorCode::usage, "there is no model");
    width_ = std::max(width, 1), height_ = std::max(height, 1);
    line = std::clamp(line, 0, width_);
    if (has_gl_) return draw_gl(line, marks, is_moving, context);
    draw_soft(line, marks, is_moving, context);
    return true;
}

bool Page::draw_gl(int line, Marks marks, bool is_moving, Context& context) {
    using Clock = std::chrono::steady_clock;
    glViewport(0, 0, width_, height_);
    if (next_ == Next::coarse) {
        next_ = Next::compiled;
        if (compiles_slowly_ && line == width_) {
            show_soft(halves_[0], marks, true, context);
            return false;
        }
    }
    const Clock::time_point begin = Clock::now();
    if (line > 0) draw_by_gl(halves_[0], marks, is_moving, context);
    if (line < width_) draw_right_by_gl(line, marks, is_moving, context);
    if (std::exchange(next_, Next::other) == Next::compiled) {
        glFinish();
        compiles_slowly_ = Clock::now() - begin > slow_compilation;
    }
    return true;
}

void Page::draw_soft(int line, Marks marks, bool is_moving, Context& context) {
    soft_picture_ = drawn_by_soft(halves_[0], marks, is_moving, context);
    if (line == width_) return;
    const SoftPicture right = drawn_by_soft(halves_[1], marks, is_moving, context);
    const std::size_t width = std::size_t(right.width), first = width * std::size_t(line) / std::size_t(width_);
    for (std::size_t i = 0; i < right.codes.size(); ++i)
        if (i % width >= first) soft_picture_.codes[i] = right.codes[i];
}

}  // namespace rakelight::web
