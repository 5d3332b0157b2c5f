// SPDX-License-Identifier: Apache-2.0
// glTF materials to scene materials, made when a primitive first asks.
#pragma once
#include "io/gltf/textures.h"
#include "scene/materials/material_table.h"

namespace rakelight::io::gltf {

class Materials {
public:
    Materials(const Document& document, Textures& textures, Scene& scene)
        : document_(document), textures_(textures), scene_(scene) {}
    /// The scene's index of material `index` (`none` stays `none`: the default material).
    /// @throws Error: no such material, values of wrong kinds or out of range.
    std::uint32_t load(std::uint32_t index, const Value& from);
    /// The scene's index of a material of the file that was loaded; `no_index`: nothing uses it.
    std::uint32_t scene_index(std::uint32_t index) const {
        const auto known = loaded_.find(index);
        return known == loaded_.end() ? no_index : known->second;
    }

private:
    void read_common(const Value& source, Material& material);
    void read_metallic_roughness(const Value& source, Material& material);
    void read_specular_glossiness(const Value& source, Material& material);
    void read_extensions(const Value& source, Material& material);
    void read_parameter(const Value& object, const MaterialParameter& p, MetallicRoughnessParameters& target);
    const Document& document_;
    Textures& textures_;
    Scene& scene_;
    std::map<std::uint32_t, std::uint32_t> loaded_;
};

}  // namespace rakelight::io::gltf
