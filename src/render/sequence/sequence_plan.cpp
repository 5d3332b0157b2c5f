// SPDX-License-Identifier: Apache-2.0
#include "render/sequence/sequence_plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <rakelight/math/linear.h>

#include "base/format_text.h"

namespace rakelight {
namespace {

constexpr double slack = 1e-6;  ///< [pictures] the last key of a clip is rounded where it was written

std::string text_of(double number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

[[noreturn]] void too_many(double count) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", count);
    throw Error(ErrorCode::usage, format_text("the sequence has {} pictures; there can be {}", text, max_frames), {},
                "use fewer frames per second")
        .about("fps");
}

}  // namespace

void check_numbers(const SequenceRequest& request) {
    const FrameRange& range = request.frames;
    if (!(request.fps >= 0.01 && request.fps <= 1000))
        throw Error(ErrorCode::usage, "must be 0.01 to 1000").about("fps");
    if (request.turntable < 0 || request.turntable > max_frames)
        throw Error(ErrorCode::usage, "must be 1 to " + std::to_string(max_frames)).about("turntable");
    if (range.last && *range.last < range.first)
        throw Error(ErrorCode::usage, format_text("ends before it begins: {} comes after {}", range.first, *range.last))
            .about("frames");
    if (range.first < 0 || range.step < 1)
        throw Error(ErrorCode::usage, "must be A:B or A:B:STEP, from 0, with a step of 1 or more").about("frames");
    if (range.first >= max_frames || range.last.value_or(0) >= max_frames)
        throw Error(ErrorCode::usage, format_text("a sequence has at most {} pictures", max_frames)).about("frames");
    if (request.picture.motion.time_s && request.turntable == 0)
        throw Error(ErrorCode::usage, "is a single moment, but a sequence shows the whole clip", {},
                    "leave it out, or turn the model at that moment by 'turntable'")
            .about("animation-time", {"turntable"});
}

SequencePlan::SequencePlan(const Scene& scene, const SequenceRequest& request)
    : fps_(request.fps), turns_(request.turntable), range_(request.frames) {
    check_numbers(request);
    take_clips(scene, request.picture.motion);
    count_frames(request.fps);
    check_range();
}

void SequencePlan::take_clips(const Scene& scene, const MotionRequest& asked) {
    if (turns_ > 0 && !asked.is_set()) return;
    MotionRequest motion = asked;
    if (!asked.is_set()) motion.index = 0;
    if (turns_ == 0 && scene.animations.empty())
        throw Error(ErrorCode::usage, "the scene has no animations", {}, "'turntable' 72 turns the model")
            .naming({"turntable"});
    clips_ = clips_of(scene, motion);
    if (clips_.empty()) return;
    begin_s_ = clips_[0].time_s, end_s_ = begin_s_;
    if (motion.time_s) return;
    for (const ClipTime& clip : clips_) {
        const ClipSpan span = clip_span(scene.animations[clip.animation]);
        begin_s_ = std::min(begin_s_, span.begin_s), end_s_ = std::max(end_s_, span.end_s);
    }
}

void SequencePlan::count_frames(double fps) {
    const double of_clip = (end_s_ - begin_s_) * fps + slack;
    if (turns_ == 0 && !(of_clip < double(max_frames))) too_many(of_clip);
    count_ = turns_ > 0 ? turns_ : std::int64_t(std::floor(of_clip)) + 1;
}

void SequencePlan::check_range() {
    if (!range_.last) range_.last = std::max(range_.first, count_ - 1);
    if (*range_.last < count_) return;
    const std::string what = turns_ > 0 ? "the turntable" : "at " + text_of(fps_) + " per second, the clip";
    throw Error(ErrorCode::usage, format_text("{} has the frames 0 to {}", what, count_ - 1))
        .about("frames", {turns_ > 0 ? "turntable" : "fps"});
}

std::vector<std::int64_t> SequencePlan::frames() const {
    std::vector<std::int64_t> numbers;
    for (std::int64_t frame = range_.first; frame <= *range_.last; frame += range_.step) numbers.push_back(frame);
    return numbers;
}

double SequencePlan::time_of(std::int64_t frame) const {
    const double length = end_s_ - begin_s_;
    double passed = double(frame) / fps_;
    if (!(length > 0)) return begin_s_;
    if (turns_ > 0) passed -= length * std::floor(passed / length);
    return std::min(begin_s_ + passed, end_s_);
}

double SequencePlan::shader_time_of(std::int64_t frame) const {
    return has_clip() ? time_of(frame) : double(frame) / fps_;
}

double SequencePlan::angle_of(std::int64_t frame) const { return turns_ > 0 ? 2 * pi * double(frame) / turns_ : 0; }

std::vector<ClipTime> SequencePlan::clips_at(double time_s) const {
    std::vector<ClipTime> clips = clips_;
    for (ClipTime& clip : clips) clip.time_s = time_s;
    return clips;
}

std::vector<double> SequencePlan::moments(int count) const {
    if (!(end_s_ > begin_s_)) return {begin_s_};
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(begin_s_ + (end_s_ - begin_s_) * k / (count - 1));
    return times;
}

}  // namespace rakelight
