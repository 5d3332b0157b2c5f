// SPDX-License-Identifier: Apache-2.0
// Initial subdivision of a scene into patches and elements.
#pragma once
#include "radiosity/patches.h"

namespace rakelight::radiosity {

/// The input: a scene, its parts and the colors of its materials.
struct CutScene {
    const Scene& scene;
    const std::vector<Part>& parts;
    const ColorMaps& colors;

    Elements elements_of(const std::vector<geometry::FineMesh>& meshes, Context& context) const {
        return make_elements(scene, parts, meshes, colors, context);
    }
};

struct PatchLevel {
    std::vector<geometry::FineMesh> meshes;
    Elements elements;
    Patches patches;
    double edge = 0;  ///< [m] the longest
};

/// The finest subdivision with about this many patches and elements at most.
PatchLevel cut_to_patches(const CutScene& cut, const std::vector<geometry::FineMesh>& whole, std::size_t max_patches,
                          std::uint64_t max_elements, Context& context);

/// Uniform subdivision with at most this many elements.
/// @param edge [m] the longest edge of `meshes`
void cut_evenly(const std::vector<Part>& parts, std::vector<geometry::FineMesh>& meshes, double edge,
                std::uint64_t max_elements, Context& context);

}  // namespace rakelight::radiosity
