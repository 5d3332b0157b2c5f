// SPDX-License-Identifier: Apache-2.0
#include <rakelight/bake/bake.h>

#include "bake/bake_maps.h"

namespace rakelight {
namespace bake {

const MapKind& kind_of(BakeMap map) {
    // Name, channels, value outside of charts, component type of integer pictures.
    static constexpr MapKind kinds[] = {{BakeMap::normal, "normal", 3, {0, 0, 1}, Component::u8},
                                        {BakeMap::height, "height", 1, {0, 0, 0}, Component::u16},
                                        {BakeMap::curvature, "curvature", 1, {0, 0, 0}, Component::u8},
                                        {BakeMap::occlusion, "occlusion", 1, {1, 0, 0}, Component::u8},
                                        {BakeMap::light, "light", 3, {0, 0, 0}, Component::u8}};
    return kinds[std::size_t(map)];
}

}  // namespace bake

const char* name_of(BakeMap map) noexcept { return bake::kind_of(map).name; }

Component component_of(BakeMap map) noexcept { return bake::kind_of(map).component; }

std::span<const BakeMap> all_bake_maps() noexcept {
    static constexpr BakeMap all[] = {BakeMap::normal, BakeMap::height, BakeMap::curvature, BakeMap::occlusion,
                                      BakeMap::light};
    return all;
}

}  // namespace rakelight
