// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/motion/skins.h"

#include <cmath>
#include <map>

#include "base/format_text.h"
#include "io/gltf/nodes.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint32_t matrix_components = 16;

/// By accessor and number of joints: many skins may share one.
using BindMatrices = std::map<std::pair<std::uint32_t, std::size_t>, Block<dmat4>>;

Block<dmat4> inverse_bind_matrices(Accessors& accessors, BindMatrices& known, const Value& skin, std::size_t joints) {
    const std::uint32_t accessor = skin.index("inverseBindMatrices");
    Block<dmat4>& shared = known[{accessor, joints}];
    if (joints == 0 || !shared.empty()) return shared;
    MemoryBudget& memory = accessors.document().context().memory();
    MemoryCharge lasting(memory, joints * sizeof(dmat4), "inverse bind matrices");
    std::vector<dmat4> result(joints);  // the default is the identity
    if (accessor == no_index) return shared = {std::move(result), std::move(lasting)};
    const Elements elements =
        accessors.elements(accessor, {"inverseBindMatrices", components(matrix_components), float_only}, skin);
    if (elements.count < joints)
        skin.fail(format_text("it has {} joints but {} inverse bind matrices", joints, elements.count));
    const MemoryCharge charge(memory, elements.count * matrix_components * sizeof(float), "inverse bind matrices");
    const std::vector<float> values = to_scalars(elements);
    for (std::size_t j = 0; j < joints; ++j)
        for (std::size_t k = 0; k < matrix_components; ++k) {
            const float value = values[matrix_components * j + k];
            if (!std::isfinite(value)) skin.fail(format_text("inverse bind matrix {} is not finite", j));
            result[j][k / 4][k % 4] = value;
        }
    return shared = {std::move(result), std::move(lasting)};
}

Skin read_skin(Accessors& accessors, BindMatrices& matrices, const Nodes& nodes, const Value& source,
               std::uint32_t index) {
    Skin skin;
    skin.name = Document::name_of(source, skin_kind, index);
    const Value joints = source.list("joints");
    accessors.document().scene_charge().grow(joints.size() * sizeof(std::uint32_t), "skins");
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const std::uint32_t node = nodes.scene_index(joints.index_at(j));
        if (node == no_index) source.fail(format_text("its joint {} is not a node of the scene", joints.index_at(j)));
        skin.joints.push_back(node);
    }
    skin.inverse_bind = inverse_bind_matrices(accessors, matrices, source, skin.joints.size());
    return skin;
}

}  // namespace

void read_skins(Accessors& accessors, Meshes& meshes, const Nodes& nodes, Scene& scene) {
    const Document& document = accessors.document();
    std::map<std::uint32_t, std::uint32_t> loaded;  // of the file -> of the scene, or none
    BindMatrices matrices;
    for (const PlacedNode& placed : nodes.placed()) {
        const Value node = document.element(node_kind, placed.file, document.root());
        const std::uint32_t index = node.index("skin"), mesh = node.index("mesh");
        if (index == no_index || mesh == no_index) continue;
        const std::uint32_t joints_used = meshes.load(mesh, node).joints_used;
        if (joints_used == 0) continue;
        if (!loaded.contains(index)) {
            loaded[index] = no_index;
            read_or_drop(document, "skin " + std::to_string(index), [&] {
                Skin skin = read_skin(accessors, matrices, nodes, document.element(skin_kind, index, node), index);
                scene.skins.push_back(std::move(skin));
                loaded[index] = std::uint32_t(scene.skins.size() - 1);
            });
        }
        const std::uint32_t skin = loaded[index];
        if (skin == no_index || scene.nodes[placed.scene].meshes.empty()) continue;
        if (joints_used > scene.skins[skin].joints.size())
            node.fail(format_text("its mesh refers to joint {}, but its skin has {}", joints_used - 1,
                                  scene.skins[skin].joints.size()));
        scene.nodes[placed.scene].skin = skin;
    }
}

}  // namespace rakelight::io::gltf
