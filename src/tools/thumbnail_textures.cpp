// SPDX-License-Identifier: Apache-2.0
#include "tools/thumbnail_textures.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "base/format_text.h"
#include "io/pictures/reduced_image.h"
#include "scene/materials/material_table.h"

namespace rakelight {
namespace {

/// Roles whose pictures are missed less than those of the next kind.
struct Kind {
    const char* name;
    bool (*has)(TextureRoleNumber);
};

constexpr std::array<Kind, 5> kinds{
    {{"normal, height and occlusion maps",
      [](TextureRoleNumber role) {
          return role == role_normal || role == role_height || role == role_occlusion || role == role_clearcoat_normal;
      }},
     {"maps of reflection and transmission",
      [](TextureRoleNumber role) { return role != role_base_color && role != role_opacity && role != role_emission; }},
     {"maps of emission", [](TextureRoleNumber role) { return role == role_emission; }},
     {"environment maps; the built-in studio replaces it", [](TextureRoleNumber) { return false; }},
     {"maps of color and opacity", [](TextureRoleNumber) { return true; }}}};

/// [px] A mask is decoded at this size at least: what is seen of it is kept from there on, and would be lost before.
constexpr int mask_side = 2048;
constexpr std::size_t environment_kind = 3;
/// [pixels] What the light of an environment takes beside decoding its picture: 110 ms, where a pixel takes 16 ns.
constexpr std::uint64_t environment_work = 7'000'000;
constexpr int environment_sides = 2;  ///< times the side of textures: a thumbnail sees about an eighth of its width

std::size_t kind_of(TextureRoleNumber role) {
    std::size_t kind = 0;
    while (!kinds[kind].has(role)) ++kind;
    return kind;
}

/// A picture that materials or the environment show.
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

ImageHandle environment_image(const Scene& scene) { return scene.environment ? scene.environment->image : nullptr; }

/// Pictures whose alpha a material compares with its cutoff.
std::set<ImageHandle> masks_of(const Scene& scene, Context& context) {
    std::set<ImageHandle> masks;
    for (const Material& m : scene.materials) {
        if (m.alpha_mode != AlphaMode::mask) continue;
        if (m.opacity_texture) masks.insert(scene.textures[m.opacity_texture.texture].image);
        if (!m.base_color_texture) continue;
        const ImageHandle& image = scene.textures[m.base_color_texture.texture].image;
        if (io::has_alpha(*image, context)) masks.insert(image);
    }
    return masks;
}

/// How large pictures are decoded.
struct Sides {
    int most;
    std::set<ImageHandle> masks;
    int of(const ImageHandle& image) const { return masks.contains(image) ? std::max(most, mask_side) : most; }
};

/// That of the environment, then those of the materials in their order.
std::vector<Picture> pictures_of(const Scene& scene, const Sides& sides, Context& context) {
    std::vector<Picture> pictures;
    std::map<ImageHandle, std::size_t> places;
    if (const ImageHandle image = environment_image(scene)) {
        places[image] = 0;
        pictures.push_back({image, environment_kind,
                            environment_work + io::decoding_work(*image, environment_sides * sides.most, context)});
    }
    for (const Material& material : scene.materials)
        for (const TextureRole& role : texture_roles()) {
            if (!role.in(material) || !role.is_shown_by(material)) continue;
            const ImageHandle& image = scene.textures[role.in(material).texture].image;
            const auto [place, is_new] = places.try_emplace(image, pictures.size());
            if (is_new) pictures.push_back({image, 0, io::decoding_work(*image, sides.of(image), context)});
            std::size_t& kind = pictures[place->second].kind;
            kind = std::max(kind, kind_of(role.number));
        }
    return pictures;
}

void leave_out(Scene& scene, const std::set<ImageHandle>& images) {
    if (images.contains(environment_image(scene))) scene.environment->image = nullptr;
    for (Material& material : scene.materials)
        for (const TextureRole& role : texture_roles()) {
            if (!role.in(material) || !images.contains(scene.textures[role.in(material).texture].image)) continue;
            role.in(material) = {};
            disable_factor(material, role.number);
        }
}

/// Pictures that alone take too long come first, then those of the kinds that are missed less, then larger ones, then
/// those that are used last.
std::set<ImageHandle> too_many(std::vector<Picture> pictures, std::uint64_t most_work, const Scene& scene,
                               Context& context) {
    std::uint64_t work = 0;
    for (const Picture& picture : pictures) work += picture.work;
    std::ranges::reverse(pictures);
    std::ranges::stable_sort(pictures, [most_work](const Picture& a, const Picture& b) {
        const auto key = [most_work](const Picture& p) { return std::tuple(p.work <= most_work, p.kind, ~p.work); };
        return key(a) < key(b);
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

}  // namespace

Scene with_thumbnail_textures(Scene scene, int most_side, std::uint64_t most_work, Context& context) {
    const Sides sides{most_side, masks_of(scene, context)};
    leave_out(scene, too_many(pictures_of(scene, sides, context), most_work, scene, context));
    std::map<ImageHandle, ImageHandle> reduced;  // textures that share a picture still do
    for (Texture& texture : scene.textures) {
        ImageHandle& image = reduced[texture.image];
        if (!image) image = io::reduced_image(texture.image, sides.of(texture.image));
        texture.image = image;
    }
    if (const ImageHandle image = environment_image(scene))
        scene.environment->image = io::reduced_image(image, environment_sides * most_side);
    return scene;
}

}  // namespace rakelight
