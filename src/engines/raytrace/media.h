// SPDX-License-Identifier: Apache-2.0
// The bodies that a ray is in, innermost last: by their materials, since one body may be made of several objects.
#pragma once
#include <algorithm>
#include <array>

#include <rakelight/scene/scene.h>

#include "cpu_shading/material_job.h"
#include "math/functions.h"
#include "shading/refraction.h"

namespace rakelight::raytrace {

struct Media {
    static constexpr std::size_t most = 4;
    std::array<std::uint32_t, most> material{no_index, no_index, no_index, no_index};  ///< into DrawList::materials
    std::uint32_t count = 0;

    std::uint32_t innermost() const { return count > 0 ? material[count - 1] : no_index; }
    bool holds(std::uint32_t body) const {
        return std::find(material.begin(), material.begin() + count, body) != material.begin() + count;
    }
    /// Where they are too many, the outermost is forgotten.
    void enter(std::uint32_t body) {
        if (count == most) std::shift_left(material.begin(), material.end(), 1), --count;
        material[count++] = body;
    }
    /// One that it is not in: nothing changes.
    void leave(std::uint32_t body) {
        for (std::uint32_t i = count; i-- > 0;)
            if (material[i] == body) {
                std::shift_left(material.begin() + i, material.begin() + count, 1);
                material[--count] = no_index;
                return;
            }
    }
};

using shading::refraction_of;

/// What a body leaves of light after `distance` [m] in it: Beer-Lambert.
inline vec3 absorbed(const shading::MaterialFactors& m, float distance) {
    const auto left = [&](std::size_t c) {
        return m.attenuation[c] > 0 ? float(math::exp(-double(m.attenuation[c]) * double(distance))) : 1.0f;
    };
    return {left(0), left(1), left(2)};
}

}  // namespace rakelight::raytrace
