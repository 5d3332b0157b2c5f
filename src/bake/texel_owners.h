// SPDX-License-Identifier: Apache-2.0
// The triangle of LOW for each sample of the map, computed in bands of rows.
#pragma once
#include <cstdint>
#include <vector>

#include "bake/map_charts.h"

namespace rakelight::bake {

/// A band of rows. A sample belongs to the first triangle that covers it. A sample on an edge belongs to exactly one of
/// its two triangles.
struct OwnerBand {
    int first_row = 0, rows = 0;
    std::vector<std::uint32_t> owner{};  ///< [rows * width * samples] triangle, or no_index
    std::vector<std::uint32_t>
        nearest{};  ///< [rows * width] if no sample is covered: the triangle within a texel's distance; or no_index
    std::uint64_t overlapping_texels = 0;
    std::vector<std::uint32_t>
        overlapping_charts{};  ///< charts that are hidden by another one somewhere; sorted, unique
};

class TexelOwners {
public:
    /// Triangles of charts that are not mirrored have priority.
    /// @param samples  1, 4 or 16 per texel
    TexelOwners(const LowSurface& low, const MapCharts& charts, int width, int height, int samples, Context& context);

    static constexpr int band_rows = 16;
    int bands() const { return (height_ + band_rows - 1) / band_rows; }
    OwnerBand band(int number) const;

    /// [px] position of a sample.
    dvec2 sample_at(int x, int y, int sample) const;
    /// The position of the triangle nearest to a point of the map.
    CornerWeights weights(std::uint32_t triangle, dvec2 at) const;

private:
    /// A triangle in a band, shifted left or up by a whole map.
    struct Entry {
        std::uint32_t triangle;
        bool left, up;
    };
    MapTriangle moved(const Entry& entry) const;
    template <class Visit>
    void for_each_entry(bool mirrored, const Visit& visit) const;
    void cover(const Entry& entry, OwnerBand& band, std::vector<std::uint8_t>& overlaps) const;
    void approach(const Entry& entry, OwnerBand& band, std::vector<double>& distance) const;

    const LowSurface& low_;
    const MapCharts& charts_;
    int width_, height_, side_;  ///< side_: samples along a texel's side
    MemoryCharge charge_;
    std::vector<std::size_t> first_;  ///< [bands + 1] into entries_
    std::vector<Entry> entries_;
};

}  // namespace rakelight::bake
