// SPDX-License-Identifier: Apache-2.0
#include "bake/low/band_cover.h"

namespace rakelight::bake {
namespace {

/// [px] more than rounding can move an edge of a triangle.
constexpr double slack = 1e-5;

}  // namespace

/// The samples in a row of samples that a triangle may cover.
struct BandCover::Row {
    const MapGrid& grid;
    const dvec2 (&at)[3];
    double turn;
    int number;  ///< within the band
    Range columns;
    OwnerBand& band;

    int texel_row() const { return number / grid.side; }
    std::size_t first_texel() const { return std::size_t(texel_row()) * std::size_t(grid.width); }
    Range texels() const { return {columns.low / grid.side, (columns.high + grid.side - 1) / grid.side}; }
    std::size_t first_place() const { return std::size_t(number) * std::size_t(grid.width * grid.side); }
    std::uint32_t& owner(int column) const {
        const std::size_t texel = first_texel() + std::size_t(column / grid.side);
        return band.owner[texel * grid.samples() + std::size_t(sample(column))];
    }
    bool covers(int column) const {
        ++band.tests;
        return is_covered(at, turn, grid.sample_at(column / grid.side, band.first_row + texel_row(), sample(column)));
    }
    bool overlaps(int column) const { return owner(column) != no_index && covers(column); }

private:
    int sample(int column) const { return number % grid.side * grid.side + column % grid.side; }
};

BandCover::BandCover(const MapGrid& grid, OwnerBand& band, BandOverlaps* overlaps)
    : grid_(grid),
      band_(band),
      overlaps_(overlaps),
      free_(std::size_t(band.rows) * std::size_t(grid.width) * grid.samples()) {
    band.owner.assign(std::size_t(band.rows) * std::size_t(grid.width) * grid.samples(), no_index);
}

/// Whether a triangle can change nothing any more.
bool BandCover::is_decided(std::uint32_t chart) const {
    return free_.empty() && (!overlaps_ || (overlaps_->texels.empty() && overlaps_->charts[chart]));
}

/// The same within a row.
bool BandCover::is_decided(const Row& row, std::uint32_t chart) {
    const auto is_closed = [](OpenPlaces& places, std::size_t begin, Range range) {
        return places.from(begin + std::size_t(range.low)) >= begin + std::size_t(range.high);
    };
    return is_closed(free_, row.first_place(), row.columns) &&
           (!overlaps_ || (overlaps_->charts[chart] && is_closed(overlaps_->texels, row.first_texel(), row.texels())));
}

void BandCover::add(const MapTriangle& triangle, std::uint32_t number, std::uint32_t chart) {
    const double area = signed_area(triangle.at);
    if (area == 0 || is_decided(chart)) return;
    const int first = band_.first_row * grid_.side;
    const Range rows = places_of(height_of(triangle), grid_.side, first, first + band_.rows * grid_.side),
                most = places_of(width_of(triangle), grid_.side, 0, grid_.width * grid_.side);
    for (int y = rows.low; y < rows.high; ++y) {
        Row row{grid_, triangle.at, area > 0 ? 1.0 : -1.0, y - first, most, band_};
        if (is_decided(row, chart)) continue;
        const double middle = (y + 0.5) / grid_.side;
        const Extent extent = extent_between(triangle.at, middle - slack, middle + slack);
        row.columns = places_of(extent, grid_.side, 0, grid_.width * grid_.side);
        if (overlaps_) find_overlaps(row, chart);
        take(row, number);
    }
}

/// Before take(): earlier owners only.
void BandCover::find_overlaps(const Row& row, std::uint32_t chart) {
    const std::size_t begin = row.first_texel();
    const Range range = row.texels();
    OpenPlaces& texels = overlaps_->texels;
    bool is_hidden = overlaps_->charts[chart];
    for (std::size_t i = texels.from(begin + std::size_t(range.low)); i < begin + std::size_t(range.high);
         i = texels.from(i + 1)) {
        const int column = int(i - begin) * grid_.side;
        for (int k = 0; k < grid_.side; ++k)
            if (row.overlaps(column + k)) {
                is_hidden = true;
                texels.close(i);
                break;
            }
    }
    for (int column = row.columns.low; column < row.columns.high && !is_hidden; ++column)
        is_hidden = row.overlaps(column);
    if (is_hidden) overlaps_->charts[chart] = true;
}

void BandCover::take(const Row& row, std::uint32_t number) {
    const std::size_t begin = row.first_place();
    for (std::size_t i = free_.from(begin + std::size_t(row.columns.low)); i < begin + std::size_t(row.columns.high);
         i = free_.from(i + 1)) {
        const int column = int(i - begin);
        if (!row.covers(column)) continue;
        row.owner(column) = number;
        free_.close(i);
    }
}

BandApproach::BandApproach(const MapGrid& grid, OwnerBand& band)
    : grid_(grid),
      band_(band),
      open_(std::size_t(band.rows) * std::size_t(grid.width)),
      distance_(std::size_t(band.rows) * std::size_t(grid.width), 1.0),
      near_(distance_.size(), 0) {
    band.nearest.assign(distance_.size(), no_index);
    for (std::size_t i = 0; i < distance_.size(); ++i) {
        const auto begin = band.owner.begin() + std::ptrdiff_t(i * grid.samples());
        if (std::any_of(begin, begin + std::ptrdiff_t(grid.samples()), [](std::uint32_t o) { return o != no_index; }))
            open_.close(i);
    }
}

void BandApproach::add(const MapTriangle& triangle, std::uint32_t number) {
    if (open_.empty()) return;
    const Range rows = places_of(height_of(triangle), 1, band_.first_row, band_.first_row + band_.rows);
    for (int y = rows.low; y < rows.high; ++y) {
        const Range columns = places_of(extent_between(triangle.at, y - 0.5, y + 1.5), 1, 0, grid_.width);
        const std::size_t begin = std::size_t(y - band_.first_row) * std::size_t(grid_.width);
        for (std::size_t i = open_.from(begin + std::size_t(columns.low)); i < begin + std::size_t(columns.high);
             i = open_.from(i + 1)) {
            ++band_.tests;
            const dvec2 middle{int(i - begin) + 0.5, y + 0.5};
            const dvec2 off = blend(triangle.at, weights_at(triangle.at, middle)) - middle;
            const double distance = dot(off, off);
            if (distance < distance_[i]) distance_[i] = distance, band_.nearest[i] = number;
            if (distance < 1 && ++near_[i] == max_near) open_.close(i);
        }
    }
}

}  // namespace rakelight::bake
