// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/draw_state.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "scene/materials/material_conversion.h"
#include "scene/materials/material_table.h"
#include "shading/behind.h"
#include "shading/choices.h"
#include "shading/guard_band.h"

namespace rakelight::opengl {
namespace {

constexpr std::array least_visible_first = {role_iridescence,
                                            role_iridescence_thickness,
                                            role_thickness,
                                            role_clearcoat_roughness,
                                            role_sheen_roughness,
                                            role_specular_strength,
                                            role_anisotropy,
                                            role_clearcoat_normal,
                                            role_specular_color,
                                            role_clearcoat,
                                            role_sheen_color,
                                            role_transmission,
                                            role_occlusion,
                                            role_specular,
                                            role_emission,
                                            role_height,
                                            role_metallic_roughness,
                                            role_normal,
                                            role_opacity,
                                            role_base_color};
static_assert(least_visible_first.size() == texture_role_count);

/// Whether triangles of the draw may reach out of the clip volume.
bool reaches_out(const shading::Draw& draw, const shading::PictureCamera& view) {
    const shading::GuardBand guard(view);
    const dmat4 to_camera = view.world_to_camera * draw.to_world;
    const Bounds box{cast<double>(draw.low), cast<double>(draw.high)};
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = transform_point(to_camera, box.corner(corner));
        const double w = -p.z, x = view.scale_x * p.x, y = view.scale_y * p.y;
        const bool is_inside =
            w > view.z_near && w < view.z_far && std::abs(x) < guard.x * w && std::abs(y) < guard.y * w;
        if (!is_inside) return true;
    }
    return false;
}

/// Fills one DrawState, step by step.
class DrawStateMaker {
public:
    DrawStateMaker(const PictureState& picture, std::uint32_t number, Output output)
        : p_(picture),
          draw_(picture.list.draws[number]),
          drawn_(picture.list.material(draw_)),
          material_(picture.list.scene_material(drawn_)),
          mesh_(picture.list.scene.meshes[draw_.mesh]),
          shading_(picture.shading[number]),
          side_(picture.list, draw_, picture.settings.front_face),
          f_(state_.features) {
        f_.output = output;
        state_.numbers.factors = drawn_.factors;
        state_.culling = shading::culling_of(p_.list, draw_, p_.settings);
        state_.against = side_.against();
    }

    DrawState run(bool wants_triangles) {
        set_model();
        set_bumps();
        set_alpha();
        set_view();
        set_lit_at();
        choose_maps();
        set_vertices(wants_triangles);
        bind_maps();
        set_relief();
        return std::move(state_);
    }

private:
    bool is_lit_at_corners() const { return shading_ == Shading::flat || shading_ == Shading::gouraud; }
    const shading::MaterialFactors& factors() const { return drawn_.factors; }

    void set_model() {
        f_.is_unlit = factors().unlit || shading_ == Shading::unlit;
        const auto& emission = factors().emission;
        f_.has_emission = emission[0] != 0 || emission[1] != 0 || emission[2] != 0;
        f_.is_metallic = factors().metallic_roughness != 0;
        if (f_.is_unlit) return;
        f_.model = shading::reflection_model(shading::lighting_of(p_.list, draw_, p_.settings));
        f_.is_user = !p_.settings.lighting_text.empty();
        if (f_.is_user)
            f_.model = shading::reflects_phong;  // k_a, k_d, k_s and the exponent, and what the environment adds
        f_.form = shading::reflection_form(specular_form_of(material_, p_.settings.specular_form));
        f_.horizon = p_.settings.specular_horizon;
        f_.ward_form = shading::ward_number(shading::ward_form_of(material_, p_.settings.ward_form));
        f_.has_scattering = p_.settings.multiple_scattering;
        f_.has_classical_sum =
            !f_.is_user && (f_.model == shading::reflects_phong || f_.model == shading::reflects_blinn_phong ||
                            (f_.model == shading::reflects_lambert && !f_.is_metallic));
        f_.has_environment = p_.has_environment;
        f_.has_light_around = p_.has_environment || shading::has_ambient_light(p_.list.scene);
        if (f_.model != shading::reflects_pbr || !f_.is_metallic) return;
        const auto& sheen = factors().sheen_color;
        f_.is_anisotropic = factors().anisotropy > 0;
        f_.has_sheen = sheen[0] > 0 || sheen[1] > 0 || sheen[2] > 0;
        f_.has_coat = factors().clearcoat > 0;
        f_.has_iridescence = factors().iridescence > 0;
        f_.has_transmission = p_.behind && shading::shows_behind(p_.list, draw_, p_.settings);
        if (!f_.has_transmission) return;
        f_.body_bends = factors().is_body, f_.body_parts = factors().through_parts;
        state_.numbers.body_thickness = factors().thickness * shading::thickness_scale(draw_);
    }

