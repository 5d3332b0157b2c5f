// SPDX-License-Identifier: Apache-2.0
// The whole pipeline of one picture: load -> prepare -> camera and lights -> engine -> tone mapping -> file.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/prepare.h>
#include <rakelight/render.h>
#include <rakelight/request.h>

namespace rakelight {

/// The camera for a picture of `aspect` = width / height, placed in world space, with near and far planes around the
/// model. A camera of the file with another aspect is widened until its whole field of view is in the picture. A camera
/// of the file that sees nothing of the model's bounding box is replaced by a fitted one, with a warning.
/// @throws Error usage: no such side or camera, impossible angle or position; bad_file "nothing to draw".
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Context& context);

/// The values at the ends of the gray and color scales of PNG channels. They come from the model's whole bounding box,
/// so that windows of one picture match.
struct ChannelRange {
    double depth_low = 0, depth_high = 0;  ///< [m] along the view axis, clipped to the camera's near and far
    dvec3 low{}, high{};                   ///< [m] world
};

/// The result of one PictureRequest.
struct PictureResult {
    std::string file{}, output{};  ///< the model; the written picture
    std::vector<std::string>
        channel_files{};           ///< EXR files in the order of the Channel bits, the file of layers, PNG files
    ChannelRange channel_range{};  ///< of PNG channels
    int width = 0, height = 0;     ///< [px] of the file
    std::uint64_t triangles = 0, objects = 0;  ///< drawn; each instance counts
    std::string engine{}, isa{};               ///< `isa` is empty for engines that do not select an instruction set
    int threads = 0;                           ///< worker threads
    double load_ms = 0, prepare_ms = 0, render_ms = 0, write_ms = 0;  ///< [ms] wall clock
    RenderStats stats{};
    /// Of 8-bit pictures: pixels whose red, green and blue are all 0, or all 255, including the background.
    std::uint64_t black_pixels = 0, white_pixels = 0;
    double done = 1;  ///< 0..1 share of finished pixels; less than 1: cancelled (PictureRequest::keep_partial)
};

/// Draws a picture and writes it with its channel files. Memory: a strip of rows of at most 64 MiB, or 64 rows, besides
/// the engine's own. Either all files appear complete, or none. Remarks go to context.report().
/// @throws Error usage, not_found, bad_file, failed; errors about the model carry its file name.
RL_API PictureResult render_picture(const PictureRequest& request, Context& context);
/// The same for a scene in memory; `request.input` is its name in the result.
/// @throws Error as above; bad_file: see
/// validate()
RL_API PictureResult render_picture(const Scene& scene, const PictureRequest& request, Context& context);

/// The same into memory: `file` gets the bytes of the picture file, in the format of the ending of `request.output`.
/// Nothing is written.
/// @throws Error as above; usage: data channels in files of their own
RL_API PictureResult render_picture(const PictureRequest& request, std::vector<std::byte>& file, Context& context);

/// Only the color, in memory: the pixels of the PNG file, RGB, or RGBA where background.w < 1. `request.output` and the
/// data channels are ignored.
/// @throws Error as above
RL_API PictureResult render_picture(const PictureRequest& request, Pixels& color, Context& context);

/// Linear light of a display value (sRGB, 0..1), for backgrounds and light colors given as display colors.
RL_API vec3 linear_from_srgb(vec3 s);

/// Checks a request before anything is loaded: ending, size, window, engine, missing output folder. render_picture()
/// calls it; callers with many pictures call it for all of them before they draw the first.
/// @throws Error usage or failed
RL_API void check_request(const PictureRequest& request);
/// The same for a picture that stays in memory.
RL_API void check_drawing(const PictureRequest& request);

}  // namespace rakelight
