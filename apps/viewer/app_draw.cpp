// SPDX-License-Identifier: Apache-2.0
// What is shown: pictures, lines over them, panels.
#include <algorithm>

#include "app.h"
#include "overlay.h"

namespace rakelight::viewer {

void App::draw() {
    if (window_->width() == 0 || window_->height() == 0) return;
    window_->set_viewport(0, 0, 0, 0);
    window_->clear();
    if (ui_.split == Split::wipe)
        draw_wipe();
    else
        for (std::size_t i = 0; i < view_count(); ++i) draw_picture(views_[i]);
    for (std::size_t i = 0; i < (ui_.split == Split::beside ? 2 : 1); ++i) draw_lines(views_[i]);
    draw_panels_over();
    window_->swap();
    if (first_picture_ms_ == 0 && views_[0].shown)
        first_picture_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - began_).count();
}

void App::draw_picture(View& view) {
    if (!view.shown) return;
    const Rectangle& a = view.area;
    window_->set_viewport(a.x, a.y, a.width, a.height);
    gl_->show(view.shown->width, view.shown->height, view.shown->codes);
}

/// A left of the line, B right of it. Pictures of different sizes (one is coarse still) are sampled at their nearest pixels.
void App::draw_wipe() {
    const auto &a = views_[0].shown, &b = views_[1].shown;
    if (!a || !b) return draw_picture(views_[a ? 0 : 1]);
    const Rectangle& area = views_[0].area;
    wiped_.resize(std::size_t(area.width) * std::size_t(area.height));
    const int line = int(ui_.wipe * area.width);
    const auto copy = [&](const Painting& from, int begin, int end) {
        for (int y = 0; y < area.height; ++y) {
            const std::size_t row = std::size_t(std::int64_t(y) * from.height / area.height) * std::size_t(from.width);
            for (int x = begin; x < end; ++x)
                wiped_[std::size_t(y) * std::size_t(area.width) + std::size_t(x)] =
                    from.codes[row + std::size_t(std::int64_t(x) * from.width / area.width)];
        }
    };
    copy(*a, 0, line);
    copy(*b, line, area.width);
    for (int x = std::max(0, line - 1); x < std::min(area.width, line + 1); ++x)
        for (int y = 0; y < area.height; ++y)
            wiped_[std::size_t(y) * std::size_t(area.width) + std::size_t(x)] = 0xff40a0ffu;
    window_->set_viewport(area.x, area.y, area.width, area.height);
    gl_->show(area.width, area.height, wiped_, false);
}

void App::draw_lines(View& view) {
    if (!view.shown || !model_ || view.shown->model != model_) return;
    const Painting& p = *view.shown;
    const Bounds& bounds = model_->box.bounds();
    std::vector<Line> lines;
    const auto add = [&lines](const std::vector<Line>& more) { lines.insert(lines.end(), more.begin(), more.end()); };
    if (ui_.grid) add(grid_lines(bounds, view.look.world_up));
    if (ui_.seams && seams_ && seams_model_ == model_) add(seam_lines(*seams_));
    const int which = (ui_.normals ? 1 : 0) | (ui_.tangents ? 2 : 0) | (ui_.bitangents ? 4 : 0);
    if (which != 0 && (vector_lines_of_ != p.prepared.get() || vector_lines_which_ != which)) {
        vector_lines_.clear();
        for (int i = 0; i < 3; ++i)
            if (which >> i & 1) {
                const auto more = vertex_lines(scene_of(*p.prepared), VertexVector(i), bounds);
                vector_lines_.insert(vector_lines_.end(), more.begin(), more.end());
            }
        vector_lines_of_ = p.prepared.get(), vector_lines_which_ = which;
    }
    if (which != 0) add(vector_lines_);
    if (ui_.axes) add(axis_lines(bounds));
    if (ui_.light_glyphs) add(light_marks(view));
    if (lines.empty()) return;
    if (!p.depth.empty()) lines = visible_lines(lines, p.camera, p.depth, p.width, p.height, 0.004 * bounds.diagonal());
    const Rectangle& a = view.area;
    window_->set_viewport(a.x, a.y, a.width, a.height);
    gl_->lines(p.camera, lines);
}

void App::draw_panels_over() {
    window_->begin_panels();
    View& view = active();
    PanelView panels{.model = model_.get(), .look = view.look, .ui = ui_, .painting = view.shown.get()};
    panels.width = view.area.width, panels.height = view.area.height;
    panels.window_width = window_->width(), panels.window_height = window_->height();
    panels.scale = window_->scale(), panels.longest_block_ms = longest_block_ms_;
    panels.seams = seams_ && seams_model_ == model_ ? &*seams_ : nullptr;
    const auto add = [&panels](const Progress& progress) {
        std::string stage;
        double fraction = 0;
        progress.get(stage, fraction);
        if (!stage.empty()) panels.works.push_back(stage + " " + std::to_string(int(100 * fraction)) + " %");
    };
    for (const Background* work : {&loader_, &chores_, &seam_search_})
        if (work->is_running()) add(work->progress());
    for (const View& v : views_) {
        std::string stage;
        double fraction = 0;
        if (v.painter && v.is_painting) v.painter->progress().get(stage, fraction);
        if (!stage.empty() && stage != "render")
            panels.works.push_back(stage + " " + std::to_string(int(100 * fraction)) + " %");
    }
    draw_panels(panels);
    draw_status(panels);
    draw_help(panels);
    from_panels_ = std::move(panels.commands);
    if (!from_panels_.empty()) frames_to_draw_ = 3;
    window_->end_panels();
}

}  // namespace rakelight::viewer
