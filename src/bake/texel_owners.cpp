// SPDX-License-Identifier: Apache-2.0
#include "bake/texel_owners.h"

#include <algorithm>
#include <cmath>

#include "base/cancel_check.h"

namespace rakelight::bake {
namespace {

double cross2(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

bool is_before(dvec2 a, dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Twice the signed area of a, b, p; exactly antisymmetric in a and b.
double side_of(dvec2 a, dvec2 b, dvec2 p) { return is_before(a, b) ? cross2(b - a, p - a) : -cross2(a - b, p - b); }

/// @param turn  +1 or -1: the sign of the triangle's area
bool is_covered(const dvec2 (&at)[3], double turn, dvec2 p) {
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec2 a = at[k], b = at[(k + 1) % 3];
        const double side = turn * side_of(a, b, p);
        if (side < 0 || (side == 0 && is_before(a, b) != (turn > 0))) return false;
    }
    return true;
}

/// Parameter of the point on a-b nearest to p.
double nearest_share(dvec2 a, dvec2 b, dvec2 p) {
    const dvec2 way = b - a;
    const double square = dot(way, way);
    return square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
}

/// Weights of the point on the triangle's border nearest to p.
CornerWeights nearest_weights(const dvec2 (&at)[3], dvec2 p) {
    CornerWeights best{1, 0, 0};
    double least = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double share = nearest_share(at[k], at[next], p);
        const dvec2 off = at[k] + (at[next] - at[k]) * share - p;
        if (dot(off, off) >= least) continue;
        least = dot(off, off);
        best = {0, 0, 0};
        best[k] = 1 - share, best[next] = share;
    }
    return best;
}

dvec2 blend(const dvec2 (&at)[3], const CornerWeights& w) { return at[0] * w[0] + at[1] * w[1] + at[2] * w[2]; }

/// Weights at p, or at the nearest point of the triangle.
CornerWeights weights_at(const dvec2 (&at)[3], dvec2 p) {
    const double area = cross2(at[1] - at[0], at[2] - at[0]);
    if (area == 0) return nearest_weights(at, p);
    const CornerWeights w{cross2(at[1] - p, at[2] - p) / area, cross2(at[2] - p, at[0] - p) / area,
                          cross2(at[0] - p, at[1] - p) / area};
    return w[0] >= 0 && w[1] >= 0 && w[2] >= 0 ? w : nearest_weights(at, p);
}

/// Integers from low to high - 1.
struct Range {
    int low, high;
};

/// Texels that a triangle may touch, with a border of one texel.
Range texels(const MapTriangle& t, double dvec2::*axis, int low, int high) {
    const auto [least, most] = std::minmax({t.at[0].*axis, t.at[1].*axis, t.at[2].*axis});
    return {int(std::clamp(std::floor(least) - 1, double(low), double(high))),
            int(std::clamp(std::floor(most) + 2, double(low), double(high)))};
}

}  // namespace

template <class Visit>
void TexelOwners::for_each_entry(bool mirrored, const Visit& visit) const {
    for (std::uint32_t t = 0; t < low_.triangle_count(); ++t) {
        if ((charts_.is_mirrored[charts_.of_triangle[t]] != 0) != mirrored) continue;
        for (const bool left : {false, true})
            for (const bool up : {false, true}) {
                const Entry entry{t, left, up};
                const MapTriangle at = moved(entry);
                const Range columns = texels(at, &dvec2::x, 0, width_), rows = texels(at, &dvec2::y, 0, height_);
                if (columns.low >= columns.high) continue;
                for (int row = rows.low; row < rows.high; row = (row / band_rows + 1) * band_rows)
                    visit(entry, std::size_t(row / band_rows));
            }
    }
}

TexelOwners::TexelOwners(const LowSurface& low, const MapCharts& charts, int width, int height, int samples,
                         Context& context)
    : low_(low),
      charts_(charts),
      width_(width),
      height_(height),
      side_(samples == 1   ? 1
            : samples == 4 ? 2
                           : 4),
      charge_(context.memory()),
      first_(std::size_t(bands()) + 1, 0) {
    for (const bool mirrored : {false, true})
        for_each_entry(mirrored, [&](const Entry&, std::size_t band) { ++first_[band + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    charge_.grow(first_.back() * sizeof(Entry), "triangles on the map");
    entries_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    CancelCheck check(context);
    for (const bool mirrored : {false, true})
        for_each_entry(mirrored, [&](const Entry& entry, std::size_t band) {
            entries_[next[band]++] = entry;
            check();
        });
}

MapTriangle TexelOwners::moved(const Entry& entry) const {
    MapTriangle t = on_map(low_, entry.triangle, width_, height_);
    for (dvec2& at : t.at) at = at - dvec2{entry.left ? double(width_) : 0.0, entry.up ? double(height_) : 0.0};
    return t;
}

dvec2 TexelOwners::sample_at(int x, int y, int sample) const {
    return {x + (sample % side_ + 0.5) / side_, y + (sample / side_ + 0.5) / side_};
}

CornerWeights TexelOwners::weights(std::uint32_t triangle, dvec2 at) const {
    CornerWeights best{1, 0, 0};
    double least = 1e300;
    for (const bool left : {false, true})
        for (const bool up : {false, true}) {  // the shifted copy
            const MapTriangle t = moved({triangle, left, up});
            const CornerWeights w = weights_at(t.at, at);
            const dvec2 off = blend(t.at, w) - at;
            if (dot(off, off) < least) least = dot(off, off), best = w;
        }
    return best;
}

void TexelOwners::cover(const Entry& entry, OwnerBand& band, std::vector<std::uint8_t>& overlaps) const {
    const MapTriangle t = moved(entry);
    const double area = cross2(t.at[1] - t.at[0], t.at[2] - t.at[0]);
    if (area == 0) return;
    const Range columns = texels(t, &dvec2::x, 0, width_),
                rows = texels(t, &dvec2::y, band.first_row, band.first_row + band.rows);
    const int samples = side_ * side_;
    bool is_second = false;
    for (int y = rows.low; y < rows.high; ++y)
        for (int x = columns.low; x < columns.high; ++x) {
            const std::size_t texel = std::size_t(y - band.first_row) * std::size_t(width_) + std::size_t(x);
            for (int s = 0; s < samples; ++s) {
                if (!is_covered(t.at, area > 0 ? 1 : -1, sample_at(x, y, s))) continue;
                std::uint32_t& owner = band.owner[texel * std::size_t(samples) + std::size_t(s)];
                if (owner == no_index)
                    owner = entry.triangle;
                else
                    overlaps[texel] = 1, is_second = true;
            }
        }
    if (is_second) band.overlapping_charts.push_back(charts_.of_triangle[entry.triangle]);
}

void TexelOwners::approach(const Entry& entry, OwnerBand& band, std::vector<double>& distance) const {
    const MapTriangle t = moved(entry);
    const Range columns = texels(t, &dvec2::x, 0, width_),
                rows = texels(t, &dvec2::y, band.first_row, band.first_row + band.rows);
    const std::size_t samples = std::size_t(side_) * std::size_t(side_);
    for (int y = rows.low; y < rows.high; ++y)
        for (int x = columns.low; x < columns.high; ++x) {
            const std::size_t texel = std::size_t(y - band.first_row) * std::size_t(width_) + std::size_t(x);
            const auto begin = band.owner.begin() + std::ptrdiff_t(texel * samples);
            if (std::any_of(begin, begin + std::ptrdiff_t(samples), [](std::uint32_t o) { return o != no_index; }))
                continue;
            const dvec2 middle{x + 0.5, y + 0.5}, off = blend(t.at, weights_at(t.at, middle)) - middle;
            if (dot(off, off) >= distance[texel]) continue;
            distance[texel] = dot(off, off);
            band.nearest[texel] = entry.triangle;
        }
}

OwnerBand TexelOwners::band(int number) const {
    OwnerBand band{.first_row = number * band_rows, .rows = std::min(band_rows, height_ - number * band_rows)};
    const std::size_t texels = std::size_t(band.rows) * std::size_t(width_);
    band.owner.assign(texels * std::size_t(side_) * std::size_t(side_), no_index);
    band.nearest.assign(texels, no_index);
    std::vector<std::uint8_t> overlaps(texels, 0);
    std::vector<double> distance(texels, 1.0);
    const std::size_t first = first_[std::size_t(number)], last = first_[std::size_t(number) + 1];
    for (std::size_t i = first; i < last; ++i) cover(entries_[i], band, overlaps);
    for (std::size_t i = first; i < last; ++i) approach(entries_[i], band, distance);
    for (const std::uint8_t o : overlaps) band.overlapping_texels += o;
    std::ranges::sort(band.overlapping_charts);
    const auto [end, last_chart] = std::ranges::unique(band.overlapping_charts);
    band.overlapping_charts.erase(end, last_chart);
    return band;
}

}  // namespace rakelight::bake
