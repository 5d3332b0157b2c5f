// SPDX-License-Identifier: Apache-2.0
// The features of a program: choices that are constants in its text (RL_...), so that the driver removes unused code.
// Draws with equal features share a program.
#pragma once
#include <compare>
#include <cstdint>
#include <string>

#include "scene/materials/texture_role_numbers.h"

namespace rakelight::opengl {

/// What a program writes.
enum class Output : std::int32_t { color, shadow, sky, numbers, directions, places, terms, count, user_terms };

// Field, its word in the text.
#define RL_OPENGL_FEATURES(X)                         \
    X(model, "MODEL")                                 \
    X(form, "FORM")                                   \
    X(horizon, "HORIZON")                             \
    X(ward_form, "WARD_FORM")                         \
    X(is_anisotropic, "IS_ANISOTROPIC")               \
    X(has_scattering, "HAS_SCATTERING")               \
    X(has_sheen, "HAS_SHEEN")                         \
    X(has_coat, "HAS_COAT")                           \
    X(has_iridescence, "HAS_IRIDESCENCE")             \
    X(has_transmission, "HAS_TRANSMISSION")           \
    X(body_bends, "BODY_BENDS")                       \
    X(body_parts, "BODY_PARTS")                       \
    X(has_two_normals, "HAS_TWO_NORMALS")             \
    X(is_metallic, "IS_METALLIC")                     \
    X(is_unlit, "IS_UNLIT")                           \
    X(is_user, "IS_USER")                             \
    X(has_vertex_shader, "HAS_VERTEX_SHADER")         \
    X(has_classical_sum, "HAS_CLASSICAL_SUM")         \
    X(has_emission, "HAS_EMISSION")                   \
    X(paints_last, "PAINTS_LAST")                     \
    X(has_environment, "HAS_ENVIRONMENT")             \
    X(has_light_around, "HAS_LIGHT_AROUND")           \
    X(occlusion_in_metallic, "OCCLUSION_IN_METALLIC") \
    X(lit_at, "LIT_AT")                               \
    X(two_sides, "TWO_SIDES")                         \
    X(front_turns, "FRONT_TURNS")                     \
    X(has_normals, "HAS_NORMALS")                     \
    X(has_tangents, "HAS_TANGENTS")                   \
    X(tangents_are_sound, "TANGENTS_GIVEN")           \
    X(has_texcoords, "HAS_TEXCOORDS")                 \
    X(has_colors, "HAS_COLORS")                       \
    X(from_triangles, "FROM_TRIANGLES")               \
    X(has_corner_frames, "HAS_CORNER_FRAMES")         \
    X(mesh_normals, "MESH_NORMALS")                   \
    X(mesh_tangents, "MESH_TANGENTS")                 \
    X(has_bitangents, "HAS_BITANGENTS")               \
    X(mesh_bitangents, "MESH_BITANGENTS")             \
    X(mesh_texcoords, "MESH_TEXCOORDS")               \
    X(mesh_colors, "MESH_COLORS")                     \
    X(has_bumps, "HAS_BUMPS")                         \
    X(uses_normal_map, "USES_NORMAL_MAP")             \
    X(bump_terms, "BUMP_TERMS")                       \
    X(tangent_space, "TANGENT_SPACE")                 \
    X(orthogonalize, "ORTHOGONALIZE")                 \
    X(normalize_frames, "NORMALIZE_FRAMES")           \
    X(normals_are_scaled, "NORMALS_ARE_SCALED")       \
    X(green_down, "GREEN_DOWN")                       \
    X(centered_normals, "CENTERED_NORMALS")           \
    X(relief, "RELIEF")                               \
    X(height_set, "HEIGHT_SET")                       \
    X(height_mips, "HEIGHT_MIPS")                     \
    X(holds_depth, "HOLDS_DEPTH")                     \
    X(fewest_layers, "FEWEST_LAYERS")                 \
    X(most_layers, "MOST_LAYERS")                     \
    X(bisections, "BISECTIONS")                       \
    X(self_shadow, "SELF_SHADOW")                     \
    X(limit_silhouette, "LIMIT_SILHOUETTE")           \
    X(coords_are_moved, "COORDS_ARE_MOVED")           \
    X(is_masked, "IS_MASKED")                         \
    X(is_blended, "IS_BLENDED")                       \
    X(is_opaque, "IS_OPAQUE")                         \
    X(anisotropy, "ANISOTROPY")                       \
    X(fog, "FOG")                                     \
    X(is_parallel, "PARALLEL")                        \
    X(has_parallel_viewer, "PARALLEL_VIEWER")         \
    X(has_shadows, "HAS_SHADOWS")                     \
    X(shadow_size, "SHADOW_SIZE")                     \
    X(shadow_filter, "SHADOW_FILTER")                 \
    X(lights_are_near, "LIGHTS_ARE_NEAR")             \
    X(light_count, "LIGHT_COUNT_KNOWN")               \
    X(has_lists, "HAS_LISTS")                         \
    X(is_screen_linear, "SCREEN_LINEAR")              \
    X(is_cut, "CUTS")                                 \
    X(is_sampled, "SAMPLED")                          \
    X(seen_sides, "SEEN_SIDES")

/// Sides of a surface that culling leaves.
enum SeenSides : std::int32_t { seen_both, seen_front, seen_back };

/// What is left of a triangle that six planes cut has 9 corners at most.
inline constexpr std::int32_t cut_pieces = 7;

/// Where lighting is evaluated.
enum LitAt : std::int32_t { lit_at_pixels, lit_at_vertices, lit_at_faces };

struct Features {
    Output output = Output::color;
#define RL_FIELD(name, word) std::int32_t name = 0;
    RL_OPENGL_FEATURES(RL_FIELD)
#undef RL_FIELD
    std::uint32_t maps = 0;                    ///< [bits by TextureRoleNumber] that are read
    std::uint32_t second_sets = 0;             ///< those of texture coordinate set 1
    std::uint32_t level_maps = 0;              ///< those with mip levels
    std::uint32_t turned_maps = 0;             ///< those with a texture transform
    std::uint32_t light_kinds = 0;             ///< four bits for each of few lights: LightTable::kinds()
    std::uint32_t lights_without_ambient = 0;  ///< [bits] of few lights: those whose ambient term is 0

    bool has(TextureRoleNumber role) const { return (maps >> role & 1u) != 0; }
    auto operator<=>(const Features&) const = default;
};

/// As lines of #define.
std::string definitions_of(const Features& features);

}  // namespace rakelight::opengl
