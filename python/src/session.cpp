// SPDX-License-Identifier: Apache-2.0
// Pictures as arrays: a scene taken up once, and any number of views of it.
#include <rakelight/render/session.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include <rakelight/render/camera_chooser.h>
#include <rakelight/render/picture.h>
#include <rakelight/render/shot.h>
#include <rakelight/world/render_keys.h>

#include "errors.h"
#include "frames.h"
#include "run.h"
#include "scene.h"

namespace rakelight::python {
namespace {

/// Says that nobody else uses a session, until it ends.
class Use {
public:
    explicit Use(std::atomic_flag& flag) : flag_(flag) {
        if (flag_.test_and_set())
            throw Error(ErrorCode::usage, "the session is in use by another thread", {}, "make a session for each");
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use() { flag_.clear(); }

private:
    std::atomic_flag& flag_;
};

/// Pictures of one scene. What the look decides (light, samples, background, exposure) it decides at the first one.
class Pictures {
public:
    Pictures(const SceneHandle& handle, const Settings& settings, int threads, std::uint64_t max_memory)
        : runner_(threads, max_memory), loaded_(std::make_shared<const Scene>(handle.scene)) {
        request_ = request_of(handle, settings, runner_.context());
        session_.emplace(request_.engine);
    }

    py::dict render(const Settings& view, std::uint32_t channels, bool has_image, bool has_color,
                    const py::object& progress) {
        const Use use(in_use_);
        Drawn drawn = runner_.run(progress, [&] { return draw(view, channels, has_image, has_color); });
        return arrays_of(std::move(drawn), has_image, has_color);
    }

    py::list take_remarks() {
        const py::list list = remarks_of(runner_.context().report(), remarks_);
        remarks_ += list.size();
        return list;
    }

private:
    static bool has_camera(const Settings& view) {
        return std::ranges::any_of(view, [](const auto& v) { return v.first != "resolution" && v.first != "window"; });
    }

    /// The picture that is asked for, in a look that was taken or is to be.
    PictureRequest requested(const Settings& view, std::uint32_t channels) const {
        PictureRequest request = request_;
        if (has_camera(view)) {  // another place; zoom, angles of view and depths of the session stay
            request.view.side.clear(), request.view.camera.clear();
            request.view.position.reset(), request.view.focal_point.reset(), request.view.direction.reset();
        }
        read_render_keys(values_of(view), request);
        request.settings.channels = channels;
        return request;
    }

    Drawn draw(const Settings& view, std::uint32_t channels, bool has_image, bool has_color) {
        PictureRequest request = requested(view, channels);
        if (request.has_overlays())
            throw Error(ErrorCode::usage, "overlays are drawn into files alone", {}, "use render_file()");
        check_drawing(request);
        const Camera camera = decided(request, has_camera(view), !has_image && !has_color);
        return drawn(request, camera, has_image, has_color);
    }

    Camera camera_of(const Scene& shown, const PictureRequest& request) {
        if (!cameras_) cameras_.emplace(shown, runner_.context());
        const double aspect = double(request.settings.width) / double(request.settings.height);
        return cameras_->choose(request.view, aspect, request.settings.visibility, runner_.context());
    }

    const Scene& show(const PictureRequest& request) {
        PictureRequest shown = request;
        if (is_decided_) shown.view.world_up = world_up_;  // the environment stays as it is, whatever the view
        return session_->show(loaded_, shown, clips_of(*loaded_, request.motion), runner_.context());
    }

    /// The look is chosen at the first picture, background and exposure at the first one that is not data alone.
    /// @return the camera of this picture
    Camera decided(PictureRequest& request, bool has_own_view, bool is_data) {
        Context& context = runner_.context();
        if (is_decided_ && (is_adjusted_ || is_data)) return camera_of(show(request), request);
        const ShotOptions options{.is_view = true, .without_adjusting = is_data};
        const std::optional<dvec3> own_up = request.view.world_up;
        Shot shot;
        if (!is_decided_) {
            const auto camera = [&](const Scene& shown) { return camera_of(shown, request); };
            shot = decide(*session_, loaded_, request, clips_of(*loaded_, request.motion), camera, options, context);
        } else {
            const Scene& shown = show(request);
            shot = plan_shot(shown, request, camera_of(shown, request), options, context);
            adjust_shot(*session_, shot, request, options, context);
        }
        if (!is_decided_) world_up_ = request.view.world_up;
        is_decided_ = true, is_adjusted_ = !is_data;
        take_over(request, has_own_view);
        if (!own_up) request_.view.world_up = world_up_;  // that of the file, for all views
        return shot.camera;
    }

    Drawn drawn(const PictureRequest& request, const Camera& camera, bool has_image, bool has_color) {
        Context& context = runner_.context();
        Context quiet({.threads = 1, .parent = &context});  // decided() has told of the lights
        const Scene& shown = show(request);
        const auto plan = [&](bool is_linear) {
            return plan_shot(shown, request, camera, {.is_linear = is_linear, .is_view = true}, quiet);
        };
        Drawn out;
        out.camera = camera;
        Shot shot = plan(!has_image);
        if (!has_image && !has_color) leave_colors_out(shot.settings);
        if (has_image && has_color && !shot.settings.composites_background)  // they differ in more than the curve
            session_->render(plan(true), out.linear.emplace(), context);
        session_->render(shot, out.frame, context);
        if (has_image) out.codes = to_srgb8(out.frame, request.tone, shot.behind);
        out.has_alpha = request.settings.background.w < 1;
        return out;
    }

    /// Data alone: they are of the surface at the pixel's center, whatever the samples and, but for the light's parts, the light.
    void leave_colors_out(RenderSettings& settings) const {
        if (session_->engine().capabilities().rays) {
            settings.colors = false;
            return;
        }
        settings.samples = 1;
        if (settings.channels & (channels_lighting | channel_ambient_occlusion)) return;
        settings.shading = Shading::unlit;
        settings.shading_rules.clear();
        settings.material_shading = settings.shadows = false;
    }

    /// What later pictures take from the first: all but its own view, size and channels.
    void take_over(PictureRequest request, bool has_own_view) {
        if (has_own_view) request.view = request_.view;
        request.settings.width = request_.settings.width, request.settings.height = request_.settings.height;
        request.settings.window = request_.settings.window;
        request_ = std::move(request);
    }

    Runner runner_;
    std::shared_ptr<const Scene> loaded_;
    std::optional<CameraChooser> cameras_;  ///< of the scene as it is shown
    PictureRequest request_;
    std::optional<dvec3> world_up_;  ///< of the scene as it is shown
    std::optional<Session> session_;
    bool is_decided_ = false, is_adjusted_ = false;
    std::size_t remarks_ = 0;  ///< that were told
    std::atomic_flag in_use_;
};

}  // namespace

void define_session(py::module_& module) {
    py::class_<Pictures>(module, "Session")
        .def(py::init<const SceneHandle&, const Settings&, int, std::uint64_t>())
        .def("render", &Pictures::render)
        .def("take_remarks", &Pictures::take_remarks);
    module.def("channel_bits", [](const std::string& word) { return channels_by_name(word); });
}

}  // namespace rakelight::python
