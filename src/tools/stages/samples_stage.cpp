// SPDX-License-Identifier: Apache-2.0
// Pictures of several samples per pixel: what they cover, how often their pixels are shaded, and their mean.
#include <algorithm>

#include "base/format_text.h"
#include "engines/raster/inspect/inspect_samples.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

constexpr int enlarged_px = 16;  ///< side of the part that is shown enlarged; divides a tile's
static_assert(raster::sample_square % enlarged_px == 0);
constexpr int cell_px = 48;  ///< one of its pixels: 3 a step of sample_positions()

/// Where samples differ most, so that there is something to see.
Window liveliest_part(const Sources& of) {
    const int width = of.engine.settings().width, height = of.engine.settings().height;
    Window best{0, 0, std::min(enlarged_px, width), std::min(enlarged_px, height)};
    double most = -1;
    for (int top = 0; top < height; top += enlarged_px)
        for (int left = 0; left < width; left += enlarged_px) {
            const Window part{left, top, std::min(enlarged_px, width - left), std::min(enlarged_px, height - top)};
            double sum = 0;
            for (int y = top; y < top + part.height; ++y)
                for (int x = left; x < left + part.width; ++x)
                    sum += double(of.pixels.sample_spread[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
            if (sum > most) most = sum, best = part;
        }
    return best;
}

void square(Canvas& canvas, int x, int y, int side, Code color) {
    for (int dy = 0; dy < side; ++dy)
        for (int dx = 0; dx < side; ++dx) canvas.set(x + dx, y + dy, color);
}

/// Each pixel in the color of the picture, a dot with a dark rim for each of its samples.
Picture enlarged(const Sources& of) {
    const raster::SampleColors part = inspect_samples(of.engine, of.drawn, liveliest_part(of));
    const int samples = of.engine.settings().samples, width = of.engine.settings().width;
    Canvas canvas(part.window.width * cell_px, part.window.height * cell_px, backdrop);
    std::size_t next = 0;
    for (int y = 0; y < part.window.height; ++y)
        for (int x = 0; x < part.window.width; ++x) {
            const auto p = std::size_t(y + part.window.y) * std::size_t(width) + std::size_t(x + part.window.x);
            square(canvas, x * cell_px, y * cell_px, cell_px, displayed_code(of, of.pixels.color[p]));
            for (const shading::SamplePosition at : shading::sample_positions(samples)) {
                const int middle_x = x * cell_px + cell_px / 2 + 3 * at.x,
                          middle_y = y * cell_px + cell_px / 2 + 3 * at.y;
                square(canvas, middle_x - 3, middle_y - 3, 7, backdrop);
                square(canvas, middle_x - 2, middle_y - 2, 5, displayed_code(of, part.color[next++]));
            }
        }
    const std::string corner = format_text("{},{}", part.window.x, part.window.y);
    return {"samples-enlarged",
            format_text("The part whose samples differ most, from pixel {} on, {} times as large: each pixel has the "
                        "mean of its samples, each dot the color of one sample in its place.",
                        corner, cell_px),
            std::move(canvas)};
}

Stage make_samples_stage(const Sources& of) {
    const int samples = of.engine.settings().samples;
    const raster::PixelStageData& d = of.pixels;
    Stage s{.id = "samples", .title = "Several samples per pixel, and their mean"};
    s.text = format_text(
        "With {} samples, coverage and depth are tested at as many places in every pixel, and each visible triangle is "
        "shaded once, at the centroid of its visible samples. The pixel is the mean of its samples in linear light. "
        "The stages before use the pixels' centers, as the data channels do.",
        samples);
    std::vector<std::uint64_t> covered(std::size_t(samples) + 1, 0), shaded(std::size_t(samples) + 1, 0);
    std::uint64_t sum = 0, all = 0;
    for (std::size_t p = 0; p < d.color.size(); ++p) {
        ++covered[d.samples_covered[p]], ++shaded[d.visible_triangles[p]];
        sum += d.samples_covered[p], all += d.visible_triangles[p];
    }
    const std::uint64_t pixels = d.color.size() - covered[0];
    s.numbers = {{"samples per pixel", samples},
                 {"pixels covered", pixels},
                 {"samples covered", sum},
                 {"opaque triangles shaded, over all pixels", all},
                 {"times a covered pixel is shaded, mean", pixels > 0 ? double(all) / double(pixels) : 0.0}};
    s.columns = {"number", "pixels with this number of covered samples",
                 "pixels with this number of shaded opaque triangles"};
    for (std::size_t n = 0; n < covered.size(); ++n) s.rows.push_back({n, covered[n], shaded[n]});
    s.rows_note = "Opaque surfaces; blended ones are laid sample by sample over what is there";
    s.pictures.push_back({"samples-covered", "Samples that something opaque covers: black none, white all.",
                          paint(of, [&](std::size_t p) { return gray(double(d.samples_covered[p]) / samples); })});
    s.pictures.push_back(
        {"samples-triangles",
         format_text(
             "How many opaque triangles the pixel is shaded for: blue 1, over green and yellow to white {} and more.",
             std::min(samples, 4)),
         paint(of, [&](std::size_t p) {
             return d.visible_triangles[p] == 0 ? backdrop
                                                : heat(double(d.visible_triangles[p]) / std::min(samples, 4));
         })});
    s.pictures.push_back({"samples-difference",
                          "The greatest difference between samples of the pixel, as light: what the mean makes smooth.",
                          paint(of, [&](std::size_t p) {
                              return exposed(of, vec3{1, 1, 1} * d.sample_spread[p]);
                          })});
    s.pictures.push_back(enlarged(of));
    return s;
}

bool has_samples(const Sources& of) { return of.engine.settings().samples > 1; }

}  // namespace

constinit const StageKind samples_stage{make_samples_stage, has_samples};

}  // namespace rakelight::stages
