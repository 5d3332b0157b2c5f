// SPDX-License-Identifier: Apache-2.0
// The two texts of a picture together, and the values of their uniforms.
#include <algorithm>
#include <cmath>

#include <rakelight/base/error.h>
#include <rakelight/scene/words.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "engines/shader_text.h"

namespace rakelight {
namespace {

constexpr int most_passed =
    32;  ///< [floats] from the vertices to the pixels: drivers have room for 60, with the engine's
constexpr std::size_t most_terms = 4;

Error wrong(std::string reason, std::string advice = {}) {
    return Error(ErrorCode::usage, std::move(reason), {}, std::move(advice)).about("uniform");
}

[[noreturn]] void refuse(const std::string& file, const ShaderVariable& v, const std::string& reason) {
    throw Error(ErrorCode::bad_file, "'" + v.name + "' " + reason, "line " + std::to_string(v.line),
                "see docs/user-shaders.md")
        .with_file(one_line(file, 200));
}

const ShaderVariable* find(const std::vector<ShaderVariable>& all, std::string_view name) {
    const auto at = std::ranges::find(all, name, &ShaderVariable::name);
    return at == all.end() ? nullptr : &*at;
}

/// Uniforms of both, each once.
void join_uniforms(UserShaders& s) {
    s.uniforms = s.vertex.uniforms;
    for (const ShaderVariable& u : s.lighting.uniforms) {
        const ShaderVariable* const other = find(s.uniforms, u.name);
        if (!other) {
            s.uniforms.push_back(u);
        } else if (!other->is_same_kind(u) || other->value != u.value) {
            refuse(s.lighting_name, u, "is declared otherwise in " + one_line(s.vertex_name, 80));
        }
    }
    if (s.uniforms.size() > max_uniforms)
        refuse(s.has_lighting() ? s.lighting_name : s.vertex_name, s.uniforms.back(),
               format_text("is one uniform too many: there may be {}", max_uniforms));
}

void join_passed(UserShaders& s) {
    for (const ShaderVariable& v : s.vertex.inputs)
        refuse(s.vertex_name, v, "is an input, but a vertex shader reads its argument alone");
    s.passed = s.vertex.outputs;
    int floats = 0;
    for (const ShaderVariable& v : s.passed) {
        floats += v.components() * std::max(v.count, 1);
        if (floats > most_passed)
            refuse(s.vertex_name, v, format_text("is too much: {} numbers may be handed on", most_passed));
    }
    for (const ShaderVariable& v : s.lighting.inputs) {
        if (!s.has_vertex()) refuse(s.lighting_name, v, "is an input, but there is no vertex shader that gives it");
        const ShaderVariable* const from = find(s.passed, v.name);
        if (!from || !from->is_same_kind(v))
            refuse(s.lighting_name, v,
                   "is an input, but " + one_line(s.vertex_name, 80) + " gives no output of this name and type");
    }
    s.terms = s.lighting.outputs;
    for (const ShaderVariable& v : s.terms)
        if (v.count > 0 || find(s.passed, v.name)) refuse(s.lighting_name, v, "cannot be an output of the lighting");
    if (s.terms.size() > most_terms)
        refuse(s.lighting_name, s.terms.back(), format_text("is one term too many: there may be {}", most_terms));
}

void set_value(ShaderVariable& to, const ShaderUniform& from) {
    const std::size_t n = std::size_t(to.components());
    if (from.values.size() != n)
        throw wrong(format_text("'{}' is {} {}, which needs {}, not {}", to.name, to.type == "int" ? "an" : "a",
                                to.type, counted(n, "number"), from.values.size()));
    for (const float value : from.values)
        if (!std::isfinite(value)) throw wrong("the value of '" + to.name + "' is not finite");
    if (to.type == "int" && (from.values[0] != std::trunc(from.values[0]) || std::fabs(from.values[0]) > 16777216.0f))
        throw wrong("'" + to.name + "' is an int, which needs a whole number up to 16777216");
    to.value = from.values;
}

std::string listed(const std::vector<ShaderVariable>& all) {
    std::string text;
    for (const ShaderVariable& u : all) text += (text.empty() ? "" : ", ") + u.name + " (" + u.type + ")";
    return one_line(text, 400);
}

[[noreturn]] void refuse_unknown(const UserShaders& s, const std::string& name) {
    const std::string said = "'" + one_line(name, max_uniform_name) + "' is no uniform";
    if (!s.has_lighting() && !s.has_vertex())
        throw wrong(said + ": there is no GLSL text that declares it", "give 'lighting' or 'vertex-shader' a file");
    if (s.uniforms.empty()) throw wrong(said + ": the GLSL text declares none");
    std::vector<std::string_view> names;
    for (const ShaderVariable& u : s.uniforms) names.emplace_back(u.name);
    const std::string nearest = nearest_word(name, names);
    throw wrong(said + " of the GLSL text",
                (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "it declares " + listed(s.uniforms));
}

}  // namespace

UserShaders user_shaders_of(const RenderSettings& settings) {
    UserShaders s;
    for (const std::string* const text : {&settings.lighting_text, &settings.vertex_text})
        if (text->size() > max_shader_bytes)
            throw Error(ErrorCode::bad_file, format_text("a GLSL text has more than {} bytes", max_shader_bytes));
    const auto name_or = [](const std::string& name) { return name.empty() ? "GLSL text" : name; };
    if (!settings.lighting_text.empty()) {
        s.lighting_name = name_or(settings.lighting_name);
        s.lighting = parse_shader_text(s.lighting_name, settings.lighting_text);
    }
    if (!settings.vertex_text.empty()) {
        s.vertex_name = name_or(settings.vertex_name);
        s.vertex = parse_shader_text(s.vertex_name, settings.vertex_text);
    }
    join_uniforms(s);
    join_passed(s);
    if (settings.uniforms.size() > max_uniforms) throw wrong(format_text("there may be {} values", max_uniforms));
    for (std::size_t i = 0; i < settings.uniforms.size(); ++i) {
        const ShaderUniform& given = settings.uniforms[i];
        for (std::size_t k = 0; k < i; ++k)
            if (settings.uniforms[k].name == given.name)
                throw wrong("'" + one_line(given.name, 64) + "' is given twice");
        const auto at = std::ranges::find(s.uniforms, given.name, &ShaderVariable::name);
        if (at == s.uniforms.end()) refuse_unknown(s, given.name);
        set_value(*at, given);
    }
    return s;
}

std::vector<DeclaredUniform> declared_uniforms(const RenderSettings& settings) {
    std::vector<DeclaredUniform> all;
    if (!has_shaders(settings)) return all;
    for (const ShaderVariable& u : user_shaders_of(settings).uniforms)
        all.push_back({{u.name, u.value}, u.type == "int"});
    return all;
}

void check_shaders(const RenderSettings& settings) {
    if (!has_shaders(settings) && settings.uniforms.empty()) return;
    user_shaders_of(settings);
}

}  // namespace rakelight
