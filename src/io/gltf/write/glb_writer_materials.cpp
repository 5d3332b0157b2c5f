// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/glb_writer_materials.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "math/functions.h"
#include "math/linear.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/material_table.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::io::gltf {
namespace {

OrderedJson json_of(vec2 v) { return {v.x, v.y}; }
OrderedJson json_of(vec3 v) { return {v.x, v.y, v.z}; }
OrderedJson json_of(vec4 v) { return {v.x, v.y, v.z, v.w}; }

int wrap_code(Wrap wrap) { return wrap == Wrap::repeat ? 10497 : wrap == Wrap::mirrored_repeat ? 33648 : 33071; }

int minify_code(const Sampler& s) {
    const int linear = s.minify == Filter::linear;
    return s.mip == MipFilter::none ? 9728 + linear : (s.mip == MipFilter::nearest ? 9984 : 9986) + linear;
}

/// A picture that exists only as pixels. @throws Error bad_file: PNG cannot hold it
Bytes png_of(const EncodedImage& image, Context& context) {
    if (!image.decode) throw Error(ErrorCode::bad_file, "it contains no picture");
    const Pixels pixels = image.decode(image, context);
    if (pixels.component == Component::f32)
        throw Error(ErrorCode::bad_file, "glTF cannot store pictures of 32-bit floats");
    std::vector<std::byte> bytes;
    write_image({"texture.png", bytes}, pixels);
    return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

/// By the first bytes, not by the name: "image/png", "image/jpeg", "image/webp", or empty.
const char* mime_type_of(const std::vector<std::byte>& bytes) {
    const auto begins = [&](std::size_t at, std::string_view with) {
        return bytes.size() >= at + with.size() &&
               std::equal(with.begin(), with.end(), bytes.begin() + std::ptrdiff_t(at),
                          [](char c, std::byte b) { return std::byte(c) == b; });
    };
    if (begins(0, "\x89PNG")) return "image/png";
    if (begins(0, "\xFF\xD8\xFF")) return "image/jpeg";
    if (begins(0, "RIFF") && begins(8, "WEBP")) return "image/webp";
    return "";
}

vec3 clamped(vec3 v) { return min(max(v, vec3{0, 0, 0}), vec3{1, 1, 1}); }

vec4 clamped(vec4 v) {
    const vec3 c = clamped(v.xyz());
    return {c.x, c.y, c.z, std::clamp(v.w, 0.0f, 1.0f)};
}

}  // namespace

void MaterialWriter::used(const char* extension) {
    if (std::find(extensions_.begin(), extensions_.end(), extension) == extensions_.end())
        extensions_.push_back(extension);
}

void MaterialWriter::lost(const std::string& place, const std::string& what) {
    context_.report().add(Remark::dropped, scene_.source, place, what);
}

void MaterialWriter::extension(OrderedJson& material, const char* name, OrderedJson value) {
    material["extensions"][name] = std::move(value);
    used(name);
}

std::uint32_t MaterialWriter::sampler(const Sampler& s) {
    OrderedJson json = {{"magFilter", s.magnify == Filter::linear ? 9729 : 9728},
                        {"minFilter", minify_code(s)},
                        {"wrapS", wrap_code(s.wrap_u)},
                        {"wrapT", wrap_code(s.wrap_v)}};
    const auto [entry, is_new] = samplers_.try_emplace(json.dump(), std::uint32_t(samplers_.size()));
    if (is_new) root_["samplers"].push_back(std::move(json));
    return entry->second;
}

std::uint32_t MaterialWriter::image(const EncodedImage& image, bool& is_webp) {
    if (const auto known = images_.find(&image); known != images_.end()) {
        is_webp = known->second.second;
        return known->second.first;
    }
    auto& entry = images_[&image] = {no_index, false};
    Bytes bytes = image.bytes;
    try {
        if (!bytes) bytes = image.path.empty() ? png_of(image, context_) : read_file(image.path, context_);
    } catch (const Error& error) {
        lost("image '" + one_line(image.name, 80) + "'", "a texture is left out: " + error.reason());
        return no_index;
    }
    const std::string type = mime_type_of(*bytes);
    if (type.empty()) {
        lost("image '" + one_line(image.name, 80) + "'",
             "a texture is left out: glTF can store PNG, JPEG and WebP only, and pictures are not converted here");
        return no_index;
    }
    while (binary_->size() % 4 != 0) binary_->push_back(std::byte{0});
    const std::size_t view = root_["bufferViews"].size();
    root_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_->size()}, {"byteLength", bytes->size()}});
    binary_->insert(binary_->end(), bytes->begin(), bytes->end());
    entry = {std::uint32_t(root_["images"].size()), type == "image/webp"};
    root_["images"].push_back({{"name", one_line(image.name)}, {"bufferView", view}, {"mimeType", type}});
    is_webp = entry.second;
    return entry.first;
}

