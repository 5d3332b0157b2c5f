// SPDX-License-Identifier: Apache-2.0
#include "page.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>
#include <rakelight/render/render.h>
#include <rakelight/tools/draw_seams.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

#include "hard_edges.h"
#include "seam_view.h"

namespace rakelight::web {
namespace {

constexpr int coarser_in_motion = 3;                 // pictures of the engine soft
constexpr std::size_t most_gl_draws = 4096;          // browsers take 10 to 20 us for each; beyond, soft is faster
constexpr float raking_light = 2.2f, around = 0.3f;  // so that faces away from it are seen, too

std::size_t draw_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes) count += node.meshes.size();
    return count;
}

std::vector<Light> raking_lights(const Light& light) {
    Light ambient;
    ambient.type = LightType::ambient;
    ambient.ambient = {around, around, around};
    return {light, ambient};
}

}  // namespace

void Page::start_gl() {
    end_gl();
    halves_[0].view.emplace();
    has_gl_ = true;
}

void Page::end_gl() {
    for (Half& half : halves_) half.view.reset();
    has_gl_ = false;
}

std::string Page::renderer() const { return halves_[0].view ? halves_[0].view->renderer() : ""; }

const Inspection& Page::open(const std::string& file, Context& context) {
    auto opened = examine(file, halves_[0].settings, context);
    models_ = {std::move(opened), nullptr};
    halves_[0].version = halves_[1].version = Version::original;
    eye_.reset(), raking_.reset();
    update_looks();
    return models_[0]->inspection;
}

const Inspection& Page::open_fixed(const std::string& file, Context& context) {
    models_[1] = examine(file, halves_[0].settings, context);
    update_looks();
    return models_[1]->inspection;
}

SmoothedFile Page::smooth(const std::string& output, Context& context) const {
    if (!models_[0]) throw Error(ErrorCode::usage, "there is no model");
    const viewer::Model& model = *models_[0]->model;
    PictureRequest request = model.request;
    read_render_keys(halves_[0].settings, request);
    return smooth_file(model.file, output, smooth_options_for(request), context);
}

viewer::Look Page::look_of(Version version, std::span<const WorldValue> settings) const {
    const ExaminedModel& shown = *models_[std::size_t(version)];
    viewer::Look look = viewer::first_look(*shown.model);
    read_render_keys(settings, look.request);
    look.request.settings.material_shading = !sets_shading(settings);
    look.request.prepare = as_measured(shown.model->scene, look.request.prepare);
    look.eye = eye_;
    if (raking_) {
        look.request.lights = raking_lights(*raking_);
        look.request.studio_lights = false;
        look.request.hdri_ambient = false;
        look.request.settings.shadows = false;
    }
    return look;
}

void Page::update_looks() {
    for (Half& half : halves_)
        if (has(half.version)) half.look = look_of(half.version, half.settings);
}

void Page::set(std::size_t half, Version version, const std::string& channel, std::vector<WorldValue> settings) {
    PictureRequest checked;
    read_render_keys(settings, checked);
    halves_[half].channel = channel.empty() ? 0 : channels_by_name(channel);
    if (has(version)) halves_[half].look = look_of(version, settings);
    halves_[half].version = version;
    halves_[half].settings = std::move(settings);
}

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

/// Every channel, as a picture to look at.
std::vector<std::uint32_t> Page::channel_drawn(Half& half, int width, int height, Context& context) const {
    PictureRequest request = viewer::request_of(half.look, width, height);
    request.settings.samples = 1;
    request.settings.channels = half.channel;
    const Shot shot = plan(half, request, context);
    Frame frame;
    half.studio.draw(shot, 0, frame, context);
    return channel_codes(frame, half.channel, channel_range_of(shown_in(half).model->box.bounds(), shot.camera));
}

