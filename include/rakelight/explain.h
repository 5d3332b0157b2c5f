// SPDX-License-Identifier: Apache-2.0
// Explains the color of a pixel: all intermediate values of the soft engine.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>

namespace rakelight {

/// One pixel with all its intermediate values; read it with to_text() and to_json().
struct ExplainedPixel;

/// Explains one pixel of the picture that `request` describes; its window, channels, output and engine are ignored. The
/// values are those of the soft engine. The sum of the terms is bit-identical to the picture's pixel.
/// @param x,y  [px] of the whole picture; 0,0 is the top left one
/// @throws Error usage: the pixel is not in the picture, impossible settings or camera; not_found, bad_file, failed
RL_API std::shared_ptr<const ExplainedPixel> explain(const PictureRequest& request, int x, int y, Context& context);
/// The same for a scene in memory, as render_picture() draws it; `request.input` is its name in the result.
RL_API std::shared_ptr<const ExplainedPixel> explain(const Scene& scene, const PictureRequest& request, int x, int y,
                                                     Context& context);

/// The pixel's color in a PNG file: 3 values, or 4 with alpha if the background is transparent.
RL_API std::vector<std::uint8_t> codes_of(const ExplainedPixel& pixel);
/// Linear RGB and alpha.
RL_API vec4 color_of(const ExplainedPixel& pixel);

/// Coordinates of a pixel: 0,0 is the top left one.
struct PixelPlace {
    int x = 0, y = 0;  ///< [px] from the left, from the top
};
/// Several pixels of one picture, which is loaded and prepared once. Results are in the order of `pixels`.
RL_API std::vector<std::shared_ptr<const ExplainedPixel>> explain(const PictureRequest& request,
                                                                  std::span<const PixelPlace> pixels, Context& context);

/// Readable text; lines end with line feeds. Numbers have enough digits to identify the float.
RL_API std::string to_text(const ExplainedPixel& pixel);

}  // namespace rakelight
