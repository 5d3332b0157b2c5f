// SPDX-License-Identifier: Apache-2.0
// The triangle of LOW for each sample of the map, computed in bands of rows.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "bake/low/band_cover.h"

namespace rakelight::bake {

/// Where triangles lie on others.
struct Overlaps {
    std::uint64_t texels = 0;
    std::uint32_t charts = 0;  ///< charts that are hidden by another one, or by themselves, somewhere
    std::uint64_t tests = 0;   ///< tests of a sample against a triangle
};

/// Many triangles may cover the same samples: about a test for each sample and for each triangle's row, not for each
/// sample of a triangle.
class TexelOwners {
public:
    /// Triangles of charts that are not mirrored have priority.
    /// @param samples  1, 4 or 16 per texel
    TexelOwners(const LowSurface& low, const MapCharts& charts, int width, int height, int samples, Context& context);

    static constexpr int band_rows = 16;
    int bands() const { return (grid_.height + band_rows - 1) / band_rows; }
    OwnerBand band(int number, const Context& context) const;
    /// Of all bands.
    Overlaps overlaps(Context& context) const;

    /// [px] position of a sample.
    dvec2 sample_at(int x, int y, int sample) const { return grid_.sample_at(x, y, sample); }
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
    void for_each_entry(bool mirrored, const Context& context, const Visit& visit) const;
    std::span<const Entry> entries(int band) const {
        const std::size_t first = first_[std::size_t(band)];
        return std::span(entries_).subspan(first, first_[std::size_t(band) + 1] - first);
    }
    int rows_of(int band) const { return std::min(band_rows, grid_.height - band * band_rows); }
    OwnerBand cover(int number, BandOverlaps* overlaps, const Context& context) const;

    const LowSurface& low_;
    const MapCharts& charts_;
    MapGrid grid_;
    MemoryCharge charge_;
    std::vector<std::size_t> first_;  ///< [bands + 1] into entries_
    std::vector<Entry> entries_;
};

}  // namespace rakelight::bake