std::vector<std::uint32_t> Page::drawn_by_soft(Half& half, int width, int height, Marks marks, bool is_moving,
                                               Context& context) const {
    if (half.channel != 0) return channel_drawn(half, width, height, context);
    PictureRequest request = viewer::request_of(half.look, width, height);
    if (is_moving) request.settings.samples = 1;
    if (marks.seams) {
        const ExaminedModel& shown = shown_in(half);
        Inspection found = shown.inspection;
        found.seam_lines = shown.seams;
        InspectOptions options;
        options.prepare = half.look.request.prepare;
        return to_srgb8(draw_seams(shown.model->scene, found, options, request.view, request.settings, context));
    }
    const Shot shot = plan(half, request, context);
    Frame frame;
    half.studio.draw(shot, 0, frame, context);
    return to_srgb8(frame, request.tone, shot.behind);
}

void Page::show_soft(Half& half, Marks marks, bool is_moving, Context& context) {
    const int coarser = is_moving ? coarser_in_motion : 1;
    const int width = std::max(1, width_ / coarser), height = std::max(1, height_ / coarser);
    half.view->show(width, height, drawn_by_soft(half, width, height, marks, is_moving, context));
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

void Page::draw(int width, int height, int line, Marks marks, bool is_moving, Context& context) {
    if (!has(halves_[0].version) || !has(halves_[1].version)) throw Error(ErrorCode::usage, "there is no model");
    width_ = std::max(width, 1), height_ = std::max(height, 1);
    line = std::clamp(line, 0, width_);
    if (has_gl_) {
        glViewport(0, 0, width_, height_);
        if (line > 0) draw_by_gl(halves_[0], marks, is_moving, context);
        if (line < width_) draw_right_by_gl(line, marks, is_moving, context);
        return;
    }
    soft_picture_ = drawn_by_soft(halves_[0], width_, height_, marks, is_moving, context);
    if (line == width_) return;
    const std::vector<std::uint32_t> right = drawn_by_soft(halves_[1], width_, height_, marks, is_moving, context);
    for (std::size_t i = 0; i < soft_picture_.size(); ++i)
        if (int(i % std::size_t(width_)) >= line) soft_picture_[i] = right[i];
}

viewer::Eye& Page::moving_eye() {
    if (!models_[0]) throw Error(ErrorCode::usage, "there is no model");
    if (!eye_) eye_ = viewer::seen_eye(halves_[0].look, *models_[0]->model, width_, height_);
    return *eye_;
}

void Page::turn(double dx, double dy) {
    viewer::turn_table(moving_eye(), dx * pi, dy * pi, halves_[0].look.world_up);
    for (Half& half : halves_) half.look.eye = eye_;
}

void Page::pan(double dx, double dy) {
    viewer::pan(moving_eye(), dx, dy, 1);
    for (Half& half : halves_) half.look.eye = eye_;
}

void Page::dolly(double factor) {
    viewer::dolly(moving_eye(), factor);
    for (Half& half : halves_) half.look.eye = eye_;
}

void Page::show_whole() {
    eye_.reset(), raking_.reset();
    update_looks();
}

void Page::fly_to_border(std::size_t border) {
    if (!models_[0]) throw Error(ErrorCode::usage, "there is no model");
    const SeamView seen = view_of_seam(*models_[0], border);
    viewer::Eye& eye = moving_eye();
    eye.focal = seen.place;
    eye.position = seen.eye;
    viewer::turn_table(eye, 0, 0, halves_[0].look.world_up);
    Light light;
    light.type = LightType::directional;
    light.direction = -seen.to_light;
    light.color = {raking_light, raking_light, raking_light};
    raking_ = light;
    update_looks();
}

void Page::end_raking_light() {
    raking_.reset();
    update_looks();
}

std::shared_ptr<const ExplainedPixel> Page::explain(std::size_t half, int x, int y, Context& context) {
    const Half& of = halves_[half];
    if (!has(of.version)) throw Error(ErrorCode::usage, "there is no model");
    return rakelight::explain(shown_in(of).model->scene, viewer::request_of(of.look, width_, height_), x, y, context);
}

}  // namespace rakelight::web
