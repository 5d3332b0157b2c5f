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
#include <rakelight/render/camera_chooser.h>
#include <rakelight/render/channel_view.h>
#include <rakelight/render/render.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/world/request.h>

namespace rakelight {

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

/// Linear light of a display value (sRGB, 0..1), for backgrounds and light colors given as display colors.
RL_API vec3 linear_from_srgb(vec3 s);

/// Checks a request before anything is loaded: ending, size, window, engine, missing output folder. render_picture()
/// calls this function. If you draw many pictures, check all requests before you draw the first picture.
/// @throws Error usage or failed
RL_API void check_request(const PictureRequest& request);
/// The same for a picture that stays in memory: does not check the output.
RL_API void check_drawing(const PictureRequest& request);

}  // namespace rakelight
