// SPDX-License-Identifier: Apache-2.0
// The table of maps.
#pragma once
#include <rakelight/bake/bake.h>

namespace rakelight::bake {

struct MapKind {
    BakeMap map;
    const char* name;
    int channels;
    float even[3];        ///< value outside of charts
    Component component;  ///< component type of integer pictures
};

const MapKind& kind_of(BakeMap map);

}  // namespace rakelight::bake
