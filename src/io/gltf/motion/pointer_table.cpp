// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/motion/pointer_table.h"

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/motion.h>

#include <map>
#include <vector>

#include "scene/materials/material_table.h"

namespace rakelight::io::gltf {
namespace {

constexpr AnimationPath of_material = AnimationPath::material, of_light = AnimationPath::light,
                        of_camera = AnimationPath::camera;

/// Where the material has the textureInfo of a role; empty: glTF has none.
std::string texture_place(const TextureRole& role) {
    if (role.gltf.extension) return "extensions/" + std::string(role.gltf.extension) + "/" + role.gltf.name;
    switch (role.number) {
        case role_base_color:
            return "pbrMetallicRoughness/baseColorTexture";
        case role_metallic_roughness:
            return "pbrMetallicRoughness/metallicRoughnessTexture";
        case role_normal:
            return "normalTexture";
        case role_occlusion:
            return "occlusionTexture";
        case role_emission:
            return "emissiveTexture";
        default:
            return {};
    }
}

std::string text_or_empty(const char* text) { return text ? text : ""; }

void add_materials(std::vector<PointerRow>& rows) {
    const auto add = [&](const std::string& place, const char* property, const char* extension = nullptr) {
        rows.push_back({of_material,
                        place,
                        property,
                        animated_property(of_material, property)->width,
                        text_or_empty(extension),
                        {}});
    };
    add("pbrMetallicRoughness/baseColorFactor", "base_color");
    add("pbrMetallicRoughness/metallicFactor", "metallic");
    add("pbrMetallicRoughness/roughnessFactor", "roughness");
    add("emissiveFactor", "emission");
    add("alphaCutoff", "alpha_cutoff");
    add("normalTexture/scale", "normal_scale");
    add("occlusionTexture/strength", "occlusion_strength");
    const char* const coat = "KHR_materials_clearcoat";
    add(std::string("extensions/") + coat + "/clearcoatNormalTexture/scale", "clearcoat_normal_scale", coat);
    for (const MaterialParameter& p : metallic_roughness_parameters())
        if (p.gltf.extension)
            add("extensions/" + std::string(p.gltf.extension) + "/" + p.gltf.name, p.key, p.gltf.extension);
    for (const TextureRole& role : texture_roles()) {
        const std::string texture = texture_place(role);
        if (texture.empty()) continue;
        for (const char* part : {"offset", "scale", "rotation"}) {
            const std::string property = std::string(role.key) + "." + part;
            rows.push_back({of_material, texture + "/extensions/KHR_texture_transform/" + part, property,
                            animated_property(of_material, property)->width, text_or_empty(role.gltf.extension),
                            texture});
        }
    }
}

std::vector<PointerRow> made_rows() {
    std::vector<PointerRow> rows;
    add_materials(rows);
    const auto light = [&](const char* place, const char* property) {
        rows.push_back({of_light, place, property, animated_property(of_light, property)->width, {}, {}});
    };
    light("color", "color"), light("intensity", "intensity"), light("range", "range");
    light("spot/innerConeAngle", "inner_cone"), light("spot/outerConeAngle", "outer_cone");
    const auto camera = [&](Projection of, const char* place, const char* property) {
        rows.push_back({of_camera, place, property, 1, {}, {}, of});
    };
    camera(Projection::perspective, "perspective/yfov", "vertical_fov");
    camera(Projection::perspective, "perspective/aspectRatio", "aspect");
    camera(Projection::perspective, "perspective/znear", "near");
    camera(Projection::perspective, "perspective/zfar", "far");
    camera(Projection::orthographic, "orthographic/xmag", "half_width");
    camera(Projection::orthographic, "orthographic/ymag", "half_height");
    camera(Projection::orthographic, "orthographic/znear", "near");
    camera(Projection::orthographic, "orthographic/zfar", "far");
    return rows;
}

}  // namespace

std::span<const PointerRow> pointer_rows() {
    static const std::vector<PointerRow> rows = made_rows();
    return rows;
}

const PointerRow* row_at(AnimationPath path, std::string_view place) {
    static const auto by_place = [] {
        std::map<std::pair<AnimationPath, std::string_view>, const PointerRow*> map;
        for (const PointerRow& row : pointer_rows()) map[{row.path, row.place}] = &row;
        return map;
    }();
    const auto row = by_place.find({path, place});
    return row == by_place.end() ? nullptr : row->second;
}

const PointerRow* row_of(AnimationPath path, std::string_view property, std::optional<Projection> projection) {
    for (const PointerRow& row : pointer_rows())
        if (row.path == path && row.property == property && (!row.projection || row.projection == projection))
            return &row;
    return nullptr;
}

const char* pointer_prefix(AnimationPath path) {
    return path == of_material ? "/materials/"
           : path == of_camera ? "/cameras/"
                               : "/extensions/KHR_lights_punctual/lights/";
}

}  // namespace rakelight::io::gltf
