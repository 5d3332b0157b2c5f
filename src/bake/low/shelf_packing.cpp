// SPDX-License-Identifier: Apache-2.0
#include "bake/low/shelf_packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "base/cancel_check.h"

namespace rakelight::bake {
namespace {

struct Sheet {
    int width, height, margin;
};

/// [px] size of a length, at least one pixel.
double pixels(double length, double scale) { return std::max(1.0, std::ceil(length * scale)); }

/// @param order sorted by decreasing height
/// @param place null: only test whether they fit
bool lay(std::span<const dvec2> sizes, std::span<const std::uint32_t> order, const Sheet& sheet, double scale,
         std::vector<dvec2>* place) {
    const double margin = sheet.margin;
    double x = margin, y = margin, shelf = 0;
    for (const std::uint32_t i : order) {
        const double width = pixels(sizes[i].x, scale), height = pixels(sizes[i].y, scale);
        if (x + width + margin > sheet.width && x > margin) y += shelf + margin, x = margin, shelf = 0;
        if (x + width + margin > sheet.width || y + height + margin > sheet.height) return false;
        if (place) (*place)[i] = {x, y};
        x += width + margin;
        shelf = std::max(shelf, height);
    }
    return true;
}

}  // namespace

std::optional<Packing> pack_shelves(std::span<const dvec2> sizes, int width, int height, int margin, Context& context) {
    const Sheet sheet{width, height, margin};
    std::vector<std::uint32_t> order(sizes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return sizes[a].y > sizes[b].y; });
    Packing packing;
    packing.place.resize(sizes.size());
    if (!lay(sizes, order, sheet, 0, &packing.place)) return std::nullopt;
    double longest = 0;
    for (const dvec2 size : sizes) longest = std::max({longest, size.x, size.y});
    if (!(longest > 0)) return packing;
    double fits = 0, too_large = std::max(width, height) / longest * 2;
    for (int step = 0; step < 40; ++step) {
        context.throw_if_cancelled();
        const double middle = (fits + too_large) / 2;
        (lay(sizes, order, sheet, middle, nullptr) ? fits : too_large) = middle;
    }
    packing.scale = fits;
    lay(sizes, order, sheet, fits, &packing.place);
    return packing;
}

}  // namespace rakelight::bake
