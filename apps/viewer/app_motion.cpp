// SPDX-License-Identifier: Apache-2.0
// What plays: each picture is of the moment at which it is requested, and the next one is requested when it is there. What there
// is no time for is left out.
#include <algorithm>

#include "app.h"

namespace rakelight::viewer {
namespace {

constexpr double shortest_s = 1.0 / 60;  // from one moment to the next

}  // namespace

bool App::plays() const { return model_ && ui_.player.moves(); }

bool App::is_view_painting() const {
    return std::any_of(views_, views_ + view_count(), [](const View& view) { return view.is_painting; });
}

/// [s] How long the window may sleep; painters wake it.
double App::wait_s() const {
    if (ui_.frames_to_draw > 0 || (ui_.is_walking && is_stepping())) return 0;
    if (!plays()) return is_busy() ? 0.1 : 0.25;
    if (is_view_painting()) return 0.1;
    const std::chrono::duration<double> since = Clock::now() - last_moment_;
    return std::clamp(shortest_s - since.count(), 0.0, shortest_s);
}

/// Continues to the present moment, unless pictures of the one before are still to come.
void App::play() {
    Player& player = ui_.player;
    if (!plays()) return player.stop_clock();
    const auto now = Clock::now();
    if (is_view_painting() || std::chrono::duration<double>(now - last_moment_).count() < 0.5 * shortest_s) return;
    last_moment_ = now;
    const double elapsed_s = player.elapsed(std::chrono::duration<double>(now.time_since_epoch()).count());
    bool goes_on = false;
    for (std::size_t i = 0; i < view_count(); ++i) {
        View& view = views_[i];
        goes_on |= advance(view.look, *model_, player, view.area.width, view.area.height, elapsed_s);
    }
    player.is_playing &= goes_on;
    ++moments_;
}

/// Of a model that has just come.
void App::take_motion(bool keeps) {
    if (!keeps) {
        ui_.player.is_playing = model_->request.motion.autoplay;
        ui_.player.is_turning = false;
        return;
    }
    for (View& view : views_) try {
            clips_of(view.look, *model_);
        } catch (const Error&) {  // the file has lost the clip
            choose_clip(view.look, {});
        }
}

}  // namespace rakelight::viewer
