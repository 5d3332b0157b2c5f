// SPDX-License-Identifier: Apache-2.0
#include "player.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <rakelight/math/linear.h>

#include "recorded_keys.h"

namespace rakelight::viewer {
namespace {

constexpr double slowest = 1.0 / 16, fastest = 16;

double wrapped(double time_s, const ClipSpan& span) {
    const double along = std::fmod(time_s - span.begin_s, span.length());
    return span.begin_s + (along < 0 ? along + span.length() : along);
}

/// At rest, then one clip after the other.
void step_clip(Look& look, const Model& model, int by) {
    const int count = int(model.scene.animations.size()), now = chosen_clip(look, model).value_or(-1);
    const int next = (now + 1 + by + count + 1) % (count + 1);  // 0: at rest
    choose_clip(look, next == 0 ? std::nullopt : std::optional(next - 1));
}

void play(Player& player, Look& look, const Model& model, int width, int height) {
    if (player.is_playing) return void(player.is_playing = false);
    if (!has_motion(look) && !model.scene.animations.empty()) choose_clip(look, 0);
    if (!has_motion(look)) return;
    const ClipSpan span = span_of(look, model, player);
    if (!player.loops && time_of(look, model, player) >= span.end_s)
        set_time(look, model, player, width, height, span.begin_s);
    player.is_playing = true;
}

std::string text_of(const char* format, double value) {
    char text[60];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

double Player::elapsed(double now_s) {
    const double elapsed_s = last_s_ ? std::max(0.0, now_s - *last_s_) : 0;
    last_s_ = now_s;
    return elapsed_s;
}

bool has_motion(const Look& look) { return look.request.motion.is_set() || !key_times(look).empty(); }

ClipSpan span_of(const Look& look, const Model& model, const Player& player) {
    std::optional<ClipSpan> span;
    const auto add = [&](double begin_s, double end_s) {
        if (!span) span = {begin_s, end_s};
        span = {std::min(span->begin_s, begin_s), std::max(span->end_s, end_s)};
    };
    for (const ClipTime& clip : clips_of(look, model)) {
        const ClipSpan one = clip_span(model.scene.animations[clip.animation]);
        add(one.begin_s, one.end_s);
    }
    if (!span) add(0, player.length_s);
    for (const double time_s : key_times(look)) add(time_s, time_s);
    return *span;
}

double time_of(const Look& look, const Model& model, const Player& player) {
    if (look.time_s) return *look.time_s;
    return look.request.motion.time_s.value_or(span_of(look, model, player).begin_s);
}

void set_time(Look& look, const Model& model, const Player& player, int width, int height, double time_s) {
    const ClipSpan span = span_of(look, model, player);
    if (!look.eye && !current_camera(look, model)) moving_eye(look, model, width, height);
    look.time_s = std::clamp(time_s, span.begin_s, span.end_s);
    follow_keys(look, *look.time_s);
}

void choose_clip(Look& look, std::optional<int> clip) {
    look.request.motion = {.index = clip};
    look.time_s.reset();
}

std::optional<int> chosen_clip(const Look& look, const Model& model) {
    if (!look.request.motion.is_set() || look.request.motion.index == -1) return {};
    const std::vector<ClipTime> clips = clips_of(look, model);
    return clips.empty() ? std::nullopt : std::optional(int(clips[0].animation));
}

bool advance(Look& look, const Model& model, const Player& player, int width, int height, double elapsed_s) {
    if (player.is_turning) {
        Eye& eye = moving_eye(look, model, width, height);
        go_around(eye, 2 * pi * elapsed_s / player.turn_s, look.world_up);
    }
    if (!player.is_playing) return true;
    const ClipSpan span = span_of(look, model, player);
    double time_s = time_of(look, model, player) + elapsed_s * player.speed;
    const bool is_over = time_s > span.end_s;
    if (is_over && player.loops && span.length() > 0) time_s = wrapped(time_s, span);
    set_time(look, model, player, width, height, time_s);
    return player.loops || !is_over;
}

bool apply(Command command, Player& player, Look& look, const Model& model, int width, int height) {
    const auto step = [&](double by_s) {
        player.is_playing = false;
        set_time(look, model, player, width, height, time_of(look, model, player) + by_s);
        return true;
    };
    switch (command) {
        case Command::play:
            return play(player, look, model, width, height), true;
        case Command::next_clip:
            return step_clip(look, model, 1), true;
        case Command::previous_clip:
            return step_clip(look, model, -1), true;
        case Command::at_rest:
            player.is_playing = player.is_turning = false;
            return choose_clip(look, {}), true;
        case Command::frame_back:
            return step(-frame_s);
        case Command::frame_on:
            return step(frame_s);
        case Command::slower:
            return player.speed = std::max(slowest, player.speed / 2), true;
        case Command::faster:
            return player.speed = std::min(fastest, player.speed * 2), true;
        case Command::loop:
            return player.loops = !player.loops, true;
        case Command::turntable:
            return player.is_turning = !player.is_turning, true;
        case Command::set_key:
            return set_key(look, model, width, height, time_of(look, model, player)), true;
        case Command::delete_key:
            return delete_key(look, time_of(look, model, player)), true;
        default:
            return false;
    }
}

std::string clip_title(const Model& model, std::optional<int> clip) {
    if (!clip) return "at rest";
    if (*clip < 0) return "all clips";
    const Animation& animation = model.scene.animations.at(std::size_t(*clip));
    const std::string name = animation.name.empty() ? "clip" : one_line(animation.name, 40);
    return std::to_string(*clip) + ": " + name + text_of(", %.2f s", clip_span(animation).length());
}

std::string effect_of(Command command, const Player& player, const Look& look, const Model& model) {
    const double time_s = time_of(look, model, player);
    switch (command) {
        case Command::play:
            if (!has_motion(look)) return "nothing to play: the model has no clips, and there are no keys";
            return player.is_playing ? "plays" : text_of("paused at %.3f s", time_s);
        case Command::next_clip:
        case Command::previous_clip:
            if (model.scene.animations.empty()) return "the model has no clips";
            return clip_title(model, chosen_clip(look, model));
        case Command::at_rest:
            return clip_title(model, {});
        case Command::frame_back:
        case Command::frame_on:
            return text_of("%.3f s", time_s);
        case Command::slower:
        case Command::faster:
            return text_of("speed %g", player.speed);
        case Command::loop:
            return player.loops ? "loop: on" : "loop: off";
        case Command::turntable:
            return player.is_turning ? text_of("turntable: %g s around", player.turn_s) : "turntable: off";
        case Command::set_key:
            return text_of("key set at %.3f s", time_s);
        case Command::delete_key:
            return std::to_string(key_times(look).size()) + " keys are left";
        default:
            return {};
    }
}

}  // namespace rakelight::viewer
