// SPDX-License-Identifier: Apache-2.0
// The textures and the numbers of materials, one row each: loader, writer, validation, world files, reports and engines
// read these tables, so that a new one is a row, its place in the Material and what the equations do with it.
#pragma once
#include <optional>
#include <span>

#include <rakelight/scene.h>

#include "image/convert.h"
#include "scene/texture_role_numbers.h"

namespace rakelight {

/// Where glTF keeps something: an extension of the material and the name in it; null: nowhere, or where the code of the
/// loader says.
struct GltfPlace {
    const char* extension = nullptr;
    const char* name = nullptr;
};

/// A number without which a texture shows nothing. By its key of [[material]].
struct TextureFactor {
    const char* key = nullptr;  ///< null: there is none
    bool (*is_zero)(const Material&) = nullptr;

    bool silences(const Material& m) const { return is_zero && is_zero(m); }
};

/// What a texture of a material is read for.
struct TextureRole {
    TextureRoleNumber number;
    const char* name;                    ///< in reports and JSON; with spaces for '_' in messages
    const char* key;                     ///< of [[material]]
    const char* help;                    ///< of that key
    std::optional<MaterialModel> model;  ///< whose materials have it; absent: all
    ColorSpace space;
    // exactly one is not null
    TextureUse Material::*general = nullptr;
    TextureUse ClassicalParameters::*classical = nullptr;
    TextureUse MetallicRoughnessParameters::*metallic_roughness = nullptr;
    GltfPlace gltf = {};
    TextureFactor layer = {};   ///< the strength of what it belongs to
    TextureFactor factor = {};  ///< what it multiplies itself

    TextureUse& in(Material& m) const {
        return general ? m.*general : classical ? m.classical.*classical : m.metallic_roughness.*metallic_roughness;
    }
    const TextureUse& in(const Material& m) const {
        return general ? m.*general : classical ? m.classical.*classical : m.metallic_roughness.*metallic_roughness;
    }
    bool is_of(MaterialModel which) const { return !model || *model == which; }
    /// Whether pictures of the material show what the texture is read for.
    bool is_shown_by(const Material& m) const;
    bool is_direction() const;  ///< of a surface or a lobe: means nothing without texture coordinates
};

/// By number.
std::span<const TextureRole, texture_role_count> texture_roles();

/// Whether a mesh has what a texture of this set of texture coordinates is read by.
bool has_coordinates(const Mesh& mesh, std::uint32_t texcoord_set);

/// A number or a color of metallic-roughness materials. Its default is that of MetallicRoughnessParameters.
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
