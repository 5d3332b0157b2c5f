// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl_materials.h"

#include <rakelight/base/report.h>
#include <rakelight_internal/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/file.h"
#include "io/files/plain_text.h"
#include "io/obj/obj_lines.h"
#include "io/pictures/image_io.h"
#include "math/color.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::io::obj {
namespace {

constexpr std::uint64_t most_remarks = 200;  // of one model about names that are not found
constexpr std::size_t most_libraries = 256;

std::string_view text_of(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes->data()), bytes->size()}; }

/// A display color as linear light; components outside 0..1 are clamped and remarked on.
vec3 linear_color(vec3 display, std::uint64_t line, Remarks& remarks) {
    vec3 clamped;
    for (std::size_t i = 0; i < 3; ++i) clamped[i] = std::clamp(display[i], 0.0f, 1.0f);
    if (!(clamped == display)) remarks.add(Issue::mtl_range, line);
    return linear_from_srgb(clamped);
}

vec3 linear_emission(vec3 display, std::uint64_t line, Remarks& remarks) {
    const float strength = std::max({1.0f, display.x, display.y, display.z});
    const vec3 c = linear_color({display.x / strength, display.y / strength, display.z / strength}, line, remarks);
    return {c.x * strength, c.y * strength, c.z * strength};
}

float unit_value(double value, std::uint64_t line, Remarks& remarks) {
    if (value < 0 || value > 1) remarks.add(Issue::mtl_range, line);
    return float(std::clamp(value, 0.0, 1.0));
}

Material default_material(const std::string& name) {
    Material m;
    m.name = name;
    m.model = MaterialModel::classical;
    const vec3 gray = linear_from_srgb(vec3{0.8f, 0.8f, 0.8f});
    m.base_color = {gray.x, gray.y, gray.z, 1};
    m.classical.ambient = gray;
    return m;
}

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

bool is_normal_map_name(const std::string& file) {
    std::string stem = lower_case(ReferenceFinder::bare_name(file));
    if (const std::size_t dot = stem.rfind('.'); dot != std::string::npos && dot > 0) stem.resize(dot);
    if (stem.find("normal") != std::string::npos || stem.find("nrm") != std::string::npos) return true;
    for (std::size_t i = 0; i < stem.size();) {
        std::size_t end = i;
        while (end < stem.size() && is_letter(stem[end])) ++end;
        const std::string word = stem.substr(i, end - i);
        for (const char* known : {"n", "nm", "nor", "norm", "nrml"})
            if (word == known && word.size() < stem.size()) return true;
        i = end + 1;
    }
    return false;
}

void MaterialLibrary::remark(Remark kind, const std::string& file, std::uint64_t line, std::string message) {
    if (remarks_made_++ >= most_remarks) return;
    std::vector<std::string> settings;
    if (message.find("'allow-outside'") != message.npos) settings.emplace_back("allow-outside");
    context_.report().add(kind, file, line ? "line " + std::to_string(line) : std::string(), std::move(message),
                          std::move(settings));
}

void MaterialLibrary::finish() {
    if (remarks_made_ > most_remarks)
        context_.report().add(
            Remark::warning, model_path_, {},
            std::to_string(remarks_made_ - most_remarks) + " more remarks about materials and textures");
    scene_.charges.push_back(share(std::move(charge_)));
}

void MaterialLibrary::load(const std::string& argument) {
    if (loaded_.size() >= most_libraries)
        return remark(Remark::warning, model_path_, 0, "more than 256 material files; the rest is left out");
    const bool is_one = finder_.find(argument).has_value();
    std::vector<std::string> names;
    Tokens words(argument, 0, is_one ? 0 : argument.size());
    for (Token word; words.next(word);) names.emplace_back(word.text);
    // Several files only if one of them is there: a missing "my materials.mtl" is one warning, not two.
    const bool are_several =
        std::any_of(names.begin(), names.end(), [&](const auto& n) { return finder_.find(n).has_value(); });
    if (!are_several) names = {argument};
    for (const std::string& name : names)
        if (loaded_.size() < most_libraries && !load_file(name))
            remark(Remark::warning, model_path_, 0,
                   "material file '" + one_line(name, 160) + "'" +
                       why_not_found(model_path_, name, "default materials are used instead"));
}

bool MaterialLibrary::load_file(const std::string& reference) {
    const auto found = finder_.find(reference);
    if (!found) return false;
    if (!loaded_.insert(found->path).second) return true;
    if (found->is_guessed)
        remark(Remark::guessed, model_path_, 0,
               "material file '" + one_line(ReferenceFinder::bare_name(reference), 80) + "' was found as '" +
                   one_line(ReferenceFinder::bare_name(found->path), 80) + "'");
    Bytes bytes;
    try {
        bytes = read_file(found->path, context_);
    } catch (const Error& e) {
        remark(Remark::warning, model_path_, 0, std::string("material file left out: ") + e.reason());
        return true;
    }
    Remarks remarks(found->path);
    const File file{finder_.folder_of(found->path), found->path};
    const PlainText text(text_of(bytes), found->path, context_);
    for (const MtlMaterial& m : read_mtl(text.view(), remarks, context_)) add(m, file, remarks);
    remarks.flush(context_.report());
    return true;
}

