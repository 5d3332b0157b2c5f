// SPDX-License-Identifier: Apache-2.0
// The whole way of one picture: load -> prepare -> camera and lights -> engine -> tone mapping -> file.
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

/// The camera for a picture of `aspect` = width / height: placed in the world, no node, no aspect of its own (a camera
/// of the file that wants another aspect is widened until all it wants to show is in the picture), near and far about
/// the model. A camera of the file that cannot see any of the model's bounding box is replaced by the fitted one, with
/// a warning.
/// @throws Error usage: no such side or camera, impossible angle or position; bad_file "nothing to draw".
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Context& context);

/// What the ends of the gray and color scales of PNG channels mean: the model's bounding box, whatever of it is in the
/// picture, so that windows fit together.
struct ViewRange {
    double depth_low = 0, depth_high = 0;  ///< [m] along the view axis, cut to the camera's near and far
    dvec3 low{}, high{};                   ///< [m] world
};

/// What was made of one PictureRequest.
struct PictureResult {
    std::string file{}, output{};  ///< the model; the picture that was written
    std::vector<std::string>
        channel_files{};        ///< EXR files in the order of the Channel bits, the one of layers, PNG files
    ViewRange view_range{};     ///< of PNG channels
    int width = 0, height = 0;  ///< [px] of the file
    std::uint64_t triangles = 0, objects = 0;  ///< that were drawn, instances counted each time
    std::string engine{}, isa{};               ///< the instruction set is empty for engines that do not choose one
    int threads = 0;                           ///< worker threads
    double load_ms = 0, prepare_ms = 0, render_ms = 0, write_ms = 0;  ///< [ms] wall clock
    RenderStats stats{};
    /// Of 8-bit pictures: pixels whose red, green and blue are all 0, or all 255, the background's too.
    std::uint64_t black_pixels = 0, white_pixels = 0;
    double done =
        1;  ///< share of its pixels that were made; less than 1: it was cancelled (PictureRequest::keep_partial)
};

/// Makes a picture and its channel files. Memory: a strip of rows of at most 64 MiB, or 64 rows, beside the engine's
/// own. Either all files appear, whole, or none. Remarks go to context.report().
/// @throws Error usage, not_found, bad_file, failed; those about the model carry its name.
RL_API PictureResult render_picture(const PictureRequest& request, Context& context);
/// The same of a scene that is there; `request.input` is its name in what is returned. @throws Error as above; bad_file: see validate()
RL_API PictureResult render_picture(const Scene& scene, const PictureRequest& request, Context& context);

/// The same into memory: the bytes of the file that `request.output` names, by its ending; nothing is written.
/// @throws Error as above; usage: data channels in files of their own
RL_API PictureResult render_picture(const PictureRequest& request, std::vector<std::byte>& file, Context& context);

/// The color alone, in memory: what the PNG file would hold, RGB, or RGBA where background.w < 1. `request.output` and the data channels
/// count for nothing.
/// @throws Error as above
RL_API PictureResult render_picture(const PictureRequest& request, Pixels& color, Context& context);

/// Linear light of a display value (sRGB, 0..1), for backgrounds and light colors that people write as they see them.
RL_API vec3 linear_from_srgb(vec3 s);

/// Says what is wrong with a request before anything is loaded: ending, size, window, engine, missing output folder.
/// render_picture() calls it; callers with many pictures call it for all before they make the first.
/// @throws Error usage or failed
RL_API void check_request(const PictureRequest& request);
/// The same of a picture in memory.
RL_API void check_drawing(const PictureRequest& request);

}  // namespace rakelight
