// SPDX-License-Identifier: Apache-2.0
// The pictures of a sequence, and what each shows.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/render/sequence.h>

namespace rakelight {

class SequencePlan {
public:
    /// @throws Error usage: neither clip nor turntable, too many pictures, a range outside of the sequence
    SequencePlan(const Scene& scene, const SequenceRequest& request);

    std::int64_t count() const { return count_; }  ///< of the whole sequence
    bool has_clip() const { return !clips_.empty(); }
    bool is_turntable() const { return turns_ > 0; }
    /// The numbers of the pictures that are requested.
    std::vector<std::int64_t> frames() const;
    /// [s] of the clip
    double time_of(std::int64_t frame) const;
    /// [s] RenderSettings::shader_time_s: that of the clip; of a turntable without one since its first picture
    double shader_time_of(std::int64_t frame) const;
    /// [rad] How far the camera has orbited to the left: the model turns to the right.
    double angle_of(std::int64_t frame) const;
    /// Clips at a moment.
    std::vector<ClipTime> clips_at(double time_s) const;
    double begin_s() const { return begin_s_; }
    /// [s] evenly spaced from the start to the end of the clip; only the start if nothing moves.
    std::vector<double> moments(int count) const;

private:
    void take_clips(const Scene& scene, const MotionRequest& motion);
    void count_frames(double fps);
    void check_range();

    std::vector<ClipTime> clips_;
    double begin_s_ = 0, end_s_ = 0, fps_;
    int turns_;
    std::int64_t count_ = 0;
    FrameRange range_;
};

/// @throws Error usage: fps, turntable or range that cannot be, whatever the scene
void check_numbers(const SequenceRequest& request);

}  // namespace rakelight
