// SPDX-License-Identifier: Apache-2.0
#include "tools/thumbnail_textures.h"

#include <array>
#include <map>
#include <string>
#include <utility>

#include "io/reduced_image.h"
#include "scene/material_table.h"

namespace rakelight {
namespace {

/// What is left out together, and is missed less than what follows.
struct Cut {
    const char* name;
    bool (*has)(TextureRoleNumber);
};

constexpr std::array<Cut, 4> cuts{
    {{"normal, height and occlusion maps",
      [](TextureRoleNumber role) {
          return role == role_normal || role == role_height || role == role_occlusion || role == role_clearcoat_normal;
      }},
     {"all textures but those of color, opacity and emission",
      [](TextureRoleNumber role) { return role != role_base_color && role != role_opacity && role != role_emission; }},
     {"all textures but those of color and opacity",
      [](TextureRoleNumber role) { return role != role_base_color && role != role_opacity; }},
     {"all textures", [](TextureRoleNumber) { return true; }}}};

/// A factor is chosen to be multiplied by its texture: alone it would shine, or be metal, everywhere.
void disable_factor(Material& m, TextureRoleNumber role) {
    MetallicRoughnessParameters& p = m.metallic_roughness;
    if (role == role_emission) m.emission = {};
    if (role == role_specular) m.classical.specular = {};
    if (role == role_metallic_roughness) p.metallic = 0;
    if (role == role_anisotropy) p.anisotropy = 0;
    if (role == role_clearcoat) p.clearcoat = 0;
    if (role == role_sheen_color) p.sheen_color = {};
    if (role == role_transmission) p.transmission = 0;
    if (role == role_iridescence) p.iridescence = 0;
}

/// @return whether there was something
bool leave_out(Material& material, const Cut& cut) {
    bool is_changed = false;
    for (const TextureRole& role : texture_roles()) {
        if (!role.in(material) || !cut.has(role.number)) continue;
        role.in(material) = {};
        disable_factor(material, role.number);
        is_changed = true;
    }
    return is_changed;
}

/// Each picture of a scene with its work.
std::map<ImageHandle, std::uint64_t> works_of(const Scene& scene, Context& context) {
    std::map<ImageHandle, std::uint64_t> works;
    for (const Texture& texture : scene.textures)
        if (const auto [entry, is_new] = works.try_emplace(texture.image); is_new)
            entry->second = io::decoding_work(*texture.image, context);
    return works;
}

std::uint64_t work_of(const Scene& scene, std::map<ImageHandle, std::uint64_t> works) {
    std::uint64_t sum = 0;
    for (const Material& material : scene.materials)
        for (const TextureRole& role : texture_roles())
            if (role.in(material) && role.is_shown_by(material))
                sum += std::exchange(works[scene.textures[role.in(material).texture].image], 0);
    return sum;
}

}  // namespace

Scene with_thumbnail_textures(Scene scene, int most_side, std::uint64_t most_work, Context& context) {
    const auto works = works_of(scene, context);
    for (const Cut& cut : cuts) {
        if (work_of(scene, works) <= most_work) break;
        bool is_changed = false;
        for (Material& material : scene.materials) is_changed |= leave_out(material, cut);
        if (is_changed)
            context.report().add(Remark::dropped, scene.source, "",
                                 std::string("left out, as decoding takes too long: ") + cut.name);
    }
    std::map<ImageHandle, ImageHandle> reduced;  // textures that share a picture still do
    for (Texture& texture : scene.textures) {
        ImageHandle& image = reduced[texture.image];
        if (!image) image = io::reduced_image(texture.image, most_side);
        texture.image = image;
    }
    return scene;
}

}  // namespace rakelight
