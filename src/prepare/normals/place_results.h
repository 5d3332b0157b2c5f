// SPDX-License-Identifier: Apache-2.0
// Stores computed normals and tangents in the meshes of the scene.
#pragma once
#include <map>
#include <vector>

#include <rakelight/geometry/attributes.h>

#include "prepare/normals/morph_normals.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/normals/smooth_selection.h"
#include "prepare/variants.h"

namespace rakelight {

struct Computed {
    std::vector<MeshAttributes> attributes;
    std::vector<TargetDirections> targets;  ///< [attributes], or empty: no new normals of targets
    std::vector<std::size_t> alike;         ///< [attributes] first_alike(), which alone has `targets`; or empty
};

/// The mesh with these tangents and, if new, normals; split vertices are appended.
Mesh with_attributes(const Mesh& source, MeshAttributes&& attributes, bool new_normals, Context& context);

/// Stores the results in the scene. Sources of several results are kept until all are stored.
class ResultPlacer {
public:
    /// @param numbers [selection.computed] indices of the computed meshes
    ResultPlacer(Scene& scene, const SmoothRequest& request, const SmoothSelection& selection,
                 const std::vector<std::uint32_t>& numbers, Context& context);
    void place(Computed& computed);
    void report() const;

private:
    const Mesh& source(std::uint32_t number);
    Mesh made_mesh(std::uint32_t number, MeshAttributes& made, TargetDirections* targets);
    bool keeps_bitangents(const Mesh& mesh) const;
    /// Normals (if asked) or tangents of targets, which many meshes may share.
    bool has_directions(const Block<MorphTarget>& targets, bool with_normals);

    Scene& scene_;
    const SmoothRequest& request_;
    const SmoothSelection& s_;
    const std::vector<std::uint32_t>& numbers_;
    Context& context_;
    MeshVariants variants_;
    std::vector<std::uint32_t> uses_;  ///< [meshes] upper bound of the results of each
    std::map<std::uint32_t, Mesh> originals_;
    std::map<const void*, bool> has_directions_;  ///< by tables of targets
};

}  // namespace rakelight