std::uint32_t MaterialLibrary::find(const std::string& name, std::uint64_t line) {
    const auto [entry, is_new] = by_name_.try_emplace(name, std::uint32_t(scene_.materials.size()));
    if (!is_new) return entry->second;
    charge_.grow(sizeof(Material) + name.size(), "the materials of an OBJ file");
    scene_.materials.push_back(default_material(name.empty() ? "default" : name));
    have_invented_color_.push_back(true);
    if (!name.empty())
        remark(Remark::warning, model_path_, line,
               "material '" + one_line(name, 80) + "' is not defined; a light gray one is used instead");
    return entry->second;
}

void MaterialLibrary::add(const MtlMaterial& source, const File& file, Remarks& remarks) {
    if (!by_name_.emplace(source.name, std::uint32_t(scene_.materials.size())).second)
        return remarks.add(Issue::mtl_redefined, source.line);
    charge_.grow(sizeof(Material) + source.name.size(), "the materials of an MTL file");
    Material m = default_material(source.name);
    m.base_color_texture = use(source.map("map_kd"), file);
    m.emission_texture = use(source.map("map_ke"), file);
    m.classical.specular_texture = use(source.map("map_ks"), file);
    set_colors(m, source, remarks);
    set_emission(m, source, file, remarks);
    const MtlMap *ambient = source.map("map_ka"), *diffuse = source.map("map_kd");
    if (ambient && !(diffuse && diffuse->file == ambient->file)) remarks.add(Issue::mtl_unsupported_map, ambient->line);
    set_alpha(m, source, file, remarks);
    set_rays(m, source, remarks);
    set_relief(m, source, file);
    if (source.roughness || source.metallic || source.map("map_pr") || source.map("map_pm"))
        set_metallic_roughness(m, source, file, remarks);
    else if (source.illumination == 0)
        m.model = MaterialModel::unlit;
    have_invented_color_.push_back(!source.diffuse && !m.base_color_texture);
    scene_.materials.push_back(std::move(m));
}

void MaterialLibrary::set_colors(Material& m, const MtlMaterial& source, Remarks& remarks) const {
    if (source.diffuse) {
        const vec3 kd = linear_color(*source.diffuse, source.line, remarks);
        m.base_color = {kd.x, kd.y, kd.z, 1};
    } else if (m.base_color_texture) {
        m.base_color = {1, 1, 1, 1};
    }
    m.classical.ambient = source.ambient ? linear_color(*source.ambient, source.line, remarks) : m.base_color.xyz();
    const bool has_specular = source.illumination != 0 && source.illumination != 1;
    if (source.specular && has_specular)
        m.classical.specular = linear_color(*source.specular, source.line, remarks);
    else if (m.classical.specular_texture && has_specular)
        m.classical.specular = {1, 1, 1};
    if (source.exponent) {
        m.classical.shininess = std::max(1.0f, float(*source.exponent));
        if (!(*source.exponent >= 1) && !(m.classical.specular == vec3{})) {
            // Exporters write Ns 0 for "no highlight" beside a white Ks; to the letter it would wash the surface out.
            m.classical.specular = {};
            remarks.add(Issue::mtl_exponent, source.line);
        }
    }
}

void MaterialLibrary::set_emission(Material& m, const MtlMaterial& source, const File& file, Remarks& remarks) {
    if (source.emission) m.emission = linear_emission(*source.emission, source.line, remarks);
    const MtlMap* map = source.map("map_ke");
    if (!map) return;
    if (!m.emission_texture) return drop_emission(m, context_.report(), file.name, "line " + std::to_string(map->line));
    if (!(m.emission == vec3{})) return;
    m.emission = {1, 1, 1};  // exporters write Ke 0 beside map_Ke
    if (source.emission) remark(Remark::guessed, file.name, map->line, "Ke 0 beside map_Ke was read as Ke 1");
}

void MaterialLibrary::set_alpha(Material& m, const MtlMaterial& source, const File& file, Remarks& remarks) {
    float alpha = 1;
    if (source.dissolve) {
        alpha = unit_value(*source.dissolve, source.line, remarks);
    } else if (source.transparency && *source.transparency != 1) {
        alpha = 1 - unit_value(*source.transparency, source.line, remarks);
    } else if (source.transparency) {
        remark(Remark::guessed, file.name, source.line, "Tr 1 without d would hide the object; it was read as opaque");
    }
    m.base_color.w = alpha;
    const MtlMap *opacity = source.map("map_d"), *color = source.map("map_kd");
    if (opacity && color && opacity->file == color->file && m.base_color_texture) {
        remark(Remark::guessed, file.name, opacity->line, "map_d names the file of map_Kd: its alpha is the opacity");
        m.alpha_mode = AlphaMode::blend;
    } else {
        m.opacity_texture = use(opacity, file);
    }
    if (alpha < 1 || m.opacity_texture) m.alpha_mode = AlphaMode::blend;
}

