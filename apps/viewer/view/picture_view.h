// SPDX-License-Identifier: Apache-2.0
// One picture of the window: the look that it is to show, and the picture that it shows. Its painter has a thread of its own.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "painter.h"

namespace rakelight::viewer {

/// Requirements of a picture besides its look.
struct Demand {
    bool is_moving = false;   ///< a coarse picture is enough
    bool is_playing = false;  ///< PaintJob::is_playing
    bool wants_depth = false;
    bool is_by_gl = false;  ///< then the marks are in the picture
    Marks marks;
};

class PictureView {
public:
    Look look;                  ///< that is to be shown
    PixelBox area{0, 0, 1, 1};  ///< of the window

    /// Nothing else was requested the last time: no new picture is needed.
    bool has_requested(const Demand& demand, const std::shared_ptr<const Model>& model) const;
    /// Finds the camera of the look. @throws Error usage: there is none, and the look is what it was before
    void place_camera(const std::shared_ptr<const Model>& model);
    /// The job for a picture of the look, which counts as requested from now on.
    PaintJob new_job(const Demand& demand, const std::shared_ptr<const Model>& model);
    void paint(PaintJob job) { painter_->paint(std::move(job)); }
    /// The next request makes a new picture in any case.
    void forget_request() { requested_.model.reset(); }
    /// Before the first request: a view that is not shown has no thread.
    void open(std::function<void()> wake, int threads, std::uint64_t max_memory);

    /// Hands over what pixels were asked for, then takes the newest picture. @return there is a new one
    bool take_picture();
    /// Takes what went wrong. @return none: nothing
    std::optional<Painter::Fault> take_fault() { return painter_->take_fault(); }
    /// The request failed: the look becomes the last one that was drawn of this model.
    void go_back(const std::shared_ptr<const Model>& model);
    void cancel();

    bool is_open() const { return bool(painter_); }
    bool is_painting() const { return is_painting_; }
    std::uint64_t number() const { return number_; }  ///< of the last request
    /// The work that runs before a picture can be drawn, as "normals 40 %"; empty: none.
    std::string preparation() const;
    /// Painter::look_at_pixel(). Only while is_open().
    void look_at_pixel(int x, int y, std::function<void(std::optional<Painter::Hit>)> done);
    const std::shared_ptr<const Painting>& displayed() const { return displayed_; }  ///< null: nothing yet
    const Camera& camera() const { return camera_; }                                 ///< of the last request
    /// The model of the last request; null: none.
    const std::shared_ptr<const Model>& requested_model() const { return requested_.model; }

private:
    struct Request {
        std::shared_ptr<const Model> model;
        Look look;
        Marks marks;
        int width = 1, height = 1;
        bool is_moving = false, has_depth = false;
    };

    Request requested_;
    Look good_;  ///< of the last picture without an error
    std::shared_ptr<const Model> good_model_;
    Camera camera_;
    bool is_painting_ = false;
    std::uint64_t number_ = 0;
    std::shared_ptr<const Painting> displayed_;
    std::unique_ptr<Painter> painter_;
};

}  // namespace rakelight::viewer
