// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>

#include "io/import/scene_from_import.h"
#include "io/import/texture_finder.h"
#include "io/import/texture_placement.h"
#include "math/color.h"
#include "math/linear.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::io {
namespace {

using import_stream::Import;
using import_stream::Role;
using import_stream::Surface;
using import_stream::TextureLink;

constexpr float largest_shininess = 10000;

/// Display values to linear; those above 1 (emission, lights) keep their ratio.
vec3 linear_color(vec3 c) {
    if (!is_finite(c)) return {0, 0, 0};
    const float peak = std::max({c.x, c.y, c.z, 1.0f});
    return linear_from_srgb(c / peak) * peak;
}

/// Formats whose triangles say nothing of sides (or say that both show).
bool shows_both_sides(const std::string& ending) { return ending != "3ds"; }

bool is_black(vec3 c) { return c.x == 0 && c.y == 0 && c.z == 0; }

const TextureLink* link_of(const Surface& s, Role role) {
    const auto found = std::find_if(s.links.begin(), s.links.end(),
                                    [role](const TextureLink& l) { return l.role == std::uint32_t(role); });
    return found == s.links.end() ? nullptr : &*found;
}

class MaterialMaker {
public:
    MaterialMaker(Import& import, const std::string& path, const std::string& ending, bool allow_outside, Scene& scene,
                  Context& context)
        : path_(path),
          ending_(ending),
          scene_(scene),
          report_(context.report()),
          textures_(path, allow_outside, import.document.pictures, scene, context) {}

    Material make(const Surface& s, std::uint32_t number) {
        number_ = number;
        Material m;
        m.name = s.name;
        m.model = s.unlit != 0 ? MaterialModel::unlit : MaterialModel::classical;
        m.double_sided = s.two_sided != 0 || shows_both_sides(ending_);
        set_textures(s, m);
        set_colors(s, m);
        set_opacity(s, m);
        return m;
    }

private:
    void set_textures(const Surface& s, Material& m) {
        m.base_color_texture = use(s, Role::diffuse);
        m.classical.specular_texture = use(s, Role::specular);
        m.normal_texture = use(s, Role::normal);
        m.height_texture = use(s, Role::height);
        m.emission_texture = use(s, Role::emission);
        m.occlusion_texture = use(s, Role::occlusion);
        if (m.normal_texture && std::isfinite(s.bump_scale)) m.normal_scale = s.bump_scale;
        if (m.height_texture && std::isfinite(s.bump_scale)) m.height_scale = s.bump_scale;
    }

    /// A texture replaces the diffuse color in all these formats but X, where it multiplies it.
    void set_colors(const Surface& s, Material& m) {
        const bool replaced = m.base_color_texture && ending_ != "x";
        const vec3 diffuse = !replaced && (s.has & Surface::has_diffuse) ? linear_color(s.diffuse) : vec3{1, 1, 1};
        m.base_color = {diffuse.x, diffuse.y, diffuse.z, 1};
        const vec3 ambient = linear_color(s.ambient);  // exporters write black where they mean "none given"
        m.classical.ambient = (s.has & Surface::has_ambient) && !is_black(ambient) ? ambient : diffuse;
        m.classical.specular = linear_color(s.specular);
        if ((s.has & Surface::has_shininess) == 0) return set_emission(s, m);
        if (!(s.shininess > 0)) m.classical.specular = {0, 0, 0};
        float exponent = s.shininess;
        if (ending_ == "dae" && exponent > 0 && exponent < 1) {  // several exporters write 0..1
            exponent *= 128;
            report_.add(Remark::guessed, path_, "material '" + one_line(s.name, 60) + "'",
                        "a shininess below 1 was read as a fraction of 128");
        }
        m.classical.shininess = exponent >= 1 ? std::min(exponent, largest_shininess) : 1.0f;
        set_emission(s, m);
    }

    void set_emission(const Surface& s, Material& m) {
        m.emission = linear_color(s.emission);
        if (link_of(s, Role::emission) && !m.emission_texture)
            return drop_emission(m, report_, path_, "material '" + one_line(s.name, 60) + "'");
        if (m.emission_texture && is_black(m.emission)) m.emission = {1, 1, 1};
    }

    void set_opacity(const Surface& s, Material& m) {
        float opacity = s.opacity;
        if (!(opacity > 0)) {
            if (opacity == 0)
                report_.add(Remark::guessed, path_, "material '" + one_line(s.name, 60) + "'",
                            "it is wholly transparent in the file and was made opaque");
            opacity = 1;
        }
        if (opacity < 1) m.alpha_mode = AlphaMode::blend;
        m.base_color.w = std::min(opacity, 1.0f);
        const TextureLink* mask = link_of(s, Role::opacity);
        if (!mask) return;
        const TextureLink* diffuse = link_of(s, Role::diffuse);
        const bool own_alpha =
            diffuse && m.base_color_texture && diffuse->path == mask->path && diffuse->picture == mask->picture;
        if (!own_alpha) m.opacity_texture = use(s, Role::opacity);  // else the alpha of the color texture is meant
        if (own_alpha || m.opacity_texture) m.alpha_mode = AlphaMode::blend;
    }

    TextureUse use(const Surface& s, Role role) {
        const TextureLink* link = link_of(s, role);
        if (!link) return {};
        TextureUse u;
        u.texture = textures_.number(*link);
        if (!u) return {};
        u.texcoord_set = existing_set(link->uv_set);
        const bool finite =
            std::isfinite(link->offset[0] + link->offset[1] + link->scale[0] + link->scale[1] + link->rotation_rad);
        const bool placed = link->offset[0] != 0 || link->offset[1] != 0 || link->scale[0] != 1 ||
                            link->scale[1] != 1 || link->rotation_rad != 0;
        if (!finite || !placed) return u;
        if (const auto transform = as_transform(placement_of(*link)))
            u.transform = *transform;
        else
            report_.add(Remark::dropped, path_, "material '" + one_line(s.name, 60) + "'",
                        "a texture's scale is zero; its placement is left out");
        return u;
    }

    /// The file's number where a mesh of this material has that set, else 0.
    std::uint32_t existing_set(std::uint32_t set) {
        bool used = false, found = false;
        for (const Mesh& mesh : scene_.meshes) {
            if (mesh.material != number_) continue;
            used = true;
            found = found || set < mesh.texcoords.size();
        }
        if (!used || found || set == 0) return set;
        report_.add(Remark::changed, path_, {},
                    "a texture uses a set of coordinates that no mesh has; the first is used");
        return 0;
    }

    const std::string &path_, &ending_;
    Scene& scene_;
    Report& report_;
    TextureTable textures_;
    std::uint32_t number_ = 0;
};

}  // namespace

void detail::add_materials(Import& import, const std::string& path, const std::string& ending, bool allow_outside,
                           Scene& scene, Context& context) {
    MaterialMaker maker(import, path, ending, allow_outside, scene, context);
    for (std::uint32_t i = 0; i < import.document.surfaces.size(); ++i)
        scene.materials.push_back(maker.make(import.document.surfaces[i], i));
}

}  // namespace rakelight::io
