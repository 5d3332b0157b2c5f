// SPDX-License-Identifier: Apache-2.0
// Explains the color of a pixel: all intermediate values of the soft engine.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// One pixel with all its intermediate values. to_text() and to_json() show them.
struct ExplainedPixel;

/// Explains one pixel of the picture that `request` describes. Window, channels, output and engine of the request are
/// ignored. The values are those of the soft engine. The sum of the terms is bit-identical to the picture's pixel.
/// @param x,y  [px] in the whole picture; 0,0 is the top left pixel
/// @throws Error usage: the pixel is not in the picture, impossible settings or camera; not_found, bad_file, failed
RL_API std::shared_ptr<const ExplainedPixel> explain(const PictureRequest& request, int x, int y, Context& context);
/// The same for a scene in memory, as render_picture() draws it. The result calls it `request.input`.
RL_API std::shared_ptr<const ExplainedPixel> explain(const Scene& scene, const PictureRequest& request, int x, int y,
                                                     Context& context);

/// The color of the pixel in a PNG file: RGB, or RGBA if the background is transparent.
RL_API std::vector<std::uint8_t> codes_of(const ExplainedPixel& pixel);
/// Linear RGB and alpha.
RL_API vec4 color_of(const ExplainedPixel& pixel);

/// Coordinates of a pixel: 0,0 is the top left pixel.
struct PixelPlace {
    int x = 0, y = 0;  ///< [px] from the left, from the top
};
/// Explains several pixels of one picture. The scene is loaded and prepared once. Results are in the order of `pixels`.
RL_API std::vector<std::shared_ptr<const ExplainedPixel>> explain(const PictureRequest& request,
                                                                  std::span<const PixelPlace> pixels, Context& context);

/// Readable text. Lines end with line feeds. Each number has enough digits to identify the float.
RL_API std::string to_text(const ExplainedPixel& pixel);

/// A row of `explain --json`.
struct ExplainRow : ReportRow {
    std::string file{};  ///< as it was named
    int x = 0, y = 0;    ///< [px] of the pixel
    std::shared_ptr<const ExplainedPixel> pixel{};
};

/// {"schema": "rakelight.explain/1", "rows": [...]}; docs/explain.md describes the contents.
RL_API std::string to_json(std::span<const ExplainRow> rows);

}  // namespace rakelight
