// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/nearest_visible.h"

#include <algorithm>
#include <tuple>

#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/multisample.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t most_tries = 64;

/// [width * height] 1 where a triangle that is not culled covers a sample.
std::vector<std::uint8_t> covered_pixels(const OpenScene& of, Context& context) {
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    const OpenGeometry drawn(of, {}, false, quiet);
    const auto width = std::size_t(of.settings().width);
    std::vector<std::uint8_t> covered(width * std::size_t(of.settings().height), 0);
    context.parallel_for(drawn.grid.count(), [&](std::size_t tile) {
        const int ox = drawn.grid.origin_x(tile), oy = drawn.grid.origin_y(tile);
        for (std::uint32_t i = drawn.binned.offsets[tile]; i < drawn.binned.offsets[tile + 1]; ++i)
            for (const SamplePosition at : sample_positions(of.settings().samples))
                cover(seen_from(at, *drawn.binned.items[i]), drawn.grid.pixels(tile), ox, oy,
                      [&](int x, int y, float) { covered[std::size_t(y + oy) * width + std::size_t(x + ox)] = 1; });
    });
    return covered;
}

struct Place {
    std::int64_t distance;  ///< squared
    int y, x;
    bool operator<(const Place& o) const { return std::tie(distance, y, x) < std::tie(o.distance, o.y, o.x); }
};

}  // namespace

std::optional<PixelExplanation> nearest_visible(const Inspection& inspection, int x, int y, Context& context) {
    const OpenScene& of = inspection.opened();
    const std::vector<std::uint8_t> covered = covered_pixels(of, context);
    std::vector<Place> places;
    const int width = of.settings().width;
    for (std::size_t p = 0; p < covered.size(); ++p) {
        if (!covered[p]) continue;
        const int px = int(p % std::size_t(width)), py = int(p / std::size_t(width));
        const std::int64_t dx = px - x, dy = py - y;
        places.push_back({dx * dx + dy * dy, py, px});
    }
    const std::size_t tries = std::min(most_tries, places.size());
    std::partial_sort(places.begin(), places.begin() + std::ptrdiff_t(tries), places.end());
    for (std::size_t i = 0; i < tries; ++i) {
        context.throw_if_cancelled();
        PixelExplanation found = explain_pixel(of, places[i].x, places[i].y, context);
        if (!found.layers.empty()) return found;
    }
    return {};
}

}  // namespace rakelight::raster
