// SPDX-License-Identifier: Apache-2.0
#include "analysis.h"

#include <rakelight/tools/explain.h>

#include "../document/display_path.h"
#include "../document/materials.h"

namespace rakelight::viewer {

Analysis::Analysis(const Start& start, std::function<void()> wake, UiState& ui)
    : ui_(ui),
      explainer_(wake, start.threads, start.max_memory, start.everything),
      seam_search_(wake, start.threads, start.max_memory, start.everything) {}

void Analysis::poll() {
    explainer_.poll();
    seam_search_.poll();
}

void Analysis::cancel() {
    explainer_.cancel();
    seam_search_.cancel();
}

void Analysis::explain(const std::shared_ptr<const Model>& model, const Look& look, int width, int height, int x,
                       int y) {
    const PictureRequest request = request_of(look, width, height);
    const auto work = [this, model, edits = look.materials, request, x, y](Context& context) -> Background::Finish {
        const Scene scene = with_edits(model->scene, edits, context);
        std::string text = to_text(*rakelight::explain(scene, request, x, y, context));
        if (request.engine == "trace")
            text = "as engine soft draws it, without reflected or refracted rays:\n\n" + text;
        return [this, file = model->file, text = std::move(text)] {
            ui_.explained = with_short_paths(text, file);
            ui_.open[std::size_t(Panel::pixel)] = true, ui_.are_panels_hidden = false;
            ui_.redraw();
        };
    };
    explainer_.start("explain", work, [this](const Error& error) { ui_.report(error); });
}

void Analysis::look_for_seams(const std::shared_ptr<const Model>& model, const PrepareOptions& prepare,
                              bool is_waiting) {
    if (!ui_.seams || !model) return;
    const bool is_known = seams_model_ == model && seams_prepare_ == prepare;
    if (is_known || (seam_search_.is_running() && is_waiting)) return;
    seams_model_ = model, seams_prepare_ = prepare;
    const InspectOptions options{.surfaces = false, .seam_lines = true, .prepare = seam_options(model->scene, prepare)};
    const auto work = [this, model, options](Context& context) -> Background::Finish {
        Inspection result = inspect(model->scene, options, context);
        const auto seams = std::make_shared<const Seams>(worst_seams(std::move(result.seam_lines)));
        return [this, seams] {
            seams_ = seams;
            ui_.redraw(1);
        };
    };
    seam_search_.start("seams", work, [this](const Error& error) {
        seams_.reset();  // those of other normals
        ui_.report(error);
    });
}

}  // namespace rakelight::viewer
