// SPDX-License-Identifier: Apache-2.0
// Tables of texture roles and numeric parameters of materials, read by loader, writer, validation, world files, reports
// and engines. A new parameter needs a row, a member of Material and its equations.
#pragma once
#include <optional>
#include <span>

#include <rakelight/scene/scene.h>

#include "image/convert.h"
#include "scene/materials/texture_role_numbers.h"

namespace rakelight {

/// Location in glTF: an extension of the material and a name in it; null: none, or handled by the loader.
struct GltfPlace {
    const char* extension = nullptr;
    const char* name = nullptr;
};

/// A factor whose value 0 disables a texture, with its key of [[material]].
struct TextureFactor {
    const char* key = nullptr;  ///< null: none
    bool (*is_zero)(const Material&) = nullptr;

    bool silences(const Material& m) const { return is_zero && is_zero(m); }
};

/// A texture role.
struct TextureRole {
    TextureRoleNumber number;
    const char* name;                    ///< in reports and JSON; with spaces for '_' in messages
    const char* key;                     ///< of [[material]]
    const char* help;                    ///< of that key
    std::optional<MaterialModel> model;  ///< materials of this model have it; absent: all
    ColorSpace space;
    // exactly one is not null
    TextureUse Material::*general = nullptr;
    TextureUse ClassicalParameters::*classical = nullptr;
    TextureUse MetallicRoughnessParameters::*metallic_roughness = nullptr;
    GltfPlace gltf = {};
    TextureFactor layer = {};   ///< strength of its layer
    TextureFactor factor = {};  ///< the factor it multiplies

    TextureUse& in(Material& m) const {
        return general ? m.*general : classical ? m.classical.*classical : m.metallic_roughness.*metallic_roughness;
    }
    const TextureUse& in(const Material& m) const {
        return general ? m.*general : classical ? m.classical.*classical : m.metallic_roughness.*metallic_roughness;
    }
    bool is_of(MaterialModel which) const { return !model || *model == which; }
    /// Whether the role affects pictures of the material.
    bool is_shown_by(const Material& m) const;
    bool is_direction() const;  ///< direction of a surface or lobe, undefined without texture coordinates
};

/// By role number.
std::span<const TextureRole, texture_role_count> texture_roles();

/// Whether a mesh has the texture coordinates of a texture use.
bool has_coordinates(const Mesh& mesh, std::uint32_t texcoord_set);

/// A number or color of metallic-roughness materials, with the default of MetallicRoughnessParameters.
struct MaterialParameter {
    enum class Kind { number, angle, color };  ///< angle: radians; degrees in world files
    enum class Range { unit, not_negative, any };
    const char* key;   ///< of [[material]]
    const char* help;  ///< of that key
    Kind kind;
    double low, high;  ///< in world files
    // exactly one is not null
    float MetallicRoughnessParameters::*number = nullptr;
    vec3 MetallicRoughnessParameters::*color = nullptr;
    GltfPlace gltf = {};
    Range gltf_range = Range::unit;
};

std::span<const MaterialParameter> metallic_roughness_parameters();

}  // namespace rakelight
