// SPDX-License-Identifier: Apache-2.0
#include "tools/thumbnail_textures.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "base/format_text.h"
#include "io/reduced_image.h"
#include "scene/material_table.h"

namespace rakelight {
namespace {

/// Roles whose pictures are missed less than those of the next kind.
struct Kind {
    const char* name;
    bool (*has)(TextureRoleNumber);
};

constexpr std::array<Kind, 4> kinds{
    {{"normal, height and occlusion maps",
      [](TextureRoleNumber role) {
          return role == role_normal || role == role_height || role == role_occlusion || role == role_clearcoat_normal;
      }},
     {"maps of reflection and transmission",
      [](TextureRoleNumber role) { return role != role_base_color && role != role_opacity && role != role_emission; }},
     {"maps of emission", [](TextureRoleNumber role) { return role == role_emission; }},
     {"maps of color and opacity", [](TextureRoleNumber) { return true; }}}};

std::size_t kind_of(TextureRoleNumber role) {
    std::size_t kind = 0;
    while (!kinds[kind].has(role)) ++kind;
    return kind;
}

/// A picture that materials show.
struct Picture {
    ImageHandle image;
    std::size_t kind;  ///< the last of its roles
    std::uint64_t work;
};

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

/// In the order of the materials.
std::vector<Picture> pictures_of(const Scene& scene, Context& context) {
    std::vector<Picture> pictures;
    std::map<ImageHandle, std::size_t> places;
    for (const Material& material : scene.materials)
        for (const TextureRole& role : texture_roles()) {
            if (!role.in(material) || !role.is_shown_by(material)) continue;
            const ImageHandle& image = scene.textures[role.in(material).texture].image;
            const auto [place, is_new] = places.try_emplace(image, pictures.size());
            if (is_new) pictures.push_back({image, 0, io::decoding_work(*image, context)});
            std::size_t& kind = pictures[place->second].kind;
            kind = std::max(kind, kind_of(role.number));
        }
    return pictures;
}

void leave_out(Scene& scene, const std::set<ImageHandle>& images) {
    for (Material& material : scene.materials)
        for (const TextureRole& role : texture_roles()) {
            if (!role.in(material) || !images.contains(scene.textures[role.in(material).texture].image)) continue;
            role.in(material) = {};
            disable_factor(material, role.number);
        }
}

/// Pictures of the kinds that are missed less come first, then larger ones, then those that are used last.
std::set<ImageHandle> too_many(std::vector<Picture> pictures, std::uint64_t work, std::uint64_t most_work,
                               const Scene& scene, Context& context) {
    for (const Picture& picture : pictures) work += picture.work;
    std::ranges::reverse(pictures);
    std::ranges::stable_sort(pictures, [](const Picture& a, const Picture& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.work > b.work;
    });
    std::set<ImageHandle> images;
    std::array<int, kinds.size()> counts{}, left_out{};
    for (const Picture& picture : pictures) {
        ++counts[picture.kind];
        if (work <= most_work || picture.work == 0) continue;
        work -= picture.work;
        images.insert(picture.image);
        ++left_out[picture.kind];
    }
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        if (left_out[kind] > 0)
            context.report().add(Remark::dropped, scene.source, "",
                                 format_text("left out, as decoding takes too long: {} of {} {}", left_out[kind],
                                             counts[kind], kinds[kind].name));
    return images;
}

/// Its picture is decoded as it is, as reflections show it enlarged.
std::uint64_t work_of_environment(const Scene& scene, Context& context) {
    const bool has_picture = scene.environment && scene.environment->image;
    return has_picture ? io::decoding_work(*scene.environment->image, context) : 0;
}

}  // namespace

Scene with_thumbnail_textures(Scene scene, int most_side, std::uint64_t most_work, Context& context) {
    const std::uint64_t environment = work_of_environment(scene, context);
    leave_out(scene, too_many(pictures_of(scene, context), environment, most_work, scene, context));
    std::map<ImageHandle, ImageHandle> reduced;  // textures that share a picture still do
    for (Texture& texture : scene.textures) {
        ImageHandle& image = reduced[texture.image];
        if (!image) image = io::reduced_image(texture.image, most_side);
        texture.image = image;
    }
    return scene;
}

}  // namespace rakelight
