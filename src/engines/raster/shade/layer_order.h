// SPDX-License-Identifier: Apache-2.0
// Which of two blended surfaces is laid first at a place of the picture.
#pragma once
#include <algorithm>
#include <cstdint>

namespace rakelight::raster {

/// Where a blended surface stands at a pixel or one of its samples.
struct LayerPlace {
    float key;             ///< of its depth there; greater is nearer
    std::uint32_t number;  ///< of its triangle in the order of the scene
};

/// [1] Depth keys that differ by less, as a share of the greater one, are equal. So surfaces in one plane keep the
/// order of the scene at all their pixels, whatever rounding makes of their triangles.
inline constexpr float equal_depths = 0x1p-19f;

/// The farther one is; of equal ones the first of the scene.
inline bool is_laid_before(LayerPlace a, LayerPlace b) {
    const float reach = equal_depths * std::max(a.key, b.key);
    return a.key < b.key - reach || (a.key <= b.key + reach && a.number < b.number);
}

/// Moves the last of what is in the order up to its place.
/// @param place_of  of an element
template <class Iterator, class PlaceOf>
void insert_last_layer(Iterator begin, Iterator end, const PlaceOf& place_of) {
    for (Iterator at = end - 1; at != begin && is_laid_before(place_of(*at), place_of(*(at - 1))); --at)
        std::iter_swap(at, at - 1);
}

}  // namespace rakelight::raster
