// SPDX-License-Identifier: Apache-2.0
// Normals and tangents that were computed, put into the meshes of the scene.
#pragma once
#include <map>
#include <vector>

#include <rakelight/attributes.h>

#include "prepare/morph_normals.h"
#include "prepare/smooth_request.h"
#include "prepare/smooth_selection.h"
#include "prepare/variants.h"

namespace rakelight {

struct Computed {
    std::vector<MeshAttributes> attributes;
    std::vector<TargetDirections> targets;  ///< [attributes], or none: no target gets new normals
};

/// The mesh with these tangents and, where they are new, normals; vertices that split are appended.
Mesh with_attributes(const Mesh& source, MeshAttributes&& attributes, bool new_normals, Context& context);

/// Puts the results into the scene. What several results are made of keeps its first form until all are.
class ResultPlacer {
public:
    /// @param numbers  [selection.computed] the meshes that were computed
    ResultPlacer(Scene& scene, const SmoothRequest& request, const SmoothSelection& selection,
                 const std::vector<std::uint32_t>& numbers, Context& context);
    void place(Computed& computed);
    void report() const;

private:
    const Mesh& source(std::uint32_t number);
    bool keeps_bitangents(const Mesh& mesh) const;

    Scene& scene_;
    const SmoothRequest& request_;
    const SmoothSelection& s_;
    const std::vector<std::uint32_t>& numbers_;
    Context& context_;
    MeshVariants variants_;
    std::vector<std::uint32_t> uses_;  ///< [meshes] how many results are made of each, at most
    std::map<std::uint32_t, Mesh> originals_;
};

}  // namespace rakelight