    void set_bumps() {
        const Bump bump = is_lit_at_corners() ? Bump::none : shading::bump_of(p_.list, draw_, p_.settings);
        f_.has_bumps = bump != Bump::none;
        if (!f_.has_bumps) return;
        f_.bump_terms = shading::bump_terms_number(shading::bump_terms_of(material_, p_.settings.bump_terms));
        f_.has_two_normals = f_.bump_terms != shading::bump_both;
        f_.tangent_space = shading::tangent_space_number(p_.settings.tangent_space);
        f_.orthogonalize = p_.settings.orthogonalize;
        f_.normalize_frames = p_.settings.normalize_frames;
        f_.relief = shading::relief_technique(bump);
        f_.uses_normal_map = f_.relief != shading::relief_height && drawn_.maps[role_normal];
        f_.normals_are_scaled = f_.uses_normal_map && factors().normal_scale != 1;
        f_.green_down = f_.uses_normal_map && material_.green_down;
        f_.centered_normals = f_.uses_normal_map && material_.centered_normals;
        f_.coords_are_moved = f_.relief > shading::relief_height;
    }

    void set_alpha() {
        const bool limits =
            f_.relief > shading::relief_height && material_.relief.value_or(p_.settings.relief).limit_silhouette;
        state_.numbers.mask_cutoff = shading::mask_cutoff(factors(), limits);
        f_.is_masked = state_.numbers.mask_cutoff >= 0;
        f_.is_blended = factors().blend;
        f_.is_opaque = factors().alpha_cutoff < 0 && !factors().blend;
        f_.limit_silhouette = limits;
    }

    void set_view() {
        f_.anisotropy = p_.settings.anisotropy;
        f_.fog = shading::fog_number(p_.list.scene.fog.kind);
        f_.is_parallel = p_.view.orthographic;
        f_.has_parallel_viewer = p_.view.orthographic || p_.settings.viewer_at_infinity;
        f_.is_sampled = f_.output == Output::color && p_.settings.samples > 1 ? p_.settings.samples : 0;
        if (f_.output == Output::directions) f_.orthogonalize = p_.settings.orthogonalize;
        f_.is_screen_linear = p_.settings.interpolation == AttributeInterpolation::screen && !p_.view.orthographic;
        f_.has_vertex_shader = !p_.settings.vertex_text.empty();
        f_.is_cut = f_.is_screen_linear && f_.output != Output::shadow &&
                    (f_.has_vertex_shader || reaches_out(draw_, p_.view));  // the shader may leave the mesh's box
    }

    void set_lit_at() {
        if (f_.is_unlit) return;
        f_.paints_last = f_.has_classical_sum && !f_.is_metallic && !f_.has_environment && !f_.is_user &&
                         !drawn_.maps[role_occlusion] && f_.output != Output::terms;
        const bool is_flat = shading::is_lit_per_face(p_.list, draw_, shading_);
        f_.lit_at = !is_lit_at_corners() ? lit_at_pixels : is_flat ? lit_at_faces : lit_at_vertices;
        f_.two_sides =
            f_.lit_at == lit_at_vertices && !(state_.culling.back && !side_.front_turns() && !state_.against);
        f_.lights_are_near = p_.lights.are_near() ? std::max(p_.lights.count(), 1) : 0;
        f_.light_count = p_.lights.are_near() ? p_.lights.count() : 0;
        f_.light_kinds = p_.lights.kinds();
        f_.lights_without_ambient = p_.lights.without_ambient();
        f_.has_lists = f_.lit_at == lit_at_pixels && p_.lights.has_lists();
        f_.has_shadows = f_.lit_at == lit_at_pixels && p_.has_shadows;
        if (!f_.has_shadows) return;
        f_.shadow_size = p_.settings.shadow_size;
        f_.shadow_filter = p_.settings.shadow_filter;
    }

