// SPDX-License-Identifier: Apache-2.0
// Pictures that are drawn on the GPU: when, by what, and what is done where that fails.
#include <algorithm>

#include "app.h"

namespace rakelight::viewer {
namespace {

constexpr int most_gl_faults = 2;  // that a new context is made after

}  // namespace

bool App::is_drawn_by_gl(const Look& look) const {
    const std::string& engine = look.request.engine;
    const bool is_wanted = engine == "gl" || (engine == "auto" && views_[0].screen->has_gpu());
    return is_wanted && !has_gl_failed_ && look.channel == 0;
}

std::shared_ptr<GlPainter> App::gl_of(View& view) {
    if (!view.gl) try {
            view.gl = std::make_shared<GlPainter>(window_->make_shared_context());
        } catch (const Error& error) {
            handle_gl_fault(error);
        }
    return view.gl;
}

/// A context that is lost is recomputed. Where that does not help, pictures are made by sessions from now on, those that were GlView's
/// by soft. Engine gl can be chosen again: it has a context of its own.
void App::handle_gl_fault(const Error& error) {
    if (gl_faults_++ < most_gl_faults) {
        for (View& view : views_) {
            if (view.gl) lost_gl_.push_back(std::move(view.gl));
            view.submitted_model.reset();  // its picture is requested again
        }
        return ui_.say("OpenGL is started again: " + one_line(error.reason(), 200));
    }
    has_gl_failed_ = true;
    for (View& view : views_)
        if (view.look.request.engine == "gl" || view.look.request.engine == "auto") view.look.request.engine = "soft";
    ui_.report(
        Error(ErrorCode::failed, "OpenGL fails in the window: " + error.reason(), {}, "engine soft draws from now on"));
}

Marks App::marks(const View& view) const {
    const bool has_handles = ui_.light_glyphs && &view == &views_[ui_.active];
    const Handle lit = drag_ == Drag::light ? light_drag_.handle : hovered_;
    return {.grid = ui_.grid,
            .axes = ui_.axes,
            .lights = ui_.light_glyphs,
            .vectors = {ui_.normals, ui_.tangents, ui_.bitangents},
            .seams = ui_.seams ? analysis_.seams(model_, view.look.request.prepare) : nullptr,
            .light = ui_.light,
            .has_handles = has_handles,
            .lit = has_handles ? lit : Handle::none,
            .scale = double(window_->scale())};
}

/// Reads the files of shaders again when they have changed.
void App::watch_shaders() {
    try {
        const RenderSettings seen = active().look.request.settings;
        const std::optional<ShaderFiles::Texts> texts = shader_files_.changed(seen);
        if (!texts) return;
        for (View& view : views_) {
            RenderSettings& s = view.look.request.settings;
            if (s.lighting_name == seen.lighting_name) s.lighting_text = texts->lighting;
            if (s.vertex_name == seen.vertex_name) s.vertex_text = texts->vertex;
        }
        ui_.say("read " + one_line(seen.lighting_name.empty() ? seen.vertex_name : seen.lighting_name, 100) + " again");
    } catch (const Error& error) {
        ui_.report(error);
    }
}

}  // namespace rakelight::viewer
