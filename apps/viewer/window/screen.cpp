// SPDX-License-Identifier: Apache-2.0
#include "screen.h"

#include <algorithm>

#include "../view/overlay.h"

namespace rakelight::viewer {
namespace {

constexpr std::uint32_t line_color = 0xff40a0ffu;  // between A and B; sRGB, R in the low byte

/// Columns of a picture, stretched to a width and height by their nearest pixels.
void copy_columns(const Painting& from, int begin, int end, int width, int height, std::vector<std::uint32_t>& to) {
    std::vector<std::uint32_t> columns;  // a division a pixel would take long
    for (int x = begin; x < end; ++x) columns.push_back(std::uint32_t(std::int64_t(x) * from.width / width));
    for (int y = 0; y < height; ++y) {
        const std::size_t row = std::size_t(std::int64_t(y) * from.height / height) * std::size_t(from.width);
        std::uint32_t* pixel = to.data() + std::size_t(y) * std::size_t(width) + begin;
        for (const std::uint32_t column : columns) *pixel++ = from.codes[row + column];
    }
}

}  // namespace

Screen::Screen(GlfwWindow& window) : window_(window) { canvases_[0].gl = std::make_unique<GlView>(); }

void Screen::draw(const Pictures& pictures, const UiState& ui, std::span<const Marks> marks) {
    if (ui.split == Split::wipe) {
        draw_wipe(pictures, ui.wipe, marks);
    } else {
        wipe_ = {};
        for (std::size_t i = 0; i < pictures.count(); ++i) draw_picture(pictures, i, marks[i]);
    }
    draw_split(pictures, ui);
}

/// With its lines.
void Screen::draw_picture(const Pictures& pictures, std::size_t i, const Marks& marks) {
    const PictureView& view = pictures[i];
    if (!view.displayed()) return;
    if (view.displayed()->picture) return window_.show(*view.displayed()->picture, view.area, view.area);
    show_codes(view, canvases_[i]);
    draw_lines(pictures, i, marks);
}

void Screen::show_codes(const PictureView& view, Canvas& canvas) {
    const PixelBox& a = view.area;
    window_.set_viewport(a.x, a.y, a.width, a.height);
    if (!canvas.gl) canvas.gl = std::make_unique<GlView>();
    if (canvas.shown == view.displayed() && canvas.gl->show_again()) return;
    canvas.gl->show(view.displayed()->width, view.displayed()->height, view.displayed()->codes);
    canvas.shown = view.displayed();
}

/// A left of the line, B right of it.
void Screen::draw_wipe(const Pictures& pictures, double share, std::span<const Marks> marks) {
    const auto &a = pictures[0].displayed(), &b = pictures[1].displayed();
    if (!a || !b) return a ? draw_picture(pictures, 0, marks[0]) : draw_picture(pictures, 1, marks[1]);
    const PixelBox& area = pictures[0].area;
    const int line = int(share * area.width);
    if (a->picture || b->picture) return draw_wipe_on_gpu(pictures, line, marks);
    draw_wipe_of_codes({a, b, line, area.width, area.height}, area);
    draw_lines(pictures, 0, marks[0]);
}

void Screen::draw_wipe_on_gpu(const Pictures& pictures, int line, std::span<const Marks> marks) {
    const PixelBox& all = pictures[0].area;
    const PixelBox halves[2] = {{all.x, all.y, line, all.height}, {all.x + line, all.y, all.width - line, all.height}};
    for (std::size_t i = 0; i < 2; ++i)
        if (!pictures[i].displayed()->picture)
            draw_picture(pictures, i, marks[i]);  // whole: the other one covers a half of it
    for (std::size_t i = 0; i < 2; ++i)
        if (pictures[i].displayed()->picture) window_.show(*pictures[i].displayed()->picture, all, halves[i]);
    const int from = std::max(0, line - 1), to = std::min(all.width, line + 1);
    window_.fill({all.x + from, all.y, to - from, all.height}, line_color);
}

/// Pictures of different sizes (one is coarse still) are sampled at their nearest pixels.
void Screen::draw_wipe_of_codes(const Wipe& wanted, const PixelBox& area) {
    Canvas& canvas = canvases_[0];
    window_.set_viewport(area.x, area.y, area.width, area.height);
    if (wipe_ == wanted && !canvas.shown && canvas.gl->show_again()) return;
    wiped_.resize(std::size_t(area.width) * std::size_t(area.height));
    copy_columns(*wanted.a, 0, wanted.line, area.width, area.height, wiped_);
    copy_columns(*wanted.b, wanted.line, area.width, area.width, area.height, wiped_);
    for (int x = std::max(0, wanted.line - 1); x < std::min(area.width, wanted.line + 1); ++x)
        for (int y = 0; y < area.height; ++y)
            wiped_[std::size_t(y) * std::size_t(area.width) + std::size_t(x)] = line_color;
    canvas.gl->show(area.width, area.height, wiped_, false);
    wipe_ = wanted;
    canvas.shown.reset();
}

/// Over a picture that is not on the GPU: those on it have theirs.
void Screen::draw_lines(const Pictures& pictures, std::size_t i, const Marks& marks) {
    const PictureView& view = pictures[i];
    const std::shared_ptr<const Model>& model = pictures.model();
    if (!view.displayed() || !model || view.displayed()->model != model) return;
    const Painting& p = *view.displayed();
    const PixelBox& a = view.area;
    Canvas& canvas = canvases_[i];
    std::vector<Line> lines = canvas.lines.lines(marks, view.look, *model, p.prepared, p.camera, a.width, a.height);
    if (lines.empty()) return;
    if (!p.depth.empty())
        lines = visible_lines(lines, p.camera, p.depth, p.width, p.height, 0.004 * model->box.bounds().diagonal());
    window_.set_viewport(a.x, a.y, a.width, a.height);
    canvas.gl->lines(p.camera, lines);
}

/// Which picture is which, and which of them keys and panels change.
void Screen::draw_split(const Pictures& pictures, const UiState& ui) {
    if (ui.split == Split::none || !pictures.model()) return;
    const PixelBox &a = pictures[0].area, &b = pictures[1].area;
    const int line = ui.split == Split::beside ? b.x : a.x + int(ui.wipe * a.width), away = int(8 * window_.scale());
    if (ui.split == Split::beside) window_.fill({b.x - 1, b.y, 2, b.height}, line_color);
    window_.label(a.x + away, a.y + away, "A", ui.active == 0);
    window_.label(line + away, a.y + away, "B", ui.active == 1);
}

}  // namespace rakelight::viewer
