// SPDX-License-Identifier: Apache-2.0
#include "gl_painter.h"

#include <algorithm>
#include <chrono>

namespace rakelight::viewer {
namespace {

constexpr int warm_side_px = 16;         // of the picture that programs are made by
constexpr std::size_t most_warmed = 64;  // settings that are remembered

/// As those of two moments of one model do. Where one is wrongly said to, its picture takes a little longer.
bool need_same_programs(const Scene& a, const Scene& b) {
    return a.materials == b.materials && a.textures == b.textures && a.meshes.size() == b.meshes.size() &&
           a.lights.size() == b.lights.size();
}

}  // namespace

void GlPainter::begin() {
    if (view_) return;
    context_->make_current();
    is_current_ = true;
    view_.emplace();
    pictures_.emplace();
}

void GlPainter::end() {
    if (!is_current_) return;
    pictures_.reset();
    view_.reset();
    context_->release();
    is_current_ = false;
}

bool GlPainter::upload(const std::shared_ptr<const PreparedScene>& scene, double milliseconds, Context& context) {
    begin();
    if (scene == scene_) return true;
    if (!view_->upload(scene, milliseconds, context)) return false;
    if (!scene_ || !need_same_programs(unposed_scene_of(*scene_), unposed_scene_of(*scene))) warmed_.clear();
    scene_ = scene;
    return true;
}

/// Drivers make code when a program draws first (llvmpipe: 140 to 430 ms each). A tiny picture has it made: its time is not taken
/// for that of pictures, and no picture of an older job waits for it.
void GlPainter::warm(const Shot& shot, const ToneSettings& tone, Context& context) {
    const RenderSettings& settings = shot.settings;
    RenderSettings tiny = settings;
    const int side = std::max(settings.width, settings.height);
    tiny.width = std::max(1, settings.width * warm_side_px / side);
    tiny.height = std::max(1, settings.height * warm_side_px / side);
    tiny.line_width = 1, tiny.point_size = 1;
    const Warmed wanted{tiny, tone.mapping};
    if (std::ranges::find(warmed_, wanted) != warmed_.end()) return;
    pictures_->begin(tiny.width, tiny.height);
    view_->draw({shot.camera, tiny, shot.lights}, tone, context);
    pictures_->finish();
    if (warmed_.size() >= most_warmed) warmed_.clear();
    warmed_.push_back(wanted);
}

GlPainter::Drawn GlPainter::draw(const Shot& shot, const ToneSettings& tone, std::span<const Line> lines,
                                 Context& context) {
    begin();
    warm(shot, tone, context);
    const auto from = std::chrono::steady_clock::now();
    pictures_->begin(shot.settings.width, shot.settings.height);
    Drawn drawn;
    drawn.stats = view_->draw(shot, tone, context);
    view_->lines(shot.camera, lines);
    drawn.picture = pictures_->finish();
    drawn.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
    return drawn;
}

}  // namespace rakelight::viewer
