// SPDX-License-Identifier: Apache-2.0
#include "page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <rakelight/math/linear.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

#include "seam_view.h"

namespace rakelight::web {
namespace {

// Of a raking light and the light around, so that faces away from it are seen, too.
constexpr float raking_light = 2.2f, around = 0.3f;

viewer::Eye between(const viewer::Eye& from, const viewer::Eye& to, double share) {
    viewer::Eye eye = to;
    eye.position = from.position + (to.position - from.position) * share;
    eye.focal = from.focal + (to.focal - from.focal) * share;
    eye.up = normalize_or(from.up + (to.up - from.up) * share, to.up);
    return eye;
}

std::vector<Light> raking_lights(const Light& light) {
    Light ambient;
    ambient.type = LightType::ambient;
    ambient.ambient = {around, around, around};
    return {light, ambient};
}

}  // namespace

const Inspection& Page::open(const std::string& file, Context& context) {
    auto opened = examine(file, halves_[0].settings, context);
    models_ = {std::move(opened), nullptr};
    eye_.reset(), raking_.reset();
    next_ = Next::coarse;
    forget_right();
    return models_[0]->inspection;
}

const Inspection& Page::examine_again(Context& context) {
    if (!models_[0]) throw Error(ErrorCode::usage, "there is no model");
    models_ = {examine(models_[0]->model, halves_[0].settings, context), nullptr};
    forget_right();
    return models_[0]->inspection;
}

/// The right half has nothing of a model that is gone.
void Page::forget_right() {
    Half& right = halves_[1];
    right.version = Version::original;
    right.studio = {};
    right.view.reset();
    right.hard_edges.clear(), right.hard_edges_of.reset();
    halves_[0].version = Version::original;
    update_looks();
}

const Inspection& Page::open_fixed(const std::string& file, Context& context) {
    models_[1] = examine(file, halves_[0].settings, context);
    forget_right();
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
    const std::uint32_t bit = channel.empty() ? 0 : channels_by_name(channel);
    viewer::Look look = has(version) ? look_of(version, settings) : viewer::Look();
    Half& to = halves_[half];
    to.look = std::move(look), to.channel = bit, to.version = version, to.settings = std::move(settings);
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
    flight_begin_ = moving_eye();
    flight_end_ = flight_begin_;
    flight_end_.focal = seen.place;
    flight_end_.position = seen.eye;
    viewer::turn_table(flight_end_, 0, 0, halves_[0].look.world_up);
    Light light;
    light.type = LightType::directional;
    light.direction = -seen.to_light;
    light.color = {raking_light, raking_light, raking_light};
    raking_ = light;
    update_looks();
}

void Page::fly(double share) {
    if (!models_[0]) return;
    eye_ = between(flight_begin_, flight_end_, std::clamp(share, 0.0, 1.0));
    for (Half& half : halves_) half.look.eye = eye_;
}

void Page::end_raking_light() {
    raking_.reset();
    update_looks();
}

std::shared_ptr<const ExplainedPixel> Page::explain(std::size_t half, int width, int height, int x, int y,
                                                    Context& context) {
    const Half& of = halves_[half];
    if (!has(of.version)) throw Error(ErrorCode::usage, "there is no model");
    return rakelight::explain(shown_in(of).model->scene, viewer::request_of(of.look, width, height), x, y, context);
}

}  // namespace rakelight::web
