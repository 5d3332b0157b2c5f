// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/material_numbers.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/assert.h"
#include "base/format_text.h"

namespace rakelight::opengl {
namespace {

/// One name of the text: `components` floats from `offset` of MaterialNumbers on.
struct Number {
    std::string name;
    std::size_t offset, components;
    std::size_t place = 0;  ///< [floats] in the packed array
};

/// Four floats per row, a name never over two rows.
std::vector<Number> placed(std::vector<Number> numbers) {
    std::stable_sort(numbers.begin(), numbers.end(),
                     [](const Number& a, const Number& b) { return a.components > b.components; });
    std::size_t at = 0;
    for (Number& n : numbers) {
        if (at % 4 + n.components > 4) at += 4 - at % 4;
        n.place = at, at += n.components;
    }
    RL_ASSERT(at <= 4 * material_vectors, "the material's numbers have their room");
    return numbers;
}

constexpr std::size_t components(std::size_t bytes) { return bytes / sizeof(float); }

std::vector<Number> make_numbers() {
#define RL_OWN(field) {"m_" #field, offsetof(MaterialNumbers, field), components(sizeof(MaterialNumbers::field))}
#define RL_FACTOR(field)                                                                             \
    {                                                                                                \
        "m_" #field, offsetof(MaterialNumbers, factors) + offsetof(shading::MaterialFactors, field), \
            components(sizeof(shading::MaterialFactors::field))                                      \
    }
    std::vector<Number> all = {RL_FACTOR(metallic),
                               RL_FACTOR(roughness),
                               RL_FACTOR(anisotropy),
                               RL_FACTOR(clearcoat),
                               RL_FACTOR(clearcoat_roughness),
                               RL_FACTOR(clearcoat_normal_scale),
                               RL_FACTOR(sheen_roughness),
                               RL_FACTOR(base_color),
                               RL_FACTOR(emission),
                               RL_FACTOR(ambient),
                               RL_FACTOR(specular),
                               RL_FACTOR(shininess),
                               RL_FACTOR(dielectric_color),
                               RL_FACTOR(specular_strength),
                               RL_FACTOR(normal_scale),
                               RL_FACTOR(occlusion_strength),
                               RL_FACTOR(lobe_roughness),
                               RL_FACTOR(sigma),
                               RL_FACTOR(ward_alpha),
                               RL_FACTOR(anisotropy_axis),
                               RL_FACTOR(sheen_color),
                               RL_FACTOR(transmission),
                               RL_FACTOR(through_eta),
                               RL_FACTOR(through_blur),
                               RL_FACTOR(attenuation),
                               RL_FACTOR(iridescence),
                               RL_FACTOR(iridescence_ior),
                               RL_FACTOR(iridescence_thickness_min_nm),
                               RL_FACTOR(iridescence_thickness_max_nm),
                               RL_OWN(body_thickness),
                               RL_OWN(mean_roughness),
                               RL_OWN(mask_cutoff),
                               RL_OWN(relief),
                               RL_OWN(relief_to_uv),
                               RL_OWN(relief_to_map),
                               RL_OWN(height_levels)};
#undef RL_FACTOR
#undef RL_OWN
    for (std::size_t role = 0; role < texture_role_count; ++role) {
        all.push_back(
            {"RL_TURN_" + std::to_string(role), offsetof(MaterialNumbers, turn) + role * 4 * sizeof(float), 4});
        all.push_back(
            {"RL_OFFSET_" + std::to_string(role), offsetof(MaterialNumbers, offset) + role * 2 * sizeof(float), 2});
    }
    return placed(std::move(all));
}

const std::vector<Number>& numbers() {
    static const std::vector<Number> all = make_numbers();
    return all;
}

}  // namespace

PackedMaterial pack(const MaterialNumbers& from) {
    PackedMaterial out{};
    for (const Number& n : numbers())
        std::copy_n(reinterpret_cast<const float*>(reinterpret_cast<const char*>(&from) + n.offset), n.components,
                    out.begin() + std::ptrdiff_t(n.place));
    return out;
}

const std::string& material_text() {
    static const std::string text = [] {
        std::string t = format_text("uniform vec4 rl_material[{}];\n", material_vectors);
        for (const Number& n : numbers()) {
            t += format_text("#define {} rl_material[{}]", n.name, n.place / 4);
            if (n.components < 4) t += "." + std::string("xyzw").substr(n.place % 4, n.components);
            t += "\n";
        }
        return t;
    }();
    return text;
}

}  // namespace rakelight::opengl
