// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/format_text.h"
#include "io/gltf/container.h"
#include "scene/materials/material_table.h"

namespace rakelight::io::gltf {
namespace {

/// Extensions whose data is read, beside those of the material table. A file that requires another one is refused, unless
/// that is visual.
constexpr std::array supported = std::to_array<std::string_view>(
    {"EXT_mesh_gpu_instancing", "EXT_meshopt_compression", "EXT_texture_webp", "KHR_animation_pointer",
     "KHR_draco_mesh_compression", "KHR_lights_punctual", "KHR_materials_emissive_strength",
     "KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_meshopt_compression",
     "KHR_texture_transform"});

/// Extensions that change nothing about the picture (metadata, alternatives to choose from): leaving them out is right.
constexpr std::array harmless =
    std::to_array<std::string_view>({"KHR_materials_variants", "KHR_xmp", "KHR_xmp_json_ld", "EXT_structural_metadata",
                                     "EXT_mesh_features", "AGI_articulations"});

/// What names say behind their vendor: extensions of how things look or move. Without them there is a picture, which lacks
/// something; without those of data (compression, geometry) there is none.
constexpr std::array visual =
    std::to_array<std::string_view>({"materials_", "lights_", "texture_", "environment", "animation_", "node_",
                                     "camera_", "audio", "interactivity", "xmp"});

bool is_visual(std::string_view name) {
    const std::size_t vendor = name.find('_');
    if (vendor == std::string_view::npos) return false;
    const std::string_view word = name.substr(vendor + 1);
    return std::any_of(visual.begin(), visual.end(), [word](std::string_view v) { return word.starts_with(v); });
}

template <class List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_supported(std::string_view name) {
    const auto is_its_place = [name](const auto& row) { return row.gltf.extension && row.gltf.extension == name; };
    const auto roles = texture_roles();
    const auto parameters = metallic_roughness_parameters();
    return contains(supported, name) || std::any_of(roles.begin(), roles.end(), is_its_place) ||
           std::any_of(parameters.begin(), parameters.end(), is_its_place);
}

}  // namespace

Document::Document(const std::string& path, Bytes file, const ReadOptions& options, Context& context)
    : path_(path),
      options_(options),
      context_(context),
      file_(std::move(file)),
      scene_charge_(context.memory()),
      tree_charge_(context.memory()) {
    const Container parts = open_container(*file_, path, context);
    binary_ = parts.binary;
    has_binary_ = parts.has_binary;
    tree_ = std::make_shared<const Json>(parse_json(parts.json, path, tree_charge_, context));
    if (!tree_->is_object()) throw Error(ErrorCode::bad_file, "not a glTF file: its JSON is not an object");
    root_ = Value(tree_.get(), {});
    check_version();
    check_extensions();
}

Value Document::element_of(const Value& owner, Kind kind, std::uint32_t index, const Value& from) const {
    const Value list = owner.list(kind.list);
    if (index >= list.size())
        from.fail(format_text("{} {} does not exist (the file has {})", kind.word, index, list.size()));
    std::string place = format_text("{} {}", kind.word, index);
    const Value element = list.element(index, place);
    const std::string* name = element.has("name") ? element.text_pointer("name") : nullptr;
    if (!name || name->empty()) return element;
    return list.element(index, place + " '" + one_line(*name, 60) + "'");
}

std::string Document::name_of(const Value& element, Kind kind, std::uint32_t index) {
    std::string name = element.text("name");
    return name.empty() ? format_text("{} {}", kind.word, index) : name;
}

void Document::remark(Remark kind, const std::string& place, std::string message) const {
    context_.report().add(kind, path_, one_line(place, 120), one_line(message, 400));
}

void Document::check_version() const {
    const Value asset = root_.object("asset");
    if (!asset) throw Error(ErrorCode::bad_file, "not a glTF 2.0 file: asset is missing");
    const std::string version = asset.text("version"), least = asset.text("minVersion", "2.0");
    if (version.substr(0, 2) != "2." || version.size() < 3)
        throw Error(ErrorCode::bad_file, "glTF version '" + one_line(version, 20) + "' is not supported, only 2.0",
                    "asset");
    if (least != "2.0")
        throw Error(ErrorCode::bad_file,
                    "the file asks for glTF version '" + one_line(least, 20) + "', only 2.0 is supported", "asset");
}

void Document::check_extensions() {
    std::vector<std::string> without;  // of those that are required
    const Value required = root_.list("extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string name = required.text_at(i);
        if (is_supported(name) || contains(harmless, name)) continue;
        const std::string what =
            "the file requires the glTF extension " + one_line(name, 80) + ", which is not supported";
        if (!is_visual(name)) throw Error(ErrorCode::bad_file, what);
        remark(Remark::warning, {}, what + ": pictures lack its effect");
        without.push_back(name);
    }
    const Value used = root_.list("extensionsUsed");
    for (std::size_t i = 0; i < used.size(); ++i) {
        const std::string name = used.text_at(i);
        uses_quantization_ = uses_quantization_ || name == "KHR_mesh_quantization";
        if (is_supported(name) || contains(without, name)) continue;
        remark(contains(harmless, name) ? Remark::note : Remark::dropped, {},
               "the glTF extension " + one_line(name, 80) + " is not supported; it is ignored");
    }
}

}  // namespace rakelight::io::gltf
