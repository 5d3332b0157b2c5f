// SPDX-License-Identifier: Apache-2.0
// Stages of a lightmap: split sides, texture coordinates, light (with_radiosity), texels, materials.
#include <rakelight/bake/lightmap.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "bake/check_settings.h"
#include "bake/lightmap_texels.h"
#include "bake/low/make_coordinates.h"
#include "math/color.h"
#include "prepare/repair/turn_triangles.h"
#include "prepare/variants.h"
#include "radiosity/lit_scene.h"
#include "scene/materials/texture_uses.h"
#include "shading/choices.h"

namespace rakelight {
namespace bake {
namespace {

/// An equivalent diffuse one-sided material; classical materials are always two-sided.
void make_one_sided(Material& m) {
    if (m.model == MaterialModel::classical)
        m.model = MaterialModel::metallic_roughness, m.metallic_roughness = {.metallic = 0};
    m.double_sided = false;
}

/// Two-sided surfaces as two one-sided ones with separate charts.
Scene one_sided(Scene scene, Context& context) {
    std::vector<std::uint32_t> back(scene.meshes.size(), no_index);
    std::vector<bool> is_split(scene.materials.size());
    AddedMeshes added(scene, context);
    for (const Instance& at : drawn_instances(scene)) {
        const Material& material = scene.materials[scene.meshes[at.mesh].material];
        if (material.model == MaterialModel::unlit || !shading::is_two_sided(material)) continue;
        is_split[scene.meshes[at.mesh].material] = true;
        if (back[at.mesh] == no_index) {
            Mesh mesh = back_side(scene.meshes[at.mesh]);
            charge_new_arrays(mesh, scene.meshes[at.mesh], context);
            back[at.mesh] = added.add(std::move(mesh));
        }
        scene.nodes[at.node].meshes.push_back(back[at.mesh]);
    }
    for (std::size_t i = 0; i < is_split.size(); ++i)
        if (is_split[i]) make_one_sided(scene.materials[i]);
    return scene;
}

/// The first texture coordinate set unused by drawn meshes; at least 1.
std::uint32_t next_set(const Scene& scene) {
    std::size_t sets = 1;
    for (const Instance& at : drawn_instances(scene)) sets = std::max(sets, scene.meshes[at.mesh].texcoords.size());
    return std::uint32_t(sets);
}

/// [materials] the largest color component of each on the map.
std::vector<float> brightest(const LightmapTexels& texels, std::size_t materials) {
    std::vector<float> most(materials, 0);
    for (std::size_t i = 0; i < texels.color.size(); ++i)
        if (const std::uint32_t m = texels.material[i]; m != no_index)
            most[m] = std::max({most[m], texels.color[i].x, texels.color[i].y, texels.color[i].z});
    return most;
}

Pixels coded(const LightmapTexels& texels, const std::vector<float>& most, const LightmapOptions& options,
             Context& context) {
    Pixels out{.width = options.width, .height = options.height, .channels = 3, .component = Component::u8};
    out.charge = share(MemoryCharge(context.memory(), 3 * texels.color.size(), "the lightmap"));
    out.bytes.resize(3 * texels.color.size());
    context.parallel_for(std::size_t(options.height), [&](std::size_t row) {
        const std::size_t begin = row * std::size_t(options.width);
        for (std::size_t i = begin; i < begin + std::size_t(options.width); ++i) {
            if (texels.material[i] == no_index || !(most[texels.material[i]] > 0)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const float share = texels.color[i][k] / most[texels.material[i]];
                out.bytes[3 * i + k] = std::byte(std::uint8_t(std::floor(srgb_from_linear(share) * 255.0f + 0.5f)));
            }
        }
    });
    return out;
}

/// Black materials with the map as emission.
void show_map(Material& m, const TextureUse& map, float most) {
    Material out;
    out.name = m.name;
    out.base_color = {0, 0, 0, m.base_color.w};
    out.alpha_mode = m.alpha_mode, out.alpha_cutoff = m.alpha_cutoff;
    if (m.alpha_mode != AlphaMode::opaque)
        out.base_color_texture = m.base_color_texture, out.opacity_texture = m.opacity_texture;
    out.emission = vec3{most, most, most}, out.emission_texture = map;
    out.metallic_roughness.metallic = 0, out.metallic_roughness.specular = 0;
    m = std::move(out);
}

Scene showing_map(Scene scene, std::uint32_t set, const std::vector<float>& most, const Pixels& picture) {
    auto image = std::make_shared<EncodedImage>();
    image->name = "lightmap", image->file = scene.source;
    image->decode = image->measure = [picture](const EncodedImage&, Context&) { return picture; };
    scene.textures.push_back({"lightmap", std::move(image), Sampler{Wrap::clamp_to_edge, Wrap::clamp_to_edge}});
    TextureUse map;
    map.texture = std::uint32_t(scene.textures.size() - 1), map.texcoord_set = set;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (scene.materials[i].model != MaterialModel::unlit) show_map(scene.materials[i], map, most[i]);
    for (const Instance& at : drawn_instances(scene)) scene.meshes[at.mesh].tangents = {};
    return scene;
}

}  // namespace
}  // namespace bake

Lightmap with_lightmap(Scene scene, const RadiositySettings& settings, const LightmapOptions& options,
                       RadiosityReport& solution, LightmapReport& report, Context& context) {
    bake::check_map(options);
    report = {};
    name_default_material(scene);
    const std::uint32_t set = bake::next_set(scene);
    bake::MadeCoordinates made =
        bake::make_coordinates(bake::one_sided(std::move(scene), context),
                               {options.width, options.height, options.chart_margin, set, true, "lightmap"}, context);
    report.texels_per_meter = made.scale;
    if (made.meshes == 0) throw Error(ErrorCode::bad_file, "has no surface that light could fall on");
    const Scene lit = with_radiosity(made.scene, settings, solution, context);
    const bake::LightmapTexels texels = bake::lightmap_texels(lit, set, options, report, context);
    const std::vector<float> most = bake::brightest(texels, made.scene.materials.size());
    report.brightest = *std::ranges::max_element(most);
    Lightmap out{.picture = bake::coded(texels, most, options, context)};
    out.scene = bake::showing_map(radiosity::static_scene(std::move(made.scene)), set, most, out.picture);
    return out;
}

}  // namespace rakelight
