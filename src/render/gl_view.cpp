// SPDX-License-Identifier: Apache-2.0
#include <rakelight/render/gl_view.h>
#include <rakelight/render/render.h>

#include "engines/check_settings.h"
#include "engines/opengl/window_view.h"
#include "render/engines.h"
#include "render/prepared_scene.h"
#include "scene/faults.h"
#include "scene/validate.h"

namespace rakelight {

struct GlView::State {
    opengl::WindowView view;
    std::shared_ptr<const PreparedScene> whole, incoming;  ///< what is drawn, and what comes next
    std::uint64_t number = 0;                              ///< of `incoming`
};

GlView::GlView() : state_(std::make_unique<State>()) {}
GlView::~GlView() = default;

std::string GlView::renderer() const { return state_->view.renderer(); }
bool GlView::has_gpu() const { return state_->view.has_gpu(); }

bool GlView::upload(std::shared_ptr<const PreparedScene> scene, double milliseconds, Context& context) {
    if (!scene) throw Error(ErrorCode::usage, "there is no prepared scene to draw");
    State& s = *state_;
    if (scene == s.whole) return true;
    if (scene != s.incoming) {
        validate_changes(scene->scene, s.whole ? s.whole->scene : Scene());
        s.incoming = std::move(scene);
        ++s.number;
    }
    if (!s.view.upload(s.incoming->scene, s.incoming->poses, s.number, milliseconds, context)) return false;
    s.whole = std::move(s.incoming);
    return true;
}

RenderStats GlView::draw(const Shot& shot, const ToneSettings& tone, Context& context) {
    State& s = *state_;
    if (!s.whole) return {};
    const Scene& scene = s.whole->scene;
    check_settings(shot.settings);
    check_abilities("gl", s.view.capabilities(), shot.settings);
    check_camera(shot.camera, scene.nodes.size(), CameraUse::in_scene);
    if (shot.lights) validate_lights(*shot.lights, scene.nodes.size());
    s.view.set_lights(lights_of(scene, shot));
    const Camera camera = camera_in_world(scene, shot.camera, aspect_of(shot.settings));
    return s.view.draw(camera, shot.settings, tone, shot.behind, context);
}

void GlView::show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth) {
    state_->view.show(width, height, srgb8, smooth);
}

void GlView::show(const Frame& frame, const ToneSettings& tone, vec4 behind) {
    state_->view.show(frame.window.width, frame.window.height, to_srgb8(frame, tone, behind), true);
}

bool GlView::show_again() { return state_->view.show_again(); }

void GlView::lines(const Camera& camera, std::span<const Line> lines) {
    State& s = *state_;
    check_camera(camera, s.whole ? s.whole->scene.nodes.size() : 0, CameraUse::in_scene);
    s.view.lines(s.whole ? camera_in_world(s.whole->scene, camera, s.view.aspect()) : camera, lines);
}

}  // namespace rakelight
