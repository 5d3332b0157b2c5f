// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_layers.h"

#include <algorithm>
#include <iterator>

#include "scene/materials/material_table.h"
#include "tools/material_names.h"
#include "tools/shortest_digits.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

using raster::ShadedLayer;
using Cells = std::vector<std::string>;

const shading::Draw& draw_of(const ExplainedPixel& e, const ShadedLayer& layer) {
    return e.engine->list().draws[e.pixel.triangles[layer.triangle].draw];
}

void append(Cells& cells, const float (&v)[4]) {
    for (const float f : v) cells.push_back(digits(f));
}

bool has_probes(const ShadedLayer& layer) {
    return std::any_of(std::begin(layer.trace.map), std::end(layer.trace.map),
                       [](const raster::TracedTexture& m) { return m.is_used && m.probes > 1; });
}

/// The texels that the filters read.
std::string texels_text(const ShadedLayer& layer) {
    Cells head = {"map", ">level", ">x", ">y", ">weight", ">red", ">green", ">blue", ">alpha"};
    if (has_probes(layer)) head.insert(head.begin() + 1, ">probe");
    TextTable table(head);
    for (int i = 0; i < texture_role_count; ++i) {
        const raster::TracedTexels& texels = layer.texels[std::size_t(i)];
        for (int k = 0; k < texels.count; ++k) {
            const raster::TracedTexel& t = texels.texel[k];
            Cells cells{name_of_map(i), digits(t.level), digits(t.x), digits(t.y), digits(t.weight)};
            append(cells, t.value);
            if (has_probes(layer)) cells.insert(cells.begin() + 1, digits(t.probe));
            table.add(std::move(cells));
        }
    }
    return "  Source texels, linear\n" + table.text("    ");
}

/// Maps that are read by several probes.
std::string probes_text(const ShadedLayer& layer) {
    if (!has_probes(layer)) return "";
    TextTable table({"map", ">probes", ">along u", ">along v"});
    for (int i = 0; i < texture_role_count; ++i) {
        const raster::TracedTexture& m = layer.trace.map[i];
        if (m.is_used) table.add({name_of_map(i), digits(m.probes), digits(m.axis_u), digits(m.axis_v)});
    }
    return "  Probes of the anisotropic filter, evenly spaced along the longer side of the pixel's footprint; their "
           "mean is the value\n" +
           table.text("    ");
}

std::string slopes_text(const ShadedLayer& layer) {
    if (!layer.trace.is_of_slopes) return "";
    return "    The height map's slope is read: differences over a texel of that level, along u and along v; its value "
           "here is\n    the mean of these four heights\n";
}

}  // namespace

const char* material_model(const ExplainedPixel& e, const ShadedLayer& layer) {
    const shading::MaterialFactors& factors = e.engine->list().material(draw_of(e, layer)).factors;
    return factors.unlit ? "unlit" : factors.metallic_roughness ? "metallic_roughness" : "classical";
}

bool has_own_diffuse_normal(const ShadedLayer& layer) {
    const raster::PixelTrace& t = layer.trace;
    for (std::size_t c = 0; c < 3; ++c)
        if (t.diffuse_normal[c] != t.normal[c]) return true;
    return false;
}

const char* reflection_model(const ShadedLayer& layer) {
    static constexpr const char* names[] = {"lambert", "phong", "blinn_phong",    "oren_nayar",
                                            "ward",    "pbr",   "oren_nayar_full"};
    return names[layer.reflection_model];
}

const char* name_of_map(int map) { return texture_roles()[std::size_t(map)].name; }

std::string picture_of_map(const ExplainedPixel& e, const ShadedLayer& layer, int map) {
    const shading::DrawList& list = e.engine->list();
    const std::uint32_t index = list.materials[draw_of(e, layer).material].scene_material;
    if (index == no_index) return {};
    const TextureUse& use = texture_roles()[std::size_t(map)].in(list.scene.materials[index]);
    if (!use) return {};
    const Texture& texture = list.scene.textures[use.texture];
    return texture.image && !texture.image->name.empty() ? texture.image->name : texture.name;
}

std::string maps_text(const ExplainedPixel& e, const ShadedLayer& layer) {
    TextTable table(
        {"map", "picture", ">u", ">v", ">level of detail", ">level read", ">red", ">green", ">blue", ">alpha"});
    for (int i = 0; i < texture_role_count; ++i) {
        const raster::TracedTexture& m = layer.trace.map[i];
        if (!m.is_used) continue;
        Cells cells{name_of_map(i),
                    one_line(picture_of_map(e, layer, i), 60),
                    digits(m.u),
                    digits(m.v),
                    digits(m.level_of_detail),
                    digits(m.level)};
        append(cells, m.value);
        table.add(std::move(cells));
    }
    if (table.empty()) return "";
    return "  Maps, filtered and linear\n" + table.text("    ") + slopes_text(layer) + probes_text(layer) +
           texels_text(layer);
}

}  // namespace rakelight
