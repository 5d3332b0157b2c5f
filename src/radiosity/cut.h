// SPDX-License-Identifier: Apache-2.0
// How fine a scene is cut: for patches, and for the elements that are begun with.
#pragma once
#include "radiosity/patches.h"

namespace rakelight::radiosity {

/// What is cut: a scene, its parts and the colors of its materials.
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

/// The finest cut with at most about so many patches and elements.
PatchLevel cut_to_patches(const CutScene& cut, const std::vector<geometry::FineMesh>& whole, std::size_t max_patches,
                          std::uint64_t max_elements, Context& context);

/// Cut evenly, as fine as leaves at most so many elements. @param edge  [m] the longest of `meshes`
void cut_evenly(const std::vector<Part>& parts, std::vector<geometry::FineMesh>& meshes, double edge,
                std::uint64_t max_elements, Context& context);

}  // namespace rakelight::radiosity
