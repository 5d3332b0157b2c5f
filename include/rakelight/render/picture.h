// SPDX-License-Identifier: Apache-2.0
// The whole pipeline of one picture: load -> prepare -> camera and lights -> engine -> tone mapping -> file.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/render.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// The camera for a picture of `aspect` = width / height. It is placed in world space, with near and far planes around
/// the model. If a camera of the file has another aspect, its field of view is widened until the picture contains the
/// original field of view. If the model's bounding box is outside of the view of that camera, a fitted camera replaces
/// it, with a warning.
/// @throws Error usage: no such side or camera, impossible angle or position; bad_file "nothing to draw".
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Context& context);

/// The camera that render_picture() chooses for a picture with this hidden-surface removal. The z-buffers of the textbook
/// (z_float, z16, z24, z32) lose precision if near is small: a camera inside of a scene then has near = far / 10000. All
/// others show what is nearer.
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                            Context& context);

/// Data channels (depth, position and so on) can be written as PNG files (channel_files_png). These files show depth
/// with a gray scale, and position with a color scale. ChannelRange has the values at the ends of both scales. They are
/// computed from the bounding box of the whole model. So all windows of a picture get the same values. (A window is a
/// part of the picture that is rendered separately.)
struct ChannelRange {
    double depth_low = 0, depth_high = 0;  ///< [m] along the view axis, clipped to the camera's near and far
    dvec3 low{}, high{};                   ///< [m] world
};

/// The result of one PictureRequest.
struct PictureResult {
    std::string file{}, output{};  ///< names of the model file and of the written picture
    /// The files of data channels, in this order: one EXR file per channel (in the order of the Channel bits), the EXR
    /// file with all channels as layers (channel_files_layers), the PNG files. Only files that the request asks for.
    std::vector<std::string> channel_files{};
    ChannelRange channel_range{};              ///< the scales of data channels in PNG files
    int width = 0, height = 0;                 ///< [px] of the picture file
    std::uint64_t triangles = 0, objects = 0;  ///< numbers of drawn triangles and objects; each instance counts
    std::string engine{}, isa{};               ///< `isa` is empty for engines that do not select an instruction set
    int threads = 0;                           ///< worker threads
    /// [ms] wall clock. Preparing ends when the engine has the scene and its textures; the small picture of
    /// Look::standard belongs to it.
    double load_ms = 0, prepare_ms = 0, render_ms = 0, write_ms = 0;
    RenderStats stats{};
    /// For 8-bit pictures: number of pixels with red, green and blue all 0 (black) or all 255 (white), background
    /// included.
    std::uint64_t black_pixels = 0, white_pixels = 0;
    double done = 1;  ///< 0..1: share of finished pixels; less than 1 if cancelled (PictureRequest::keep_partial)
};

/// Draws a picture and writes it with its channel files. Besides the memory of the engine, this function needs memory
/// for a strip of rows of the picture. The strip has as many rows as fit into 64 MiB, but at least 64 rows.
/// Either all files appear complete, or none. Remarks go to context.report().
/// @throws Error usage, not_found, bad_file, failed; errors about the model have its file name
RL_API PictureResult render_picture(const PictureRequest& request, Context& context);
/// The same for a scene in memory. PictureResult::file is then `request.input`, which serves only as a name.
/// @throws Error as above; bad_file: an invalid scene (see validate())
RL_API PictureResult render_picture(const Scene& scene, const PictureRequest& request, Context& context);

/// The same, but nothing is written to disk. `file` gets the bytes of the picture file. Its format follows from the
/// ending of `request.output`.
/// @throws Error as above; usage: the request has data channels in files of their own
RL_API PictureResult render_picture(const PictureRequest& request, std::vector<std::byte>& file, Context& context);

/// The same, but only the color, in memory. `color` gets the pixels of the PNG file: RGB, or RGBA if background.w < 1.
/// `request.output` and the data channels are ignored.
/// @throws Error as above
RL_API PictureResult render_picture(const PictureRequest& request, Pixels& color, Context& context);

/// The value of PictureResult::channel_range.
/// @param camera  result of choose_camera()
RL_API ChannelRange channel_range_of(const Bounds& bounds, const Camera& camera);

/// A channel of a frame as display values, as in PNG files of channels: [width * height of the frame's window] sRGB
/// codes, R in the low byte.
/// @param channel  one Channel bit
/// @throws Error usage: the frame has no such channel
RL_API std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ChannelRange& range);

/// The words of --channels, in the order of the Channel bits.
RL_API std::vector<std::string> channel_words();

/// Linear light of a display value (sRGB, 0..1), for backgrounds and light colors given as display colors.
RL_API vec3 linear_from_srgb(vec3 s);

/// Checks a request before anything is loaded: ending, size, window, engine, missing output folder. render_picture()
/// calls this function. If you draw many pictures, check all requests before you draw the first picture.
/// @throws Error usage or failed
RL_API void check_request(const PictureRequest& request);
/// The same for a picture that stays in memory: does not check the output.
RL_API void check_drawing(const PictureRequest& request);

}  // namespace rakelight