void MaterialLibrary::set_rays(Material& m, const MtlMaterial& source, Remarks& remarks) {
    const std::int64_t illumination = source.illumination.value_or(2);
    if (illumination < 3 || illumination > 7) return;
    if (source.ior && *source.ior < 0) remarks.add(Issue::mtl_number, source.line);
    ClassicalParameters& c = m.classical;
    c.mirror = illumination == 5 || illumination == 7 ? Mirror::fresnel : Mirror::constant;
    if (illumination == 3 || illumination == 5) return;
    if (source.filter)
        c.transmission = linear_color(*source.filter, source.line, remarks);
    else if (m.alpha_mode == AlphaMode::blend)
        c.transmission = {1, 1, 1};
    if (illumination != 4 && source.ior && *source.ior > 0)
        c.refraction_index = float(std::clamp(*source.ior, 0.1, 100.0));
}

void MaterialLibrary::set_relief(Material& m, const MtlMaterial& source, const File& file) {
    const MtlMap *normal = source.map("norm"), *bump = source.map("map_bump"), *displacement = source.map("disp");
    if (bump && is_normal_map_name(bump->file)) {
        if (!normal) {
            normal = bump;
            remark(
                Remark::guessed, file.name, bump->line,
                "map_Bump '" + one_line(ReferenceFinder::bare_name(bump->file), 80) + "' is a normal map by its name");
        }
        bump = nullptr;
    }
    m.normal_texture = use(normal, file);
    if (normal) m.normal_scale = float(normal->bump_multiplier.value_or(1));
    const MtlMap* height = bump ? bump : displacement;
    m.height_texture = use(height, file);
    if (height) m.height_scale = float(height->bump_multiplier.value_or(height->gain.value_or(1)));
    if (bump && displacement && bump->file != displacement->file)
        remark(Remark::dropped, file.name, displacement->line, "disp is left out: the material has a bump map already");
    for (float* scale : {&m.normal_scale, &m.height_scale})
        if (!std::isfinite(*scale)) *scale = 1;
}

void MaterialLibrary::set_metallic_roughness(Material& m, const MtlMaterial& source, const File& file,
                                             Remarks& remarks) {
    m.model = MaterialModel::metallic_roughness;
    MetallicRoughnessParameters& p = m.metallic_roughness;
    const MtlMap *rough = source.map("map_pr"), *metal = source.map("map_pm");
    const bool is_packed = rough && metal && rough->file == metal->file;
    p.texture = use(rough, file);
    p.metallic = unit_value(source.metallic.value_or(p.texture && is_packed ? 1 : 0), source.line, remarks);
    const double from_exponent = source.exponent ? roughness_of_exponent(std::max(0.0, *source.exponent)) : 1;
    p.roughness = unit_value(source.roughness.value_or(p.texture ? 1 : from_exponent), source.line, remarks);
    if (source.ior && *source.ior >= 1) p.ior = float(std::min(*source.ior, 100.0));
    if (source.anisotropy) p.anisotropy = unit_value(*source.anisotropy, source.line, remarks);
    if (source.anisotropy_rotation)
        p.anisotropy_rotation_rad = float(2 * pi) * unit_value(*source.anisotropy_rotation, source.line, remarks);
    if (metal && !is_packed)
        remark(Remark::dropped, file.name, metal->line, "map_Pm is left out: it is not the file of map_Pr");
    if (p.texture && !is_packed && p.metallic > 0)
        remark(Remark::changed, file.name, rough->line, "map_Pr also scales the metalness (its blue channel)");
}

TextureUse MaterialLibrary::use(const MtlMap* map, const File& file) {
    TextureUse result;
    if (!map) return result;
    const auto found = finder_.find(map->file, file.folder);
    const std::string name = one_line(ReferenceFinder::bare_name(map->file), 80);
    if (!found) {
        if (missing_.insert(map->file).second)
            remark(
                Remark::warning, file.name, map->line,
                "texture '" + one_line(map->file, 160) + "'" + why_not_found(model_path_, map->file, "it is left out"));
        return result;
    }
    ImageHandle& image = images_[found->path];
    if (!image) {
        image = image_from_file(name, model_path_, found->path);
        if (found->is_guessed)
            remark(
                Remark::guessed, file.name, map->line,
                "texture '" + name + "' was found as '" + one_line(ReferenceFinder::bare_name(found->path), 80) + "'");
    }
    const auto [entry, is_new] =
        textures_.try_emplace({found->path, map->is_clamped}, std::uint32_t(scene_.textures.size()));
    if (is_new) {
        Sampler sampler;
        if (map->is_clamped) sampler.wrap_u = sampler.wrap_v = Wrap::clamp_to_edge;
        scene_.textures.push_back({name, image, sampler});
    }
    result.texture = entry->second;
    result.transform.scale = map->scale;
    // v up in the file, v = 1 - v here: 1 - (s (1 - v) + o) = s v + (1 - s - o).
    const float v = 1 - map->scale.y - map->offset.y;
    result.transform.offset = {map->offset.x, std::isfinite(v) ? v : 0};
    return result;
}

}  // namespace rakelight::io::obj
