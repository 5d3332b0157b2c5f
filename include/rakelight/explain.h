// SPDX-License-Identifier: Apache-2.0
// Why a pixel has its color: everything that the soft engine computes on the way to it.
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

/// One pixel with all its numbers; read it with to_text() and to_json().
struct ExplainedPixel;

/// Follows one pixel of the picture that `request` describes: its window, channels, output and engine do not count. The
/// numbers are those of the soft engine: the sum of the terms is the picture's pixel to the bit.
/// @param x,y  [px] of the whole picture; 0,0 is the top left one
/// @throws Error usage: the pixel is not in the picture, impossible settings or camera; not_found, bad_file, failed
RL_API std::shared_ptr<const ExplainedPixel> explain(const PictureRequest& request, int x, int y, Context& context);
/// The same of a scene that is there, as render_picture() draws it; `request.input` is its name in what is returned.
RL_API std::shared_ptr<const ExplainedPixel> explain(const Scene& scene, const PictureRequest& request, int x, int y,
                                                     Context& context);

/// The pixel's color as a PNG file holds it: 3 values, or 4 with alpha where the background is transparent.
RL_API std::vector<std::uint8_t> codes_of(const ExplainedPixel& pixel);
/// Linear RGB and alpha.
RL_API vec4 color_of(const ExplainedPixel& pixel);

/// A pixel of a picture: 0,0 is the top left one.
struct PixelPlace {
    int x = 0, y = 0;  ///< [px] from the left, from the top
};
/// Several pixels of one picture, which is loaded and prepared once. In their order.
RL_API std::vector<std::shared_ptr<const ExplainedPixel>> explain(const PictureRequest& request,
                                                                  std::span<const PixelPlace> pixels, Context& context);

/// For people: lines that end with line feeds. Numbers are written with as many digits as tell the float apart.
RL_API std::string to_text(const ExplainedPixel& pixel);

}  // namespace rakelight
