// SPDX-License-Identifier: Apache-2.0
#include "bake/place_numbers.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rakelight::bake {

std::vector<std::uint32_t> place_numbers(std::span<const dvec3> places) {
    std::vector<std::uint32_t> order(places.size()), numbers(places.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) { return std::tie(places[v].x, places[v].y, places[v].z); };
    std::ranges::sort(order,
                      [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i)
        numbers[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? numbers[order[i - 1]] : order[i];
    return numbers;
}

}  // namespace rakelight::bake
