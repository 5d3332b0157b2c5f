// SPDX-License-Identifier: Apache-2.0
#include "bake/padding.h"

#include <algorithm>

#include <rakelight/scene/scene.h>

namespace rakelight::bake {

std::vector<std::uint32_t> nearest_covered(std::span<const std::uint8_t> covered, int width, int height, int padding,
                                           Context& context) {
    const auto at = [width](int x, int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
    std::vector<std::int32_t> row(covered.size(), -1);  // of the nearest covered texel of its column
    context.parallel_for(std::size_t(width), [&](std::size_t column) {
        const int x = int(column);
        for (int y = 0, last = -1; y < height; ++y) {
            if (covered[at(x, y)]) last = y;
            if (last >= 0 && y - last <= padding) row[at(x, y)] = last;
        }
        for (int y = height - 1, last = -1; y >= 0; --y) {
            if (covered[at(x, y)]) last = y;
            std::int32_t& known = row[at(x, y)];
            if (last >= 0 && last - y <= padding && (known < 0 || last - y < y - known)) known = last;
        }
    });
    std::vector<std::uint32_t> nearest(covered.size(), no_index);
    context.parallel_for(std::size_t(height), [&](std::size_t line) {
        const int y = int(line);
        for (int x = 0; x < width; ++x) {
            std::int64_t least = std::int64_t(padding) * padding + 1;
            for (int c = std::max(0, x - padding); c < std::min(width, x + padding + 1); ++c) {
                const std::int64_t r = row[at(c, y)];
                const std::int64_t square = std::int64_t(c - x) * (c - x) + (r - y) * (r - y);
                if (r < 0 || square >= least) continue;
                least = square;
                nearest[at(x, y)] = std::uint32_t(at(c, int(r)));
            }
        }
    });
    return nearest;
}

}  // namespace rakelight::bake
