// SPDX-License-Identifier: Apache-2.0
// Decides in a band of rows of the map which triangle owns a sample. Where many triangles lie on each other, the work
// does not grow with the samples that they cover: a sample that is decided is skipped.
#pragma once
#include <cstdint>
#include <vector>

#include "bake/low/map_triangle.h"
#include "base/open_places.h"

namespace rakelight::bake {

/// A band of rows. A sample belongs to the first triangle that covers it. A sample on an edge belongs to exactly one of
/// its two triangles.
struct OwnerBand {
    int first_row = 0, rows = 0;
    std::vector<std::uint32_t> owner{};  ///< [rows * width * samples] triangle, or no_index
    /// [rows * width] if no sample is covered: the triangle within a texel's distance; or no_index. Where more than
    /// BandApproach::max_near triangles are so close, the nearest of the first ones.
    std::vector<std::uint32_t> nearest{};
    std::uint64_t tests = 0;  ///< of a sample or texel against a triangle
};

/// The samples of a map: `side` along a texel's side, `width` texels in a row.
struct MapGrid {
    int width, height, side;
    std::size_t samples() const { return std::size_t(side) * std::size_t(side); }
    /// [px] position of a sample.
    dvec2 sample_at(int x, int y, int sample) const {
        return {x + (sample % side + 0.5) / side, y + (sample / side + 0.5) / side};
    }
};

/// Where triangles of a band lie on earlier ones.
struct BandOverlaps {
    OpenPlaces texels;         ///< closed: triangles overlap there
    std::vector<bool> charts;  ///< hidden by an earlier triangle somewhere in the band
};

/// Gives the samples of a band to triangles, the first one first.
class BandCover {
public:
    /// @param overlaps  also filled; null: not wanted
    BandCover(const MapGrid& grid, OwnerBand& band, BandOverlaps* overlaps);
    void add(const MapTriangle& triangle, std::uint32_t number, std::uint32_t chart);

private:
    struct Row;
    bool is_decided(std::uint32_t chart) const;
    bool is_decided(const Row& row, std::uint32_t chart);
    void find_overlaps(const Row& row, std::uint32_t chart);
    void take(const Row& row, std::uint32_t number);

    const MapGrid& grid_;
    OwnerBand& band_;
    BandOverlaps* overlaps_;
    OpenPlaces free_;  ///< [rows of samples * columns of samples] without an owner
};

/// Finds the nearest triangle of texels without an owner.
class BandApproach {
public:
    static constexpr int max_near = 1024;
    /// @param band  with the owners of all its samples
    BandApproach(const MapGrid& grid, OwnerBand& band);
    void add(const MapTriangle& triangle, std::uint32_t number);

private:
    const MapGrid& grid_;
    OwnerBand& band_;
    OpenPlaces open_;  ///< [rows * width]
    std::vector<double> distance_;
    std::vector<std::uint16_t> near_;  ///< triangles within a texel's distance so far
};

}  // namespace rakelight::bake
