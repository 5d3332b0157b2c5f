// SPDX-License-Identifier: Apache-2.0
// What is displayed: pictures, lines over them, panels.
#include <algorithm>

#include "app.h"
#include "panels/floating_windows.h"
#include "view/overlay.h"

namespace rakelight::viewer {
namespace {

constexpr std::uint32_t line_color = 0xff40a0ffu;  // between A and B; sRGB, R in the low byte

}  // namespace

void App::draw() {
    if (window_->width() == 0 || window_->height() == 0) return;
    window_->set_viewport(0, 0, 0, 0);
    window_->clear();
    window_->begin_panels();
    if (ui_.split != Split::wipe) wipe_ = {};
    if (ui_.split == Split::wipe)
        draw_wipe();
    else
        for (std::size_t i = 0; i < view_count(); ++i) draw_picture(views_[i]);
    draw_split();
    draw_panels_over();
    window_->end_panels();
    for (std::size_t i = 0; i < view_count(); ++i)
        if (views_[i].displayed && views_[i].displayed->picture) mark_as_displayed(*views_[i].displayed->picture);
    window_->swap();
    if (views_[0].displayed) times_.display(views_[0].displayed->number);
}

PixelBox App::box_of(const View& view) const { return {view.area.x, view.area.y, view.area.width, view.area.height}; }

/// With its lines.
void App::draw_picture(View& view) {
    if (!view.displayed) return;
    if (view.displayed->picture) return window_->show(*view.displayed->picture, box_of(view), box_of(view));
    show_codes(view);
    draw_lines(view);
}

void App::show_codes(View& view) {
    const Rectangle& a = view.area;
    window_->set_viewport(a.x, a.y, a.width, a.height);
    if (!view.screen) view.screen = std::make_unique<GlView>();
    if (view.on_screen == view.displayed && view.screen->show_again()) return;
    view.screen->show(view.displayed->width, view.displayed->height, view.displayed->codes);
    view.on_screen = view.displayed;
}

/// A left of the line, B right of it.
void App::draw_wipe() {
    const auto &a = views_[0].displayed, &b = views_[1].displayed;
    if (!a || !b) return draw_picture(views_[a ? 0 : 1]);
    if (a->picture || b->picture) return draw_wipe_on_gpu();
    draw_wipe_of_codes();
    draw_lines(views_[0]);
}

void App::draw_wipe_on_gpu() {
    const PixelBox all = box_of(views_[0]);
    const int line = int(ui_.wipe * all.width);
    const PixelBox halves[2] = {{all.x, all.y, line, all.height}, {all.x + line, all.y, all.width - line, all.height}};
    for (View& view : views_)
        if (!view.displayed->picture) draw_picture(view);  // whole: the other one covers a half of it
    for (int i = 0; i < 2; ++i)
        if (views_[i].displayed->picture) window_->show(*views_[i].displayed->picture, all, halves[i]);
    const int from = std::max(0, line - 1), to = std::min(all.width, line + 1);
    window_->fill({all.x + from, all.y, to - from, all.height}, line_color);
}

/// Pictures of different sizes (one is coarse still) are sampled at their nearest pixels.
void App::draw_wipe_of_codes() {
    const auto &a = views_[0].displayed, &b = views_[1].displayed;
    const Rectangle& area = views_[0].area;
    GlView& screen = *views_[0].screen;
    window_->set_viewport(area.x, area.y, area.width, area.height);
    const int line = int(ui_.wipe * area.width);
    const Wipe wanted{a, b, line, area.width, area.height};
    if (wipe_ == wanted && !views_[0].on_screen && screen.show_again()) return;
    wiped_.resize(std::size_t(area.width) * std::size_t(area.height));
    const auto copy = [&](const Painting& from, int begin, int end) {
        std::vector<std::uint32_t> columns;  // a division a pixel would take long
        for (int x = begin; x < end; ++x) columns.push_back(std::uint32_t(std::int64_t(x) * from.width / area.width));
        for (int y = 0; y < area.height; ++y) {
            const std::size_t row = std::size_t(std::int64_t(y) * from.height / area.height) * std::size_t(from.width);
            std::uint32_t* to = wiped_.data() + std::size_t(y) * std::size_t(area.width) + begin;
            for (const std::uint32_t column : columns) *to++ = from.codes[row + column];
        }
    };
    copy(*a, 0, line);
    copy(*b, line, area.width);
    for (int x = std::max(0, line - 1); x < std::min(area.width, line + 1); ++x)
        for (int y = 0; y < area.height; ++y)
            wiped_[std::size_t(y) * std::size_t(area.width) + std::size_t(x)] = line_color;
    screen.show(area.width, area.height, wiped_, false);
    wipe_ = wanted;
    views_[0].on_screen.reset();
}

/// Over a picture that is not on the GPU: those on it have theirs.
void App::draw_lines(View& view) {
    if (!view.displayed || !model_ || view.displayed->model != model_) return;
    const Painting& p = *view.displayed;
    const Rectangle& a = view.area;
    std::vector<Line> lines =
        view.mark_lines.lines(marks(view), view.look, *model_, p.prepared, p.camera, a.width, a.height);
    if (lines.empty()) return;
    if (!p.depth.empty())
        lines = visible_lines(lines, p.camera, p.depth, p.width, p.height, 0.004 * model_->box.bounds().diagonal());
    window_->set_viewport(a.x, a.y, a.width, a.height);
    view.screen->lines(p.camera, lines);
}

/// Which picture is which, and which of them keys and panels change.
void App::draw_split() {
    if (ui_.split == Split::none || !model_) return;
    const PixelBox a = box_of(views_[0]), b = box_of(views_[1]);
    const int line = ui_.split == Split::beside ? b.x : a.x + int(ui_.wipe * a.width), away = int(8 * window_->scale());
    if (ui_.split == Split::beside) window_->fill({b.x - 1, b.y, 2, b.height}, line_color);
    window_->label(a.x + away, a.y + away, "A", ui_.active == 0);
    window_->label(line + away, a.y + away, "B", ui_.active == 1);
}

void App::draw_panels_over() {
    View& view = active();
    PanelView panels{.model = model_.get(), .look = view.look, .ui = ui_, .painting = view.displayed.get()};
    panels.width = view.area.width, panels.height = view.area.height;
    const float pixels_a_point = window_->pixels_a_point();
    panels.window_width = std::max(1, int(float(window_->width()) / pixels_a_point));
    panels.window_height = std::max(1, int(float(window_->height()) / pixels_a_point));
    panels.scale = window_->scale() / pixels_a_point, panels.longest_block_ms = times_.longest_pause_ms();
    panels.own_keys = remembered_.own_keys;
    panels.file_number = files_.number(), panels.file_count = files_.count();
    const std::shared_ptr<const Seams> seams = analysis_.seams(model_);
    panels.seams = seams.get();
    for (const Background* work : works())
        if (const std::string text = to_text(work->progress()); work->is_running() && !text.empty())
            panels.works.push_back(text);
    if (const std::size_t waiting = exports_.writer().waiting(); waiting > 0 && !panels.works.empty())
        panels.works.back() += ", " + std::to_string(waiting) + " more to be written";
    for (const View& v : views_)
        if (const std::string text = v.painter && v.is_painting ? to_text(v.painter->progress(), "render") : "";
            !text.empty())
            panels.works.push_back(text);
    draw_panels(panels);
    draw_status(panels);
    draw_help(panels);
    from_panels_ = std::move(panels.commands);
    if (!from_panels_.empty()) ui_.redraw();
}

}  // namespace rakelight::viewer
