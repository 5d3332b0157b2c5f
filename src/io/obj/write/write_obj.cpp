// SPDX-License-Identifier: Apache-2.0
#include "io/obj/write/write_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

#include "base/format_text.h"
#include "io/content_kind.h"
#include "io/files/beside.h"
#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/position_origin.h"
#include "math/color.h"
#include "math/linear.h"
#include "scene/materials/material_table.h"
#include "scene/placed_normal.h"
#include "scene/placement.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;

/// The shortest digits that read back as the same number.
template <class Real>
void put(std::string& out, Real x) {
    std::array<char, 32> digits;
    out += ' ';
    out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
}

/// A name without blanks and control characters, which end words of OBJ.
std::string word(const std::string& name, const std::string& fallback) {
    std::string out = one_line(name, 200);
    for (char& c : out)
        if (static_cast<unsigned char>(c) <= ' ' || c == '#') c = '_';
    return out.empty() ? fallback : out;
}

/// Whether an OBJ file says in its first lines that a library is its own.
bool names_library(const std::string& model, const std::string& library) {
    std::array<char, 4096> head;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        is_regular_file(model) ? std::fopen(model.c_str(), "rb") : nullptr,
        [](std::FILE* f) { return f ? std::fclose(f) : 0; });
    const std::size_t got = file ? std::fread(head.data(), 1, head.size(), file.get()) : 0;
    return std::string_view(head.data(), got).find("mtllib " + library + "\n") != std::string_view::npos;
}

/// NAME.mtl, or NAME.2.mtl, ... where a file of that name is there that does not belong to the model that is replaced.
std::string library_name(const std::string& model) {
    const fs::path folder = fs::path(model).parent_path();
    const std::string stem = fs::path(model).stem().string();
    std::string name = stem + ".mtl";
    std::error_code error;
    for (int n = 2; fs::exists(folder / name, error) && !names_library(model, name); ++n)
        name = format_text("{}.{}.mtl", stem, n);
    return name;
}

std::string material_word(const Scene& scene, std::uint32_t m) {
    return format_text("{}_{}", word(scene.materials[m].name, "material"), m);  // names need not be unique
}

/// The textures that library_text() names.
std::vector<const TextureUse*> written_maps(const Material& m) {
    std::vector<const TextureUse*> maps{&m.base_color_texture, &m.normal_texture, &m.emission_texture};
    if (m.model == MaterialModel::classical) maps.push_back(&m.classical.specular_texture);
    return maps;
}

/// What the textures that library_text() leaves out are for: "metallic roughness, occlusion".
std::string lost_roles(const Scene& scene) {
    std::string names;
    for (const TextureRole& role : texture_roles()) {
        const auto is_lost = [&](const Material& m) {
            const std::vector<const TextureUse*> written = written_maps(m);
            const TextureUse& use = role.in(m);
            return use && role.is_shown_by(m) && std::ranges::find(written, &use) == written.end();
        };
        if (!std::ranges::any_of(scene.materials, is_lost)) continue;
        names += (names.empty() ? "" : ", ") + std::string(role.name);
    }
    std::ranges::replace(names, '_', ' ');
    return names;
}

/// By the content, as readers decide.
std::string picture_ending(std::span<const std::byte> bytes) {
    const std::string_view name = content_kind(bytes).name;
    return name.starts_with("PNG")    ? ".png"
           : name.starts_with("JPEG") ? ".jpg"
           : name.starts_with("WebP") ? ".webp"
                                      : ".img";
}

class ObjWriter {
public:
    ObjWriter(const Scene& scene, const std::string& path, Context& context)
        : scene_(scene), path_(path), context_(context), world_(world_matrices(scene)) {}

    void write() {
        if (triangle_count(scene_) == 0) throw Error(ErrorCode::bad_file, "nothing to write: there is no triangle");
        say_what_is_lost();
        const std::string library = library_name(path_);
        has_floats_ = floats_hold_positions();
        write_embedded();
        const std::string materials = scene_.materials.empty() ? "" : library_text();
        OutputFile model(path_);
        std::string text;
        if (!materials.empty()) text = "mtllib " + library + "\n";
        for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
            bool is_first = true;
            for (const std::uint32_t m : scene_.nodes[n].meshes) {
                if (scene_.meshes[m].triangle_count() == 0) continue;
                context_.throw_if_cancelled();
                if (is_first) text += "o " + word(scene_.nodes[n].name, "object_" + std::to_string(n)) + "\n";
                is_first = false;
                put_mesh(text, scene_.meshes[m], world_[n]);
                model.write(std::as_bytes(std::span(text)));
                text.clear();
            }
        }
        model.finish();
        if (!materials.empty()) {
            OutputFile file((fs::path(path_).parent_path() / library).string());
            file.write(std::as_bytes(std::span(materials)));
            file.commit();
        }
        model.commit();
    }

