// SPDX-License-Identifier: Apache-2.0
// Keys of shading: lighting models, bumps, shadows.
#include <cmath>
#include <limits>

#include "base/format_text.h"
#include "world/keys/key_fields.h"
#include "world/keys/lighting_text.h"

namespace rakelight::keys {
namespace {

constexpr Word<TangentSpace> tangent_space_words[] = {{"world", TangentSpace::world},
                                                      {"pixel", TangentSpace::pixel},
                                                      {"vertex", TangentSpace::vertex},
                                                      {"transposed", TangentSpace::transposed}};

void read_steps(PictureRequest& r, Words w) {
    const std::vector<int> steps = values::integers("bump-steps", w[0], 2);
    if (steps[0] < 1 || steps[1] < steps[0] || steps[1] > 1024)
        throw values::wrong("bump-steps", "must be 1 to 1024, the first not more than the second");
    r.settings.relief.min_steps = steps[0], r.settings.relief.max_steps = steps[1];
}

Written write_steps(const PictureRequest& r) {
    const Relief &of = r.settings.relief, &plain = defaults().settings.relief;
    if (of.min_steps == plain.min_steps && of.max_steps == plain.max_steps) return {};
    return {format_text("{},{}", of.min_steps, of.max_steps)};
}

/// A word, or a file with a user-defined model.
void read_lighting(PictureRequest& r, Words w) {
    RenderSettings& s = r.settings;
    s.lighting_name.clear(), s.lighting_text.clear();
    if (!is_lighting_file(w[0])) {
        s.lighting = values::word("lighting", w[0], lighting_words);
        return;
    }
    s.lighting_text = read_shader_file(w[0], "lighting", "user_terms");
    s.lighting_name = w[0];
}

Written write_lighting(const PictureRequest& r) {
    if (!r.settings.lighting_name.empty()) return {r.settings.lighting_name};
    if (r.settings.lighting == defaults_beside(r).settings.lighting) return {};
    return name_in(lighting_words, r.settings.lighting);
}

void read_vertex_shader(PictureRequest& r, Words w) {
    r.settings.vertex_text = read_shader_file(w[0], "vertex-shader", "user_vertex");
    r.settings.vertex_name = w[0];
}

Written write_vertex_shader(const PictureRequest& r) {
    return r.settings.vertex_name.empty() ? Written{} : Written{r.settings.vertex_name};
}

/// NAME=NUMBER, NAME=NUMBER,NUMBER,...
ShaderUniform uniform_of(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos || equals == 0)
        throw values::wrong("uniform", "'" + one_line(word, 60) + "' needs a name and '=' with numbers",
                            "write for example height=0.1 or tint=1,0.5,0");
    ShaderUniform u{.name = word.substr(0, equals)};
    const std::string_view numbers = std::string_view(word).substr(equals + 1);
    const std::size_t count = values::split(numbers, ',').size();
    if (count > 4) throw values::wrong("uniform", "'" + one_line(u.name, 60) + "' has more than 4 numbers");
    for (const double value : values::numbers("uniform", numbers, count)) {
        if (std::fabs(value) > double(std::numeric_limits<float>::max()))
            throw values::wrong("uniform", "the value of '" + one_line(u.name, 60) + "' is too large for a float");
        u.values.push_back(float(value));
    }
    return u;
}

void read_uniforms(PictureRequest& r, Words w) {
    if (w.size() > max_uniforms)
        throw values::wrong("uniform", format_text("there may be {} values, not {}", max_uniforms, w.size()));
    r.settings.uniforms.clear();
    for (const std::string& word : w) r.settings.uniforms.push_back(uniform_of(word));
}

Written write_uniforms(const PictureRequest& r) {
    Written all;
    for (const ShaderUniform& u : r.settings.uniforms) {
        std::string numbers;
        for (const float value : u.values) numbers += (numbers.empty() ? "" : ",") + text_of_float(value);
        all.push_back(u.name + "=" + numbers);
    }
    return all;
}

constexpr RenderKey table_of_surface[] = {
    {"lighting", Kind::value, read_lighting, write_lighting},
    {"vertex-shader", Kind::file, read_vertex_shader, write_vertex_shader},
    {"uniform", Kind::list, read_uniforms, write_uniforms},
    RL_WORD_KEY("specular", r.settings.specular_form, specular_form_words),
    RL_SWITCH_KEY("specular-horizon", r.settings.specular_horizon),
    RL_WORD_KEY("ward-form", r.settings.ward_form, ward_form_words),
    RL_SWITCH_KEY("multiple-scattering", r.settings.multiple_scattering),
    RL_SWITCH_KEY("viewer-infinity", r.settings.viewer_at_infinity),
    RL_WORD_KEY("bump", r.settings.bump, bump_words),
    RL_WORD_KEY("bump-terms", r.settings.bump_terms, bump_terms_words),
    RL_FLOAT_KEY("bump-depth", r.settings.relief.depth, 0, 10),
    RL_FLOAT_KEY("bump-bias", r.settings.relief.bias, 0, 1),
    RL_WORD_KEY("bump-polarity", r.settings.relief.holds_depth, polarity_words),
    {"bump-steps", Kind::value, read_steps, write_steps},
    RL_INTEGER_KEY("bump-refinement", r.settings.relief.refinement_steps, 0, 32),
    RL_SWITCH_KEY("bump-self-shadow", r.settings.relief.self_shadow),
    RL_SWITCH_KEY("bump-silhouette", r.settings.relief.limit_silhouette),
    RL_WORD_KEY("tangent-space", r.settings.tangent_space, tangent_space_words),
    RL_SWITCH_KEY("normalize-frames", r.settings.normalize_frames),
    {"shadows", Kind::on_off, [](PictureRequest& r, Words w) { r.settings.shadows = values::on_off("shadows", w[0]); },
     [](const PictureRequest& r) -> Written {
         const bool by_engine = r.engine == "trace";
         return r.settings.shadows == by_engine ? Written{} : on_or_off(r.settings.shadows);
     }},
    RL_INTEGER_KEY("shadow-size", r.settings.shadow_size, 16, 8192),
    RL_FLOAT_KEY("shadow-bias", r.settings.shadow_bias, 0, 100),
    RL_INTEGER_KEY("shadow-filter", r.settings.shadow_filter, 0, 4),
    RL_KEY("ambient-occlusion", flag, r.settings.ambient_occlusion, w[0] == "on", {"on"}),
    RL_NUMBER_KEY("ambient-occlusion-radius", r.settings.ambient_occlusion_radius, 0, 1e30),
    RL_INTEGER_KEY("ambient-occlusion-samples", r.settings.ambient_occlusion_samples, min_occlusion_samples,
                   max_occlusion_samples),
};

}  // namespace

constinit const KeyTable surface_keys = table_of_surface;

}  // namespace rakelight::keys
