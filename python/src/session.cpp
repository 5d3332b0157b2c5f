// SPDX-License-Identifier: Apache-2.0
// Pictures as arrays: a scene taken up once, and any number of views of it.
#include <rakelight/session.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include <rakelight/camera_chooser.h>
#include <rakelight/picture_parts.h>

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
        : runner_(threads, max_memory), scene_(handle.scene) {
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
        Context& context = runner_.context();
        PictureRequest request = requested(view, channels);
        if (request.has_overlays())
            throw Error(ErrorCode::usage, "overlays are drawn into files alone", {}, "use render_file()");
        check_drawing(request);
        if (!is_looked_) {
            scene_ = with_requested_look(scene_, request, context);  // a copy: if it throws, the scene stays
            take_over(request, has_camera(view));
            is_looked_ = true;
        }
        const double aspect = double(request.settings.width) / double(request.settings.height);
        if (!cameras_) cameras_.emplace(scene_, context);
        const Camera camera = cameras_->choose(request.view, aspect, request.settings.visibility, context);
        set(request);
        const Shot shot{camera, {}, shot_lights(scene_, request, camera)};
        if (!is_adjusted_ && (has_image || has_color)) {
            apply_look_exposure(*session_, shot, request, context);
            take_over(request, has_camera(view));
            is_adjusted_ = true;
        }
        return drawn(request, shot, has_image, has_color);
    }

    /// @param of  without settings
    Drawn drawn(const PictureRequest& request, const Shot& of, bool has_image, bool has_color) {
        Drawn out;
        out.camera = of.camera;
        Shot shot{of.camera, request.settings, of.lights};
        RenderSettings& settings = shot.settings;
        if (!has_image && !has_color) leave_colors_out(settings);
        const vec4 behind = has_image ? separate_background(settings, request.tone) : vec4{};
        if (has_image && has_color && !settings.composites_background)  // they differ in more than the curve
            session_->render({of.camera, request.settings, of.lights}, out.linear.emplace(), runner_.context());
        session_->render(shot, out.frame, runner_.context());
        if (has_image) out.codes = to_srgb8(out.frame, request.tone, behind);
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

    /// The session gets the scene, if it has not.
    void set(const PictureRequest& request) {
        if (is_set_) return;
        Scene scene = scene_;
        scene.fog = request.fog.value_or(scene.fog);
        session_->set(std::move(scene), request.prepare);
        is_set_ = true;
    }

    Runner runner_;
    Scene scene_;
    std::optional<CameraChooser> cameras_;  ///< of scene_ with its look
    PictureRequest request_;
    std::optional<Session> session_;
    bool is_looked_ = false, is_adjusted_ = false, is_set_ = false;
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
