// SPDX-License-Identifier: Apache-2.0
// Sequences of pictures: clips and turntables as numbered files. Movies of them: <rakelight/movie.h>.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>

namespace rakelight {

/// Which pictures of a sequence are drawn: first, first + step, ... up to last.
struct FrameRange {
    std::int64_t first = 0;              ///< number of a picture
    std::optional<std::int64_t> last{};  ///< inclusive; absent: the sequence's own last
    std::int64_t step = 1;               ///< at least 1
    bool operator==(const FrameRange&) const = default;
};

/// A clip, a turntable, or a turntable while a clip plays. Picture k shows the clip at its begin + k / fps; after its end, which only a
/// turntable reaches, the clip begins anew.
struct SequenceRequest {
    /// `output` has {frame} or {frame:4} in it, the number of the picture. `motion` says which clip (default: the first); with
    /// `motion.time_s` a turntable shows that moment alone.
    PictureRequest picture{};
    FrameRange frames{};
    double fps = 30;  ///< 0.01..1000
    /// 1..100000 pictures once around the axis that is up; 0: no turntable. The camera goes round what it looks at such that the model
    /// turns to the right, as in the viewer. Lights of the file stay in the world; default and studio lights go with the camera.
    int turntable = 0;
    /// Pictures that are there are not drawn again: a file with the name is enough, but a PNG has to be whole and of the right size.
    bool skip_existing = false;
};

/// One picture of a sequence.
struct SequenceFrame {
    std::int64_t frame = 0;   ///< its number
    double time_s = 0;        ///< of the clip; 0 without one
    bool is_skipped = false;  ///< it was there: `picture` has its names alone
    PictureResult picture{};
};

inline constexpr std::int64_t most_frames = 100'000;  ///< of one sequence

/// Draws all pictures of a range, in order. The model is loaded and prepared once. Camera, background and exposure are chosen once, for
/// the whole clip or turn: a fitted view shows what is drawn at 16 moments of the clip, from all sides of a turntable; cameras of the
/// file that the clip moves do move. Each picture has the bits that it has when it is drawn alone, whatever the range. The first
/// picture's remarks stand for all.
/// @param done  told of each picture when its file is whole
/// @return how many pictures the whole sequence has
/// @throws Error as render_picture(); usage: neither clip nor turntable, a range outside of the sequence, more than `most_frames`, no
///         {frame} in the output; failed: cancelled, what is written stays
RL_API std::int64_t render_sequence(const SequenceRequest& request, Context& context,
                                    const std::function<void(const SequenceFrame&)>& done = {});

/// What is wrong with a request before anything is loaded. @throws Error usage or failed
RL_API void check_sequence(const SequenceRequest& request);

/// The name of a picture: {frame:4} becomes its number of at least four digits. All other braces stay.
RL_API std::string frame_name(const std::string& output, std::int64_t frame);
/// Whether there is a {frame} in it.
RL_API bool has_frame_number(const std::string& output);

}  // namespace rakelight
