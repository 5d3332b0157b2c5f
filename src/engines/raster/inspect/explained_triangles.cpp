// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/explained_triangles.h"

#include <algorithm>
#include <numeric>

namespace rakelight::raster {

void summarize(PixelExplanation& pixel, const OpenScene& of) {
    for (CoveringTriangle& t : pixel.triangles) {
        const auto nearest =
            std::max_element(t.samples.begin(), t.samples.end(),
                             [](const CoveredSample& a, const CoveredSample& b) { return a.depth_key < b.depth_key; });
        t.depth_key = nearest->depth_key;
        t.distance = of.distance_of(t.depth_key);
        t.alpha = nearest->alpha;
        t.fate = t.samples[0].fate;
        for (const CoveredSample& c : t.samples) t.fate = std::min(t.fate, c.fate);
    }
}

void sort_by_depth(PixelExplanation& pixel) {
    std::vector<std::size_t> order(pixel.triangles.size()), place(order.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return pixel.triangles[a].depth_key > pixel.triangles[b].depth_key;
    });
    std::vector<CoveringTriangle> sorted;
    for (const std::size_t i : order) {
        place[i] = sorted.size();
        sorted.push_back(std::move(pixel.triangles[i]));
    }
    pixel.triangles = std::move(sorted);
    for (ShadedLayer& layer : pixel.layers) layer.triangle = place[layer.triangle];
    for (SeenSample& s : pixel.samples)
        if (s.triangle != no_triangle) s.triangle = place[s.triangle];
}

}  // namespace rakelight::raster
