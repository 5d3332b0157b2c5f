// SPDX-License-Identifier: Apache-2.0
#include "bake/low/texel_owners.h"

#include <algorithm>
#include <mutex>

#include "base/cancel_check.h"

namespace rakelight::bake {

template <class Visit>
void TexelOwners::for_each_entry(bool mirrored, const Context& context, const Visit& visit) const {
    CancelCheck check(context);
    for (std::uint32_t t = 0; t < low_.triangle_count(); ++t) {
        if ((charts_.is_mirrored[charts_.of_triangle[t]] != 0) != mirrored) continue;
        for (const bool left : {false, true})
            for (const bool up : {false, true}) {
                const Entry entry{t, left, up};
                const MapTriangle at = moved(entry);
                const Range columns = places_of(width_of(at), 1, 0, grid_.width),
                            rows = places_of(height_of(at), 1, 0, grid_.height);
                if (columns.low >= columns.high) continue;
                for (int row = rows.low; row < rows.high; row = (row / band_rows + 1) * band_rows)
                    visit(entry, std::size_t(row / band_rows)), check();
            }
    }
}

TexelOwners::TexelOwners(const LowSurface& low, const MapCharts& charts, int width, int height, int samples,
                         Context& context)
    : low_(low),
      charts_(charts),
      grid_{width, height,
            samples == 1   ? 1
            : samples == 4 ? 2
                           : 4},
      charge_(context.memory()),
      first_(std::size_t(bands()) + 1, 0) {
    for (const bool mirrored : {false, true})
        for_each_entry(mirrored, context, [&](const Entry&, std::size_t band) { ++first_[band + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    charge_.grow(first_.back() * sizeof(Entry), "triangles on the map");
    entries_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (const bool mirrored : {false, true})
        for_each_entry(mirrored, context,
                       [&](const Entry& entry, std::size_t band) { entries_[next[band]++] = entry; });
}

MapTriangle TexelOwners::moved(const Entry& entry) const {
    MapTriangle t = on_map(low_, entry.triangle, grid_.width, grid_.height);
    for (dvec2& at : t.at)
        at = at - dvec2{entry.left ? double(grid_.width) : 0.0, entry.up ? double(grid_.height) : 0.0};
    return t;
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

/// With owners only.
OwnerBand TexelOwners::cover(int number, BandOverlaps* overlaps, const Context& context) const {
    OwnerBand band{.first_row = number * band_rows, .rows = rows_of(number)};
    BandCover cover(grid_, band, overlaps);
    CancelCheck check(context);
    for (const Entry& entry : entries(number)) {
        cover.add(moved(entry), entry.triangle, charts_.of_triangle[entry.triangle]);
        check();
    }
    return band;
}

OwnerBand TexelOwners::band(int number, const Context& context) const {
    OwnerBand band = cover(number, nullptr, context);
    BandApproach approach(grid_, band);
    CancelCheck check(context);
    for (const Entry& entry : entries(number)) {
        approach.add(moved(entry), entry.triangle);
        check();
    }
    return band;
}

Overlaps TexelOwners::overlaps(Context& context) const {
    Overlaps out;
    std::vector<bool> charts(charts_.is_mirrored.size());
    std::mutex mutex;
    context.parallel_for(std::size_t(bands()), [&](std::size_t number) {
        const std::size_t texels = std::size_t(rows_of(int(number))) * std::size_t(grid_.width);
        BandOverlaps found{OpenPlaces(texels), std::vector<bool>(charts.size())};
        const OwnerBand band = cover(int(number), &found, context);
        const std::lock_guard lock(mutex);
        out.texels += found.texels.closed(), out.tests += band.tests;
        for (std::size_t i = 0; i < charts.size(); ++i)
            if (found.charts[i]) charts[i] = true;
    });
    out.charts = std::uint32_t(std::ranges::count(charts, true));
    return out;
}

}  // namespace rakelight::bake