    /// Those that the program reads and has units for.
    void choose_maps() {
        std::uint32_t maps = 0;
        for (const TextureRole& role : texture_roles())
            if (drawn_.maps[std::size_t(role.number)]) maps |= 1u << role.number;
        const auto drop = [&maps](TextureRoleNumber role) { maps &= ~(1u << role); };
        if (!f_.has_transmission) drop(role_transmission), drop(role_thickness);
        if (!f_.has_iridescence) drop(role_iridescence), drop(role_iridescence_thickness);
        if (!f_.uses_normal_map) drop(role_normal);
        if (f_.relief == shading::relief_none) drop(role_height);
        if (f_.is_opaque) drop(role_opacity);
        if (!f_.has_coat) drop(role_clearcoat_normal), drop(role_clearcoat), drop(role_clearcoat_roughness);
        if (!f_.has_sheen) drop(role_sheen_color), drop(role_sheen_roughness);
        if (f_.is_unlit)
            drop(role_metallic_roughness), drop(role_occlusion), drop(role_specular), drop(role_specular_color),
                drop(role_specular_strength), drop(role_anisotropy);
        const bool is_alpha_alone =
            f_.output == Output::shadow || f_.output == Output::count || f_.output == Output::numbers;
        if (is_alpha_alone) maps &= f_.is_masked ? 1u << role_base_color | 1u << role_opacity | 1u << role_height : 0u;
        state_.dropped = dropped_maps(maps, p_.units - f_.has_transmission);
        f_.maps = maps & ~state_.dropped;
        if (!f_.has(role_height)) f_.relief = shading::relief_none;
    }

    void set_vertices(bool wants_triangles) {
        f_.has_corner_frames = f_.has_bumps && (f_.tangent_space == shading::space_vertex ||
                                                f_.tangent_space == shading::space_transposed);
        const bool reads_tangents = f_.has_bumps || f_.is_anisotropic || f_.is_user ||
                                    f_.model == shading::reflects_ward || f_.has(role_clearcoat_normal) ||
                                    f_.output == Output::directions;
        const bool reads_normals = f_.output != Output::shadow && f_.output != Output::count;
        f_.from_triangles = wants_triangles || f_.lit_at == lit_at_faces || f_.is_cut ||
                            (reads_normals && (mesh_.normals.empty() || state_.against)) || f_.has_corner_frames;
        f_.front_turns = side_.front_turns();
        f_.seen_sides = state_.culling.back ? seen_front : state_.culling.front ? seen_back : seen_both;
        f_.has_normals = reads_normals;
        f_.has_tangents = reads_tangents;
        f_.has_bitangents = f_.has_bumps && f_.has(role_normal) && !mesh_.bitangents.empty();
        f_.tangents_are_sound = reads_tangents && !mesh_.tangents.empty();
        f_.has_colors = !mesh_.colors.empty() && factors().vertex_colors;
        f_.has_texcoords = f_.maps != 0 || f_.is_user || f_.output == Output::places;
        if (!f_.from_triangles) return;
        set_mesh_features(mesh_, f_);
    }

