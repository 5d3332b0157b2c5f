// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/report.h>
#include <rakelight/tools/bake_files.h>
#include <rakelight_internal/base/text.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

#include <nlohmann/json.hpp>

#include "io/files/made_folders.h"
#include "io/gltf/write/glb_writer.h"
#include "io/pictures/image_io.h"
#include "scene/materials/texture_uses.h"
#include "tools/report_json.h"
#include "world/z_up.h"

#include <rakelight_internal/base/file_ending.h>

namespace rakelight {
namespace {

constexpr std::string_view map_part = "{map}";

std::string name_for(const std::string& output, BakeMap map) {
    std::string name = output;
    for (std::size_t at = name.find(map_part); at != std::string::npos; at = name.find(map_part, at))
        name.replace(at, map_part.size(), name_of(map));
    return name;
}

/// What pictures of that name hold of a map.
Component component_for(const BakeRequest& request, BakeMap map) {
    const std::string& name = request.output;
    const std::string ending = file_ending(name);
    if (ending == "exr") return Component::f32;
    if (ending != "png")
        throw Error(ErrorCode::usage, "'" + one_line(name, 80) + "' cannot store a baked map", {},
                    "name the files 'NAME.{map}.png' or .exr");
    return request.bits == 0 ? component_of(map) : request.bits == 8 ? Component::u8 : Component::u16;
}

void check_braces(const std::string& output) {
    for (std::size_t at = output.find('{'); at != std::string::npos; at = output.find('{', at + 1))
        if (output.compare(at, map_part.size(), map_part) != 0)
            throw Error(ErrorCode::usage, "'" + one_line(output, 80) + "' has an unknown placeholder", {},
                        "{map} stands for the name of each map")
                .about("output");
}

void check(const BakeRequest& request) {
    check_braces(request.output);
    if (request.options.maps.size() > 1 && request.output.find(map_part) == std::string::npos)
        throw Error(ErrorCode::usage, "'" + one_line(request.output, 80) + "' is one name for several maps", {},
                    "{map} stands for the name of each: 'NAME.{map}.png'");
    if (request.bits != 0 && request.bits != 8 && request.bits != 16)
        throw Error(ErrorCode::usage, "must be 8 or 16").about("bits");
    for (const BakeMap map : request.options.maps) {
        (void)component_for(request, map);
        io::check_output_place(name_for(request.output, map));
    }
    if (request.model.empty()) return;
    if (const std::string ending = file_ending(request.model); ending != "glb" && ending != "gltf")
        throw Error(ErrorCode::usage, "'" + one_line(request.model, 80) + "' is not a name for a model with maps", {},
                    "write .glb or .gltf")
            .about("model");
    io::check_output_place(request.model);
}

/// A map in the model: glTF has green up.
TextureUse embedded(Scene& scene, const BakeResult& baked, const BakedMap& map, BakeOptions options, Context& context) {
    options.green_down = false;
    std::vector<std::byte> bytes;
    io::write_image({"map.png", bytes}, picture_of(baked, map, options, Component::u8, context));
    const std::string name = name_of(map.map);
    scene.textures.push_back(
        {name, io::image_from_bytes(name, scene.source,
                                    std::make_shared<const std::vector<std::byte>>(std::move(bytes)), "image/png")});
    TextureUse use;
    use.texture = std::uint32_t(scene.textures.size() - 1);
    return use;
}

/// @param stays_z_up  LOW has Z up and is turned for glTF
void write_model(const BakeRequest& request, const BakeResult& baked, bool stays_z_up, Context& context) {
    Scene scene = baked.low;
    name_default_material(scene);
    for (const BakedMap& map : baked.maps) {
        const bool is_normal = map.map == BakeMap::normal && request.options.space == BakeSpace::tangent;
        if (map.map == BakeMap::normal && !is_normal)
            context.report().add(Remark::dropped, request.model, {},
                                 "the normal map is not in the model: glTF has only tangent-space normal maps");
        if (!is_normal && map.map != BakeMap::occlusion) continue;
        const TextureUse use = embedded(scene, baked, map, request.options, context);
        for (Material& material : scene.materials) {
            if (!is_normal) {
                material.occlusion_texture = use, material.occlusion_strength = 1;
                continue;
            }
            material.normal_texture = use;
            material.normal_scale = 1;
            material.centered_normals = material.green_down = false;
        }
    }
    if (stays_z_up) scene = with_y_up(std::move(scene), request.model, context.report());
    io::write_glb(scene, request.model, context);
}

}  // namespace

BakeFilesResult bake_files(const BakeRequest& request, Context& context) {
    check(request);
    BakeFilesResult result{.high = request.high, .low = request.low, .model = request.model};
    try {
        context.progress("load", 0);
        Scene high = load(request.high, request.load, context);
        context.progress("load", 0.5);
        Scene low = load(request.low, request.load, context);
        const bool stays_z_up = share_up_axis(high, low, context.report()) != UpAxis::y && is_z_up(low.source);
        const BakeResult baked = bake_maps(high, low, request.options, context);
        result.width = baked.width, result.height = baked.height, result.report = baked.report;
        context.progress("write", 0);
        for (const BakedMap& map : baked.maps) {
            context.throw_if_cancelled();
            const std::string name = name_for(request.output, map.map);
            io::write_image({name}, picture_of(baked, map, request.options, component_for(request, map.map), context));
            result.files.push_back({map.map, name});
        }
        if (!request.model.empty()) write_model(request, baked, stays_z_up, context);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.low);
    }
    return result;
}

std::string summary(const BakeFilesResult& result) {
    const BakeReport& r = result.report;
    char text[320];
    std::snprintf(text, sizeof text, "%s of %d x %d pixels, %llu texels in %u charts; cage at %.4g m%s",
                  counted(result.files.size(), "map").c_str(), result.width, result.height,
                  static_cast<unsigned long long>(r.texels), r.charts, r.distance, r.is_proposed ? " (proposed)" : "");
    std::string line = one_line(result.low, 80) + ": " + text;
    for (const BakedFile& file : result.files)
        if (file.map == BakeMap::curvature) {
            std::snprintf(text, sizeof text, "; white curvature is that of a radius of %.4g m", r.curvature_radius);
            line += text;
        }
    if (r.made_coordinates > 0) {
        std::snprintf(text, sizeof text, "; texture coordinates generated, %.4g pixels per meter", r.texels_per_meter);
        line += text;
    }
    return line;
}

std::string to_json(std::span<const BakeRow> rows) {
    Json list = Json::array();
    for (const BakeRow& row : rows) {
        const BakeFilesResult& result = row.result;
        Json json = {{"high", result.high}, {"low", result.low}};
        if (row.error) {
            json["error"] = error_json(*row.error);
        } else {
            const BakeReport& r = result.report;
            Json maps = Json::object();
            for (const BakedFile& file : result.files) maps[name_of(file.map)] = file.file;
            json.update({{"maps", std::move(maps)},
                         {"model", result.model},
                         {"width", result.width},
                         {"height", result.height},
                         {"distance", r.distance},
                         {"distance_is_proposed", r.is_proposed},
                         {"curvature_radius", r.curvature_radius},
                         {"texels", r.texels},
                         {"missed", r.missed},
                         {"beyond_cage", r.beyond},
                         {"charts", r.charts},
                         {"mirrored_charts", r.mirrored},
                         {"overlapping_charts", r.overlapping},
                         {"overlapping_texels", r.overlapping_texels},
                         {"meshes_with_made_coordinates", r.made_coordinates},
                         {"texels_per_meter", r.texels_per_meter}});
        }
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.bake/1", std::move(list));
}

}  // namespace rakelight
