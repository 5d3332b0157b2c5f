// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blend_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engines/raster/shade/layer_order.h"
#include "engines/raster/visibility/coverage.h"
#include "engines/raster/visibility/visibility_methods.h"

namespace rakelight::raster {
namespace {

/// An edge of `a` has no corner of `b` on its inner side.
bool has_edge_between(const ScreenTriangle& a, const ScreenTriangle& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const std::int64_t dx = a.x(n) - a.x(k), dy = a.y(n) - a.y(k);
        bool is_outside = true;
        for (std::size_t i = 0; i < 3 && is_outside; ++i)
            is_outside = dx * (b.y(i) - a.y(k)) - dy * (b.x(i) - a.x(k)) <= 0;
        if (is_outside) return true;
    }
    return false;
}

}  // namespace

bool lie_apart(const ScreenTriangle& a, const ScreenTriangle& b) {
    return has_edge_between(a, b) || has_edge_between(b, a);
}

namespace {

constexpr std::size_t most_compared = 32;  ///< triangles of a group, each with all others

using AtCorners = std::array<float, 4>;  ///< of the area

/// Between what its depth keys are in the area, as functions that are linear over it.
struct KeyRange {
    AtCorners low, high;
    float place;  ///< in the order: of its middle
    std::uint32_t item;
};

/// The plane; where that is steep beside the triangle, what the keys are at most and at least. A pixel's key stays
/// within those of the corners, so it may leave the plane where rounding to 1/256 px moves an edge.
/// @param area  [px] from the corner of the tile
KeyRange range_of(const KeyPlane& plane, const Window& area, std::uint32_t item) {
    const float left = float(area.x) - 0.5f, right = left + float(area.width);
    const float top = float(area.y) - 0.5f, bottom = top + float(area.height);
    const float at[4][2] = {{left, top}, {right, top}, {left, bottom}, {right, bottom}};
    const float slack = (std::fabs(plane.depth_x) + std::fabs(plane.depth_y)) / 128;
    const float extent = plane.depth_high - plane.depth_low + slack;
    KeyRange range{{}, {}, 0, item};
    bool is_close = slack - slack == 0;  // finite
    for (std::size_t c = 0; c < 4; ++c) {
        const float key = unlimited_depth_at(plane, at[c][0], at[c][1]);
        range.low[c] = key - slack, range.high[c] = key + slack;
        is_close = is_close && key >= plane.depth_low - extent && key <= plane.depth_high + extent;
    }
    if (!is_close) {
        range.low.fill(plane.depth_low);
        range.high.fill(plane.depth_high);
    }
    range.place = (range.low[0] + range.high[3]) + (range.low[1] + range.high[2]);
    return range;
}

/// In all of the area, by more than what counts as equal.
bool is_farther(const AtCorners& high, const AtCorners& low) {
    for (std::size_t c = 0; c < 4; ++c)
        if (!(high[c] < low[c] * (1 - 2 * equal_depths))) return false;
    return true;
}

std::vector<KeyRange> sorted_ranges(const TileJob& job, std::size_t tile, const Window& area,
                                    std::span<const std::uint32_t> order) {
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    std::vector<KeyRange> ranges;
    ranges.reserve(order.size());
    for (const std::uint32_t item : order) {
        KeyPlane plane;
        set_plane(*job.binned.items[item], ox, oy, plane);
        ranges.push_back(range_of(plane, {area.x - ox, area.y - oy, area.width, area.height}, item));
    }
    std::stable_sort(ranges.begin(), ranges.end(),
                     [](const KeyRange& a, const KeyRange& b) { return a.place < b.place; });
    return ranges;
}

/// The least keys of what comes after each.
std::vector<AtCorners> least_of_rest(std::span<const KeyRange> ranges) {
    std::vector<AtCorners> rest(ranges.size());
    AtCorners least;
    least.fill(std::numeric_limits<float>::infinity());
    for (std::size_t i = ranges.size(); i-- > 0;) {
        rest[i] = least;
        for (std::size_t c = 0; c < 4; ++c) least[c] = std::min(least[c], ranges[i].low[c]);
    }
    return rest;
}

class Groups {
public:
    Groups(const TileJob& job, std::size_t tile, bool by_pixel)
        : items_(job.binned.items.data()), first_(job.binned.offsets[tile]), by_pixel_(by_pixel) {}

    /// Where all that came is farther than all that comes, a group ends.
    std::vector<GroupedTriangle> of(std::span<const KeyRange> ranges) const {
        const std::vector<AtCorners> rest = least_of_rest(ranges);
        std::vector<GroupedTriangle> grouped;
        grouped.reserve(ranges.size());
        AtCorners most;
        most.fill(-std::numeric_limits<float>::infinity());
        std::uint32_t number = 0;
        for (std::size_t i = 0, begin = 0; i < ranges.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) most[c] = std::max(most[c], ranges[i].high[c]);
            if (i + 1 < ranges.size() && !is_farther(most, rest[i])) continue;
            const std::span<const KeyRange> group = ranges.subspan(begin, i + 1 - begin);
            for (const KeyRange& r : group) grouped.push_back({r.item - first_, number, waits(r, group)});
            begin = i + 1;
            ++number;
        }
        return grouped;
    }

private:
    bool waits(const KeyRange& r, std::span<const KeyRange> group) const {
        if (group.size() == 1) return false;
        if (by_pixel_ || group.size() > most_compared) return true;
        return std::any_of(group.begin(), group.end(), [&](const KeyRange& other) {
            return other.item != r.item && !lie_apart(*items_[r.item], *items_[other.item]);
        });
    }

    const ScreenTriangle* const* const items_;
    const std::uint32_t first_;
    const bool by_pixel_;
};

}  // namespace

std::vector<GroupedTriangle> blend_groups(const TileJob& job, std::size_t tile, const Window& area,
                                          std::span<const std::uint32_t> order, bool by_pixel) {
    if (has_depth(job.front.settings.visibility))
        return Groups(job, tile, by_pixel).of(sorted_ranges(job, tile, area, order));
    std::vector<GroupedTriangle> grouped;
    for (const std::uint32_t item : order) grouped.push_back({item - job.binned.offsets[tile], 0, false});
    return grouped;
}

}  // namespace rakelight::raster