    void bind_maps() {
        for (const TextureRole& role : texture_roles()) {
            if (!f_.has(role.number)) continue;
            const TextureUse& use = role.in(material_);
            const Texture& texture = p_.list.scene.textures[use.texture];
            const shading::LoadedTexture* const loaded = p_.cache.find(shading::key_of(p_.list, drawn_, role));
            const auto& levels = static_cast<const TextureLevels&>(*loaded->packed);
            const bool is_height = role.number == role_height;
            state_.maps.push_back(
                {role.number, p_.textures.find(levels, is_height), p_.textures.sampler(texture.sampler, is_height)});
            const shading::UvTransform t = shading::uv_transform(use);
            if (!shading::is_identity(t)) f_.turned_maps |= 1u << role.number;
            const float turn[4] = {t.uu, t.uv, t.vu, t.vv}, offset[2] = {t.u0, t.v0};
            std::copy_n(turn, 4, state_.numbers.turn[role.number]);
            std::copy_n(offset, 2, state_.numbers.offset[role.number]);
            if (use.texcoord_set != 0) f_.second_sets |= 1u << role.number;
            const bool has_levels = texture.sampler.mip != MipFilter::none && levels.level_count > 1;
            if (has_levels) f_.level_maps |= 1u << role.number;
            if (role.number == role_metallic_roughness) metallic_ = &levels, metallic_use_ = &use;
            if (role.number == role_height) height_ = &levels, f_.height_mips = height_mips(texture.sampler, levels);
        }
        f_.height_set = f_.second_sets >> role_height & 1u;
        f_.occlusion_in_metallic =
            f_.has(role_occlusion) && metallic_use_ && material_.occlusion_texture == *metallic_use_;
        state_.numbers.mean_roughness = factors().roughness * (metallic_ ? metallic_->mean_green : 1.0f);
    }

    static std::int32_t height_mips(const Sampler& sampler, const TextureLevels& levels) {
        return levels.level_count == 1 || sampler.mip == MipFilter::none ? 0
               : sampler.mip == MipFilter::nearest                       ? 1
                                                                         : 2;
    }

    void set_relief() {
        if (f_.relief == shading::relief_none) return;
        const shading::ReliefFactors r =
            shading::relief_of(p_.list, draw_, p_.settings, double(height_->width) / height_->height);
        state_.numbers.relief[0] = r.depth, state_.numbers.relief[1] = r.level;
        std::copy_n(&r.to_uv[0][0], 4, state_.numbers.relief_to_uv);
        std::copy_n(&r.to_map[0][0], 4, state_.numbers.relief_to_map);
        state_.numbers.height_levels = float(height_->level_count);
        f_.holds_depth = r.holds_depth;
        f_.fewest_layers = r.min_steps, f_.most_layers = r.max_steps, f_.bisections = r.refinement_steps;
        f_.self_shadow = r.self_shadow && f_.output != Output::shadow;
    }

    const PictureState& p_;
    const shading::Draw& draw_;
    const shading::DrawMaterial& drawn_;
    const Material& material_;
    const Mesh& mesh_;
    const Shading shading_;
    const shading::LitSide side_;
    DrawState state_;
    Features& f_;
    const TextureLevels *metallic_ = nullptr, *height_ = nullptr;
    const TextureUse* metallic_use_ = nullptr;
};

}  // namespace

std::uint32_t dropped_maps(std::uint32_t maps, int units) {
    std::uint32_t dropped = 0;
    for (const TextureRoleNumber role : least_visible_first) {
        if (std::popcount(maps & ~dropped) <= units) break;
        dropped |= maps & 1u << role;
    }
    return dropped;
}

void set_mesh_features(const Mesh& mesh, Features& f) {
    const auto has_set = [&mesh](std::size_t set) {
        return set < mesh.texcoords.size() && !mesh.texcoords[set].empty();
    };
    f.mesh_normals = !mesh.normals.empty();
    f.mesh_tangents = !mesh.tangents.empty();
    f.mesh_bitangents = !mesh.bitangents.empty();
    f.mesh_texcoords = has_set(0) || has_set(1);
    f.mesh_colors = !mesh.colors.empty();
}

DrawState draw_state(const PictureState& picture, std::uint32_t draw, Output output, bool wants_triangles) {
    return DrawStateMaker(picture, draw, output).run(wants_triangles);
}

}  // namespace rakelight::opengl