private:
    void lost(const std::string& what) {
        context_.report().add(Remark::dropped, scene_.source, {}, "OBJ cannot store " + what);
    }

    /// Where they do not, positions are written as doubles.
    bool floats_hold_positions() const {
        dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
        double error = 0;
        for (std::size_t n = 0; n < scene_.nodes.size(); ++n)
            for (const std::uint32_t m : scene_.nodes[n].meshes)
                for (const vec3 p : scene_.meshes[m].positions) {
                    const dvec3 q = transform_point(world_[n], cast<double>(p) + scene_.meshes[m].origin);
                    for (std::size_t k = 0; k < 3; ++k) {
                        low[k] = std::min(low[k], q[k]), high[k] = std::max(high[k], q[k]);
                        error = std::max(error, std::fabs(double(float(q[k])) - q[k]));
                    }
                }
        return position_origin(low, high, error) == dvec3{};
    }

    void say_what_is_lost() {
        bool tangents = false, more_sets = false, others = false, targets = false, numbers = false, opacity = false;
        for (const Mesh& mesh : scene_.meshes) {
            tangents = tangents || !mesh.tangents.empty();
            more_sets = more_sets || mesh.texcoords.size() > 1;
            others = others || mesh.topology != Topology::triangles;
            targets = targets || !mesh.targets.empty();
            numbers = numbers || !mesh.arrays.empty();
            opacity = opacity || std::ranges::any_of(mesh.colors, [](const vec4& c) { return c.w != 1; });
        }
        if (tangents) lost("tangents");
        if (more_sets) lost("more than one set of texture coordinates");
        if (others) lost("lines and points here");
        if (targets) lost("morph targets");
        if (numbers) lost("other vertex attributes");
        if (opacity) lost("the opacity of vertex colors");
        if (!scene_.skins.empty() || !scene_.animations.empty())
            lost("skins and animations: the bind pose was written");
        if (!scene_.cameras.empty() || !scene_.lights.empty()) lost("cameras and lights");
        if (const std::string roles = lost_roles(scene_); !roles.empty()) lost("textures of " + roles);
    }

    void put_mesh(std::string& text, const Mesh& mesh, const dmat4& place) {
        context_.memory().check(mesh.positions.size() * 210 + mesh.triangle_count() * 100, "writing a mesh");
        const bool has_normals = !mesh.normals.empty();
        const bool has_texcoords = !mesh.texcoords.empty() && !mesh.texcoords[0].empty();
        put_vertices(text, mesh, place, has_normals, has_texcoords);
        if (mesh.material != no_index) text += "usemtl " + material_word(scene_, mesh.material) + "\n";
        put_groups(text, mesh);
        const bool has_groups = is_grouped(mesh);
        const bool is_mirrored = determinant(upper_left(place)) < 0;
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            if (has_groups && (t == 0 || mesh.smoothing[t] != mesh.smoothing[t - 1]))
                text += "s " + (mesh.smoothing[t] == 0 ? "off" : std::to_string(mesh.smoothing[t])) + "\n";
            text += 'f';
            for (const std::size_t k :
                 {std::size_t(0), std::size_t(is_mirrored ? 2 : 1), std::size_t(is_mirrored ? 1 : 2)}) {
                const std::uint64_t v = mesh.indices[3 * t + k];
                text += ' ' + std::to_string(positions_ + v + 1);
                if (has_texcoords || has_normals) text += '/';
                if (has_texcoords) text += std::to_string(texcoords_ + v + 1);
                if (has_normals) text += '/' + std::to_string(normals_ + v + 1);
            }
            text += '\n';
        }
        positions_ += mesh.positions.size();
        if (has_normals) normals_ += mesh.positions.size();
        if (has_texcoords) texcoords_ += mesh.positions.size();
    }

    /// Groups say where a mesh without normals is smooth. Masks of one bit each are numbers, too.
    static bool is_grouped(const Mesh& mesh) {
        if (!mesh.normals.empty() || mesh.smoothing.empty()) return false;
        return mesh.smoothing_kind == SmoothingKind::numbers ||
               std::ranges::all_of(mesh.smoothing, [](std::uint32_t mask) { return (mask & (mask - 1)) == 0; });
    }

    /// Without a line `s` a reader may choose how meshes without normals look.
    void put_groups(std::string& text, const Mesh& mesh) {
        if (mesh.normals.empty() && !is_grouped(mesh) && !scene_.missing_normals_are_flat && !has_groups_) return;
        has_groups_ = true;
        if (!is_grouped(mesh)) text += "s off\n";
    }

    void put_vertices(std::string& text, const Mesh& mesh, const dmat4& place, bool has_normals,
                      bool has_texcoords) const {
        const PlacedNormals placed(place);
        const auto line = [&](const char* key, std::initializer_list<float> numbers) {
            text += key;
            for (const float x : numbers) put(text, x);
            text += '\n';
        };
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const dvec3 q = transform_point(place, cast<double>(mesh.positions[v]) + mesh.origin);
            text += 'v';
            for (std::size_t k = 0; k < 3; ++k) has_floats_ ? put(text, float(q[k])) : put(text, q[k]);
            if (!mesh.colors.empty()) put_display(text, mesh.colors[v].xyz());
            text += '\n';
        }
        for (std::size_t v = 0; has_texcoords && v < mesh.positions.size(); ++v)
            line("vt", {mesh.texcoords[0][v].x, 1 - mesh.texcoords[0][v].y});
        for (std::size_t v = 0; has_normals && v < mesh.positions.size(); ++v) {
            const vec3 q = placed(mesh.normals[v]);
            line("vn", {q.x, q.y, q.z});
        }
    }

    static void put_display(std::string& text, vec3 linear) {
        for (const float x : {linear.x, linear.y, linear.z}) put(text, srgb_from_linear(x));
    }
    static void put_color(std::string& text, const char* key, vec3 linear) {
        text += key;
        put_display(text, linear);
        text += '\n';
    }

    void put_map(std::string& text, const char* key, const TextureUse& use) {
        if (!use) return;
        const EncodedImage& image = *scene_.textures[use.texture].image;
        if (image.path.empty()) {
            const auto written = embedded_.find(&image);
            if (written == embedded_.end())
                is_texture_lost_ = true;
            else
                text += std::string(key) + " " + written->second + "\n";
            return;
        }
        std::error_code fault;
        const fs::path from = fs::absolute(fs::path(path_).parent_path(), fault), to = fs::absolute(image.path, fault);
        const fs::path seen = to.lexically_proximate(from);
        text += std::string(key) + " " + one_line(seen.generic_string(), 4000) + "\n";
    }

    /// Textures inside of the model become files beside it, byte by byte.
    void write_embedded() {
        const std::string stem = word(fs::path(path_).stem().string(), "texture");
        for (const Material& material : scene_.materials)
            for (const TextureUse* const use : written_maps(material)) {
                if (!*use) continue;
                const EncodedImage& image = *scene_.textures[use->texture].image;
                if (!image.path.empty() || !image.bytes || embedded_.contains(&image)) continue;
                const std::string first = format_text("{}.{}", stem, use->texture),
                                  ending = picture_ending(*image.bytes);
                std::string name = first + ending;
                for (int n = 2; is_other_file(name, *image.bytes); ++n) name = format_text("{}-{}{}", first, n, ending);
                write_file((folder_of(path_) / name).string(), *image.bytes);
                embedded_[&image] = name;
            }
    }

    /// Whether there is a file of this name that holds something else.
    bool is_other_file(const std::string& name, const std::vector<std::byte>& bytes) {
        const std::string path = (folder_of(path_) / name).string();
        std::error_code error;
        return fs::exists(path, error) && (!is_regular_file(path) || *read_file(path, context_) != bytes);
    }

    std::string library_text() {
        std::string text;
        for (std::uint32_t m = 0; m < scene_.materials.size(); ++m) {
            const Material& material = scene_.materials[m];
            text += "newmtl " + material_word(scene_, m) + "\n";
            put_color(text, "Kd", material.base_color.xyz());
            if (material.base_color.w < 1) text += "d", put(text, material.base_color.w), text += '\n';
            if (!(material.emission == vec3{})) put_color(text, "Ke", material.emission);
            if (material.model == MaterialModel::classical) {
                put_color(text, "Ks", material.classical.specular);
                text += "Ns", put(text, material.classical.shininess), text += "\nillum 2\n";
                put_map(text, "map_Ks", material.classical.specular_texture);
            } else {
                text += "Pr", put(text, material.metallic_roughness.roughness);
                text += "\nPm", put(text, material.metallic_roughness.metallic), text += '\n';
            }
            put_map(text, "map_Kd", material.base_color_texture);
            put_map(text, "norm", material.normal_texture);
            put_map(text, "map_Ke", material.emission_texture);
        }
        if (is_texture_lost_)
            context_.report().add(Remark::dropped, scene_.source, {},
                                  "a texture that is no encoded picture is not written");
        return text;
    }

    const Scene& scene_;
    std::string path_;
    Context& context_;
    std::vector<dmat4> world_;
    std::uint64_t positions_ = 0, normals_ = 0, texcoords_ = 0;
    std::map<const EncodedImage*, std::string> embedded_;  ///< the files that hold them now
    bool is_texture_lost_ = false, has_floats_ = true;
    bool has_groups_ = false;  ///< a line `s` was written
};

}  // namespace

void write_obj(const Scene& scene, const std::string& path, Context& context) {
    ObjWriter(scene, path, context).write();
}

}  // namespace rakelight::io
