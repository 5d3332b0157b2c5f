// SPDX-License-Identifier: Apache-2.0
#include "picture_view.h"

namespace rakelight::viewer {

void PictureView::open(std::function<void()> wake, int threads, std::uint64_t max_memory) {
    if (!painter_) painter_ = std::make_unique<Painter>(std::move(wake), threads, max_memory);
}

bool PictureView::has_requested(const Demand& demand, const std::shared_ptr<const Model>& model) const {
    const Request& r = requested_;
    const bool is_same = r.model == model && look == r.look && area.width == r.width && area.height == r.height &&
                         r.has_depth == demand.wants_depth && (!demand.is_by_gl || r.marks == demand.marks);
    return is_same && (demand.is_moving || !r.is_moving);  // after a motion the whole picture is made
}

void PictureView::place_camera(const std::shared_ptr<const Model>& model) {
    try {
        const Camera camera = quick_camera_of(look, *model, area.width, area.height);
        if (requested_.model == model) carry_lights(look, camera_, camera);
        camera_ = camera;
    } catch (const Error&) {
        if (requested_.model == model)
            look = requested_.look;
        else
            look.eye.reset(), look.request.view = {.side = "default"};
        throw;
    }
}

PaintJob PictureView::new_job(const Demand& demand, const std::shared_ptr<const Model>& model) {
    requested_ = {.model = model,
                  .look = look,
                  .marks = demand.marks,
                  .width = area.width,
                  .height = area.height,
                  .is_moving = demand.is_moving,
                  .has_depth = demand.wants_depth};
    is_painting_ = true;
    return {.model = model,
            .look = look,
            .width = area.width,
            .height = area.height,
            .is_moving = demand.is_moving,
            .is_playing = demand.is_playing,
            .wants_depth = demand.wants_depth,
            .number = ++number_,
            .marks = demand.marks};
}

bool PictureView::take_picture() {
    painter_->poll();
    auto painting = painter_->take();
    if (!painting) return false;
    displayed_ = std::move(painting);
    if (displayed_->number != number_) return true;
    good_ = requested_.look, good_model_ = requested_.model;
    if (displayed_->is_final || requested_.is_moving) is_painting_ = false;
    return true;
}

void PictureView::go_back(const std::shared_ptr<const Model>& model) {
    is_painting_ = false;
    const bool can_go_back = good_model_ == model && !(good_ == requested_.look);
    if (can_go_back) look = good_;
}

void PictureView::cancel() {
    if (painter_) painter_->cancel();
}

std::string PictureView::preparation() const {
    return painter_ && is_painting_ ? to_text(painter_->progress(), "render") : std::string();
}

void PictureView::look_at_pixel(int x, int y, std::function<void(std::optional<Painter::Hit>)> done) {
    painter_->look_at_pixel(x, y, std::move(done));
}

}  // namespace rakelight::viewer
