// SPDX-License-Identifier: Apache-2.0
// Sequences of pictures: clips and turntables as numbered files. To make movies of these files: <rakelight/io/movie.h>.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>

namespace rakelight {

/// The pictures of a sequence to draw: first, first + step, ... up to last.
struct FrameRange {
    std::int64_t first = 0;              ///< number of the first picture
    std::optional<std::int64_t> last{};  ///< inclusive; absent: the last picture of the sequence
    std::int64_t step = 1;               ///< at least 1
    bool operator==(const FrameRange&) const = default;
};

/// A clip, a turntable, or a turntable while a clip plays. Picture k shows the clip at k / fps seconds after its start.
/// In a turntable the clip repeats after its end.
struct SequenceRequest {
    /// `output` contains {frame} or {frame:4}, which stands for the number of the picture. `motion` selects the clip;
    /// the default is the first clip. With `motion.time_s` a turntable shows only that moment of the clip.
    PictureRequest picture{};
    FrameRange frames{};
    double fps = 30;  ///< 0.01..1000
    /// 1..100000: number of pictures for one turn about the up axis. 0: no turntable. The camera orbits its focal
    /// point, so that the model seems to turn to the right, as in the viewer. Lights of the file stay in place. Default
    /// and studio lights move with the camera.
    int turntable = 0;
    /// Existing pictures are not drawn again. A file counts as existing if all of it can be decoded and it has the
    /// right size. A damaged one is drawn again, with a remark.
    bool skip_existing = false;
};

/// One picture of a sequence.
struct SequenceFrame {
    std::int64_t frame = 0;   ///< number of the picture
    double time_s = 0;        ///< [s] time of the clip; 0 without a clip
    bool is_skipped = false;  ///< the file existed, so `picture` has only the names
    PictureResult picture{};
};

inline constexpr std::int64_t max_frames = 100'000;  ///< maximum number of pictures in a sequence

/// Draws all pictures of a range, in order. The model is loaded and prepared once. Camera, background and exposure are
/// chosen once for the whole clip or turn. A fitted view contains the model at 16 moments of the clip and from all
/// sides of a turntable. Animated cameras of the file move. Each picture is bit-identical to the same picture drawn
/// alone. The report has the remarks on the first picture only.
/// @param done called for each picture when its file is complete
/// @return the number of pictures in the whole sequence
/// @throws Error as render_picture(); usage: neither clip nor turntable, a range outside of the sequence, more than
///         `max_frames`, no {frame} in the output; failed: cancelled. Pictures already written stay.
RL_API std::int64_t render_sequence(const SequenceRequest& request, Context& context,
                                    const std::function<void(const SequenceFrame&)>& done = {});

/// Checks a request before anything is loaded.
/// @throws Error usage or failed
RL_API void check_sequence(const SequenceRequest& request);

/// The file name of a picture: {frame:4} becomes its number with at least four digits, {{ and }} become single braces. All
/// other braces stay.
RL_API std::string frame_name(const std::string& output, std::int64_t frame);
/// Whether a name contains {frame}.
RL_API bool has_frame_number(const std::string& output);

}  // namespace rakelight