std::uint32_t MaterialWriter::texture(std::uint32_t number) {
    if (const auto known = textures_.find(number); known != textures_.end()) return known->second;
    const Texture& source = scene_.textures[number];
    bool is_webp = false;
    const std::uint32_t picture = image(*source.image, is_webp);
    if (picture == no_index) return textures_[number] = no_index;
    OrderedJson json = {{"sampler", sampler(source.sampler)}};
    if (is_webp)
        extension(json, "EXT_texture_webp", {{"source", picture}});
    else
        json["source"] = picture;
    const auto written = std::uint32_t(root_["textures"].size());
    root_["textures"].push_back(std::move(json));
    return textures_[number] = written;
}

bool MaterialWriter::set_use(OrderedJson& owner, const char* name, const TextureUse& use) {
    if (!use) return false;
    const std::uint32_t number = texture(use.texture);
    if (number == no_index) return false;
    OrderedJson json = {{"index", number}};
    if (use.texcoord_set != 0) json["texCoord"] = use.texcoord_set;
    const TextureTransform& t = use.transform;
    if (!(t == TextureTransform{}))
        extension(json, "KHR_texture_transform",
                  {{"offset", json_of(t.offset)}, {"rotation", t.rotation_rad}, {"scale", json_of(t.scale)}});
    owner[name] = std::move(json);
    return true;
}

/// Numbers that are not the default, and textures; nothing of a layer that does not exist and that no clip brings.
OrderedJson MaterialWriter::extension_of(const char* name, const Material& m, bool is_moved) {
    static const MetallicRoughnessParameters defaults;
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    const auto is_this = [name](const GltfPlace& place) {
        return place.extension && !std::strcmp(place.extension, name);
    };
    OrderedJson object = OrderedJson::object();
    for (const MaterialParameter& parameter : metallic_roughness_parameters()) {
        if (!is_this(parameter.gltf)) continue;
        if (parameter.color && !(p.*parameter.color == defaults.*parameter.color))
            object[parameter.gltf.name] = json_of(p.*parameter.color);
        if (parameter.number && p.*parameter.number != defaults.*parameter.number)
            object[parameter.gltf.name] = p.*parameter.number;
    }
    for (const TextureRole& role : texture_roles()) {
        if (!is_this(role.gltf)) continue;
        if (!is_moved && role.layer.silences(m)) return OrderedJson::object();
        if (set_use(object, role.gltf.name, role.in(m)) && role.number == role_clearcoat_normal)
            object[role.gltf.name]["scale"] = p.clearcoat_normal_scale;
    }
    return object;
}

void MaterialWriter::extensions(OrderedJson& json, const Material& m, bool is_moved) {
    std::vector<std::string_view> done;
    for (const MaterialParameter& parameter : metallic_roughness_parameters()) {
        const char* const name = parameter.gltf.extension;
        if (!name || std::find(done.begin(), done.end(), name) != done.end()) continue;
        done.emplace_back(name);
        if (OrderedJson object = extension_of(name, m, is_moved); !object.empty())
            extension(json, name, std::move(object));
    }
}

