// SPDX-License-Identifier: Apache-2.0
#include "scene/materials/material_table.h"

#include <iterator>

namespace rakelight {
namespace {

using M = Material;
using P = MetallicRoughnessParameters;
constexpr auto color = ColorSpace::srgb;
constexpr auto data = ColorSpace::linear;
constexpr auto classical = MaterialModel::classical;
constexpr auto metallic_roughness = MaterialModel::metallic_roughness;

bool is_black(vec3 c) { return c.x <= 0 && c.y <= 0 && c.z <= 0; }

constexpr TextureFactor emission = {"emission", [](const M& m) { return is_black(m.emission); }};
constexpr TextureFactor specular = {"specular", [](const M& m) { return is_black(m.classical.specular); }};
constexpr TextureFactor anisotropy = {"anisotropy", [](const M& m) { return m.metallic_roughness.anisotropy <= 0; }};
constexpr TextureFactor coat = {"clearcoat", [](const M& m) { return m.metallic_roughness.clearcoat <= 0; }};
constexpr TextureFactor coat_roughness = {"clearcoat_roughness",
                                          [](const M& m) { return m.metallic_roughness.clearcoat_roughness <= 0; }};
constexpr TextureFactor sheen = {"sheen_color", [](const M& m) { return is_black(m.metallic_roughness.sheen_color); }};
constexpr TextureFactor sheen_roughness = {"sheen_roughness",
                                           [](const M& m) { return m.metallic_roughness.sheen_roughness <= 0; }};

constexpr TextureFactor transmission = {"transmission",
                                        [](const M& m) { return m.metallic_roughness.transmission <= 0; }};
constexpr TextureFactor thickness = {"thickness", [](const M& m) { return m.metallic_roughness.thickness <= 0; }};
constexpr TextureFactor iridescence = {"iridescence", [](const M& m) { return m.metallic_roughness.iridescence <= 0; }};

constexpr const char* khr_specular = "KHR_materials_specular";
constexpr const char* khr_anisotropy = "KHR_materials_anisotropy";
constexpr const char* khr_clearcoat = "KHR_materials_clearcoat";
constexpr const char* khr_sheen = "KHR_materials_sheen";
constexpr const char* khr_transmission = "KHR_materials_transmission";
constexpr const char* khr_volume = "KHR_materials_volume";
constexpr const char* khr_dispersion = "KHR_materials_dispersion";
constexpr const char* khr_iridescence = "KHR_materials_iridescence";

// clang-format off
const TextureRole roles[] = {
    {role_base_color, "base_color", "color_texture", "Picture that color and opacity are multiplied by", {}, color,
     &M::base_color_texture},
    {role_normal, "normal", "normal_texture", "Normal map in tangent space", {}, data, &M::normal_texture},
    {role_height, "height", "height_texture", "Gray height map", {}, data, &M::height_texture},
    {role_opacity, "opacity", "opacity_texture", "Gray, multiplies the opacity; blended, unless `alpha` says otherwise", {}, data,
     &M::opacity_texture},
    {role_occlusion, "occlusion", "occlusion_texture", "Red multiplies ambient light", {}, data, &M::occlusion_texture},
    {role_emission, "emission", "emission_texture", "Multiplies the emission", {}, color, &M::emission_texture, {}, {}, {}, {}, emission},
    {role_specular, "specular", "specular_texture", "classical: multiplies specular", classical, color, {},
     &ClassicalParameters::specular_texture, {}, {}, {}, specular},
    {role_metallic_roughness, "metallic_roughness", "metallic_roughness_texture",
     "Green multiplies the roughness, blue the metalness", metallic_roughness, data, {}, {}, &P::texture},
    {role_specular_strength, "specular_strength", "specular_factor_texture", "Its alpha multiplies specular_factor",
     metallic_roughness, data, {}, {}, &P::specular_texture, {khr_specular, "specularTexture"}},
    {role_specular_color, "specular_color", "specular_color_texture", "Multiplies specular_color", metallic_roughness, color, {}, {},
     &P::specular_color_texture, {khr_specular, "specularColorTexture"}},
    {role_anisotropy, "anisotropy", "anisotropy_texture", "Red and green are the direction, blue multiplies anisotropy",
     metallic_roughness, data, {}, {}, &P::anisotropy_texture, {khr_anisotropy, "anisotropyTexture"}, anisotropy},
    {role_clearcoat, "clearcoat", "clearcoat_texture", "Red multiplies clearcoat", metallic_roughness, data, {}, {},
     &P::clearcoat_texture, {khr_clearcoat, "clearcoatTexture"}, coat},
    {role_clearcoat_roughness, "clearcoat_roughness", "clearcoat_roughness_texture", "Green multiplies clearcoat_roughness",
     metallic_roughness, data, {}, {}, &P::clearcoat_roughness_texture, {khr_clearcoat, "clearcoatRoughnessTexture"}, coat,
     coat_roughness},
    {role_clearcoat_normal, "clearcoat_normal", "clearcoat_normal_texture", "Normal map of the clearcoat alone", metallic_roughness,
     data, {}, {}, &P::clearcoat_normal_texture, {khr_clearcoat, "clearcoatNormalTexture"}, coat},
    {role_sheen_color, "sheen_color", "sheen_color_texture", "Multiplies sheen_color", metallic_roughness, color, {}, {},
     &P::sheen_color_texture, {khr_sheen, "sheenColorTexture"}, sheen},
    {role_sheen_roughness, "sheen_roughness", "sheen_roughness_texture", "Its alpha multiplies sheen_roughness", metallic_roughness,
     data, {}, {}, &P::sheen_roughness_texture, {khr_sheen, "sheenRoughnessTexture"}, sheen, sheen_roughness},
    {role_transmission, "transmission", "transmission_texture", "Red multiplies transmission", metallic_roughness, data, {}, {},
     &P::transmission_texture, {khr_transmission, "transmissionTexture"}, transmission},
    {role_thickness, "thickness", "thickness_texture", "Green multiplies thickness; not in engine trace, whose rays find it themselves",
     metallic_roughness, data, {}, {}, &P::thickness_texture, {khr_volume, "thicknessTexture"}, transmission, thickness},
    {role_iridescence, "iridescence", "iridescence_texture", "Red multiplies iridescence", metallic_roughness, data, {}, {},
     &P::iridescence_texture, {khr_iridescence, "iridescenceTexture"}, iridescence},
    {role_iridescence_thickness, "iridescence_thickness", "iridescence_thickness_texture",
     "Green leads from the least to the greatest thickness of the film", metallic_roughness, data, {}, {},
     &P::iridescence_thickness_texture, {khr_iridescence, "iridescenceThicknessTexture"}, iridescence},
};

using Kind = MaterialParameter::Kind;
using Range = MaterialParameter::Range;
const MaterialParameter parameters[] = {
    {"metallic", "0 to 1", Kind::number, 0, 1, &P::metallic},
    {"roughness", "0 to 1", Kind::number, 0, 1, &P::roughness},
    {"ior", "Index of refraction (default 1.5)", Kind::number, 1, 100, &P::ior, {}, {"KHR_materials_ior", "ior"}, Range::not_negative},
    {"specular_factor", khr_specular, Kind::number, 0, 1, &P::specular, {}, {khr_specular, "specularFactor"}},
    {"specular_color", khr_specular, Kind::color, 0, 0, {}, &P::specular_color, {khr_specular, "specularColorFactor"},
     Range::not_negative},
    {"anisotropy", khr_anisotropy, Kind::number, 0, 1, &P::anisotropy, {}, {khr_anisotropy, "anisotropyStrength"}},
    {"anisotropy_rotation_deg", khr_anisotropy, Kind::angle, -360, 360, &P::anisotropy_rotation_rad, {},
     {khr_anisotropy, "anisotropyRotation"}, Range::any},
    {"clearcoat", khr_clearcoat, Kind::number, 0, 1, &P::clearcoat, {}, {khr_clearcoat, "clearcoatFactor"}},
    {"clearcoat_roughness", khr_clearcoat, Kind::number, 0, 1, &P::clearcoat_roughness, {},
     {khr_clearcoat, "clearcoatRoughnessFactor"}},
    {"clearcoat_normal_scale", "How strongly the clearcoat's normal map bumps (default 1)", Kind::number, -100, 100,
     &P::clearcoat_normal_scale},  // glTF: in the texture's object
    {"sheen_color", khr_sheen, Kind::color, 0, 0, {}, &P::sheen_color, {khr_sheen, "sheenColorFactor"}},
    {"sheen_roughness", khr_sheen, Kind::number, 0, 1, &P::sheen_roughness, {}, {khr_sheen, "sheenRoughnessFactor"}},
    {"transmission", "How much light goes through instead of being scattered", Kind::number, 0, 1, &P::transmission, {},
     {khr_transmission, "transmissionFactor"}},
    {"thickness", "More than 0: a body that refracts and absorbs; 0 (default): a thin wall", Kind::number, 0, 1e6, &P::thickness, {},
     {khr_volume, "thicknessFactor"}, Range::not_negative},
    {"attenuation_distance", "[m] in which light in the body becomes attenuation_color; 0 (default): nothing is absorbed",
     Kind::number, 0, 1e6, &P::attenuation_distance, {}, {khr_volume, "attenuationDistance"}, Range::not_negative},
    {"attenuation_color", khr_volume, Kind::color, 0, 0, {}, &P::attenuation_color, {khr_volume, "attenuationColor"}},
    {"dispersion", "20 / Abbe number of a body: how far it parts colors (default 0); engines soft and gl, method path", Kind::number, 0,
     100, &P::dispersion, {}, {khr_dispersion, "dispersion"}, Range::not_negative},
    {"iridescence", "A thin film whose color changes with the angle", Kind::number, 0, 1, &P::iridescence, {},
     {khr_iridescence, "iridescenceFactor"}},
    {"iridescence_ior", "Index of refraction of the film (default 1.3)", Kind::number, 1, 100, &P::iridescence_ior, {},
     {khr_iridescence, "iridescenceIor"}, Range::not_negative},
    {"iridescence_thickness_min_nm", "[nm] of the film where its thickness texture is 0 (default 100)", Kind::number, 0, 1e6,
     &P::iridescence_thickness_min_nm, {}, {khr_iridescence, "iridescenceThicknessMinimum"}, Range::not_negative},
    {"iridescence_thickness_max_nm", "[nm] of the film where that is 1, or there is none (default 400)", Kind::number, 0, 1e6,
     &P::iridescence_thickness_max_nm, {}, {khr_iridescence, "iridescenceThicknessMaximum"}, Range::not_negative},
};
// clang-format on
static_assert(std::size(roles) == texture_role_count);

}  // namespace

std::span<const TextureRole, texture_role_count> texture_roles() { return roles; }
std::span<const MaterialParameter> metallic_roughness_parameters() { return parameters; }

bool TextureRole::is_shown_by(const Material& m) const {
    if (number == role_opacity) return m.alpha_mode != AlphaMode::opaque;
    if (m.model == MaterialModel::unlit) return number == role_base_color;
    return is_of(m.model) && !layer.silences(m);
}

bool TextureRole::is_direction() const {
    return number == role_normal || number == role_height || number == role_anisotropy ||
           number == role_clearcoat_normal;
}

bool has_coordinates(const Mesh& mesh, std::uint32_t texcoord_set) {
    return texcoord_set < mesh.texcoords.size() && !mesh.texcoords[texcoord_set].empty();
}

}  // namespace rakelight
