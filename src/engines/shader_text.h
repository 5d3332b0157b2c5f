// SPDX-License-Identifier: Apache-2.0
// GLSL texts of the user's: what they declare beside functions. Uniforms, `in`, `out` are taken out of a text, because the
// engine declares them itself: once for both stages, with values that OpenGL ES would refuse in a declaration.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight {

/// What a text declares at its top level.
struct ShaderVariable {
    std::string type, name;      ///< "vec3"
    int count = 0;               ///< of an array; 0: it is none
    int line = 0;                ///< from 1
    std::vector<float> value{};  ///< [components()] of uniforms; by default 0
    /// Numbers of one element: 1 to 4.
    int components() const { return type.starts_with("vec") ? type[3] - '0' : 1; }
    bool is_same_kind(const ShaderVariable& other) const { return type == other.type && count == other.count; }
};

struct ShaderText {
    std::string body;  ///< the text with blanks in place of its declarations, so that lines stay
    int last_line = 0;
    std::vector<ShaderVariable> uniforms, inputs, outputs;
};

/// @param name  of the file, for messages
/// @throws Error bad_file, with file and line: brackets, comments or #if that do not end; a declaration of another form
ShaderText parse_shader_text(const std::string& name, std::string_view text);

/// Both texts of a picture, and what they declare together.
struct UserShaders {
    std::string lighting_name, vertex_name;  ///< empty: there is none
    ShaderText lighting, vertex;
    std::vector<ShaderVariable> uniforms;  ///< of both, each once, with the values of the settings
    std::vector<ShaderVariable> passed;    ///< what the vertex shader hands on
    std::vector<ShaderVariable> terms;     ///< what the lighting gives beside LightTerms, for `explain`
    bool has_lighting() const { return !lighting_name.empty(); }
    bool has_vertex() const { return !vertex_name.empty(); }
};

inline bool has_shaders(const RenderSettings& s) { return !s.lighting_text.empty() || !s.vertex_text.empty(); }

inline void drop_shaders(RenderSettings& s) {
    s.lighting_name.clear(), s.lighting_text.clear(), s.vertex_name.clear(), s.vertex_text.clear();
    s.uniforms.clear();
}

/// @throws Error as parse_shader_text(); bad_file: what the two texts declare does not fit together; usage, about
///         `uniform`: a name that no text declares, a value of another type, too many of them, not finite
UserShaders user_shaders_of(const RenderSettings& settings);

/// Checks the same. @throws Error as user_shaders_of()
void check_shaders(const RenderSettings& settings);

}  // namespace rakelight