OrderedJson MaterialWriter::material(const Material& source, std::size_t number) {
    const std::string place = format_text("material {} '{}'", number, one_line(source.name, 60));
    const bool is_classical = source.model == MaterialModel::classical;
    Material m = is_classical ? metallic_roughness_from_classical(source) : source;
    if (is_classical)
        context_.report().add(Remark::changed, scene_.source, place,
                              "a classical material was converted to metallic-roughness, with the same highlight");
    if (m.height_texture) lost(place, "glTF cannot store a height map");
    if (m.opacity_texture) lost(place, "glTF cannot store a separate opacity map");
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    OrderedJson json = OrderedJson::object();
    if (!m.name.empty()) json["name"] = one_line(m.name);
    OrderedJson& pbr = json["pbrMetallicRoughness"];
    pbr = {{"baseColorFactor", json_of(clamped(m.base_color))},
           {"metallicFactor", p.metallic},
           {"roughnessFactor", p.roughness}};
    set_use(pbr, "baseColorTexture", m.base_color_texture);
    set_use(pbr, "metallicRoughnessTexture", p.texture);
    if (set_use(json, "normalTexture", m.normal_texture) && m.normal_scale != 1)
        json["normalTexture"]["scale"] = m.normal_scale;
    if (set_use(json, "occlusionTexture", m.occlusion_texture))
        json["occlusionTexture"]["strength"] = m.occlusion_strength;
    if (m.emission_texture && !set_use(json, "emissiveTexture", m.emission_texture))
        drop_emission(m, context_.report(), scene_.source, place);
    const float strength = moved_.emission_strength(number);
    const bool is_dark = m.emission == vec3{0, 0, 0};
    if (strength > 1 && !(is_dark && !moved_.is_moved(number))) {
        json["emissiveFactor"] = json_of(clamped(m.emission / strength));
        extension(json, "KHR_materials_emissive_strength", {{"emissiveStrength", strength}});
    } else if (!is_dark) {
        json["emissiveFactor"] = json_of(clamped(m.emission));
    }
    if (m.alpha_mode == AlphaMode::mask) json["alphaMode"] = "MASK", json["alphaCutoff"] = m.alpha_cutoff;
    if (m.alpha_mode == AlphaMode::blend) json["alphaMode"] = "BLEND";
    if (m.double_sided) json["doubleSided"] = true;
    if (m.model == MaterialModel::unlit)
        extension(json, "KHR_materials_unlit", OrderedJson::object());
    else
        extensions(json, m, moved_.is_moved(number));
    return json;
}

void MaterialWriter::write(std::vector<std::byte>& binary) {
    binary_ = &binary;
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
        context_.throw_if_cancelled();
        OrderedJson json = material(scene_.materials[i], i);
        root_["materials"].push_back(std::move(json));
    }
}

OrderedJson camera_json(const Camera& camera) {
    OrderedJson json = OrderedJson::object();
    if (!camera.name.empty()) json["name"] = one_line(camera.name);
    if (camera.projection == Projection::perspective) {
        json["type"] = "perspective";
        // glTF cannot store only a width: that of a square picture then
        const double up_rad =
            camera.vertical_fov_rad > 0 ? camera.vertical_fov_rad : camera.horizontal_fov_rad.value_or(0);
        OrderedJson& p = json["perspective"] = {{"yfov", up_rad}, {"znear", camera.z_near}};
        if (camera.horizontal_fov_rad)
            p["aspectRatio"] = math::tan(0.5 * *camera.horizontal_fov_rad) / math::tan(0.5 * up_rad);
        else if (camera.aspect)
            p["aspectRatio"] = *camera.aspect;
        if (std::isfinite(camera.z_far)) p["zfar"] = camera.z_far;
    } else {
        json["type"] = "orthographic";
        const double near = std::max(0.0, camera.z_near), far = std::isfinite(camera.z_far) ? camera.z_far : near + 1e6;
        json["orthographic"] = {{"xmag", camera.half_width.value_or(camera.half_height * camera.aspect.value_or(1))},
                                {"ymag", camera.half_height},
                                {"zfar", far},
                                {"znear", near}};
    }
    return json;
}

OrderedJson light_json(const Light& light) {
    const bool is_photometric = light.units == LightUnits::photometric;
    const float brightest = std::max({light.diffuse.x, light.diffuse.y, light.diffuse.z, 0.0f});
    const vec3 color = is_photometric ? light.color : brightest > 0 ? light.diffuse / brightest : vec3{1, 1, 1};
    float intensity = is_photometric ? light.intensity : float(pi) * brightest;
    if (!is_photometric && light.type != LightType::directional && light.quadratic > 0) intensity /= light.quadratic;
    OrderedJson json = OrderedJson::object();
    if (!light.name.empty()) json["name"] = one_line(light.name);
    json["type"] = light.type == LightType::directional ? "directional"
                   : light.type == LightType::spot      ? "spot"
                                                        : "point";
    json["color"] = json_of(color);
    json["intensity"] = intensity;
    if (is_photometric && std::isfinite(light.range) && light.type != LightType::directional)
        json["range"] = light.range;
    if (light.type == LightType::spot) {
        const float outer = std::min(is_photometric ? light.outer_cone_rad : light.cutoff_rad, float(pi / 2));
        json["spot"] = {{"innerConeAngle", is_photometric ? light.inner_cone_rad : 0.0f}, {"outerConeAngle", outer}};
    }
    return json;
}

}  // namespace rakelight::io::gltf
