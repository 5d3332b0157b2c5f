// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/program_text.h"

#include <algorithm>
#include <regex>

#include <rakelight/base/error.h>

#include "engines/opengl/programs/embedded_texts.h"
#include "engines/opengl/scene/material_numbers.h"
#include "scene/materials/material_table.h"
#include "shading/text_numbers.h"

namespace rakelight::opengl {
namespace {

/// A stage as it grows; every file begins with its number for the compiler's messages.
class StageMaker {
public:
    void add(const std::string& lines) { stage_.text += lines; }
    void add_file(const std::string& path) {
        stage_.files.all.push_back({path});
        add_numbered(stage_.files.all.size() - 1, embedded_text(path));
    }
    /// A text of the user's. @param is_main  it is file 0
    void add_user(const std::string& name, const ShaderText& text, bool is_main) {
        if (!is_main) stage_.files.all.emplace_back();
        const std::size_t number = is_main ? 0 : stage_.files.all.size() - 1;
        stage_.files.all[number] = {name, text.last_line};
        add_numbered(number, text.body);
    }
    void add_lighting() {
        for (const char* const path : {"math/prelude.glsl", "lighting/maps.glsl", "lighting/albedo_tables.glsl"})
            add_file(path);
        std::string_view list = embedded_text("lighting/all.glsl.list");
        while (!list.empty()) {
            const std::size_t end = list.find('\n');
            const std::string_view line = list.substr(0, end);
            list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
            if (!line.empty() && line[0] != '#') add_file("lighting/" + std::string(line));
        }
    }
    StageText take() { return std::move(stage_); }

private:
    void add_numbered(std::size_t number, std::string_view text) {
        stage_.text += "#line 1 " + std::to_string(number) + "\n";
        stage_.text.append(text);
        stage_.text += "\n";
    }

    StageText stage_;
};

std::string version_of(const Driver& driver) {
    const std::string mask = driver.has_sample_mask ? "1\n" : "0\n";
    if (!driver.is_es)
        return "#version 330 core\n" +
               std::string(driver.has_sample_mask ? "#extension GL_ARB_gpu_shader5 : enable\n" : "") +
               "#define RL_HAS_SAMPLE_MASK " + mask;
    return std::string("#version 300 es\n") +
           (driver.has_sample_mask ? "#extension GL_OES_sample_variables : enable\n" : "") +
           "#define RL_HAS_SAMPLE_MASK " + mask +
           "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp "
           "usampler2D;\n";
}

/// How what vertices hand on is interpolated.
std::string qualifiers(const Features& f, const Driver& driver, bool is_vertex) {
    const std::string place = f.is_sampled && !driver.has_sample_mask ? "centroid " : "";
    return "#define RL_VARYING " + std::string(is_vertex ? "out" : "in") + "\n#define RL_PLACE " + place +
           "\n#define RL_ATTRIBUTE " + place + "\n#define RL_CONSTANT flat\n";
}

/// X(0) X(1) ...: the kind of each is a constant.
std::string each_light(const Features& f) {
    std::string text;
    for (int i = 0; i < f.light_count; ++i) text += " X(" + std::to_string(i) + ")";
    return text;
}

std::string numbers_of(const Features& f) {
    const auto define = [](const char* word, int value) {
        return std::string("#define ") + word + " " + std::to_string(value) + "\n";
    };
    const int texels = 1 + (f.mesh_normals != 0) + (f.mesh_tangents != 0) + (f.mesh_bitangents != 0) +
                       (f.mesh_texcoords != 0) + (f.mesh_colors != 0);
    return define("RL_AT_PIXELS", lit_at_pixels) + define("RL_AT_VERTICES", lit_at_vertices) +
           define("RL_AT_FACES", lit_at_faces) + define("RL_SPACE_WORLD", shading::space_world) +
           define("RL_SPACE_TRANSPOSED", shading::space_transposed) + define("RL_FETCH_WIDTH", fetch_width) +
           define("RL_LIGHT_TEXELS", light_texels) + define("RL_PIECES", cut_pieces) +
           define("RL_VERTEX_TEXELS", texels) + (f.tangents_are_sound ? "#define RL_TANGENTS_ARE_SOUND\n" : "") +
           define("RL_SEEN_FRONT", seen_front) + define("RL_SEEN_BACK", seen_back) +
           define("RL_HAS_SECOND_SET", f.second_sets != 0 || f.coords_are_moved || f.output == Output::places) +
           "#define RL_LIGHT_KINDS " + std::to_string(f.light_kinds) + "u\n#define RL_LIGHTS_WITHOUT_AMBIENT " +
           std::to_string(f.lights_without_ambient) + "u\n#define RL_EACH_LIGHT(X)" + each_light(f) + "\n" +
           define("RL_OUTPUT", int(f.output)) + define("RL_OUTPUT_TERMS", int(Output::terms)) +
           define("RL_OUTPUT_NUMBERS", int(Output::numbers)) + define("RL_OUTPUT_DIRECTIONS", int(Output::directions)) +
           define("RL_OUTPUT_PLACES", int(Output::places)) + define("RL_OUTPUT_COUNT", int(Output::count));
}

/// RL_HAS_<ROLE>_MAP and <role>_texel(p); a missing map is white.
std::string map_function(const Features& f, const TextureRole& role) {
    const std::string name = role.name, number = std::to_string(role.number);
    std::string upper = name;
    for (char& c : upper) c = char(std::toupper(static_cast<unsigned char>(c)));
    const std::string has_map = "#define RL_HAS_" + upper + "_MAP ";
    if (!f.has(role.number)) return has_map + "0\nvec4 " + name + "_texel(Point p) { return vec4(1.0); }\n";
    const bool is_height = role.number == role_height;
    const std::string sampler = is_height ? "rl_heights" : "rl_map_" + number;
    const std::string uniform = is_height ? "" : "uniform sampler2D " + sampler + ";\n";
    const std::string set = "p.texcoords[" + std::to_string(f.second_sets >> role.number & 1u) + "]";
    const bool is_turned = (f.turned_maps >> role.number & 1u) != 0;
    const std::string coords =
        is_turned ? "transformed(" + set + ", RL_TURN_" + number + ", RL_OFFSET_" + number + ")" : set;
    const char* has_levels = (f.level_maps >> role.number & 1u) != 0 ? "true" : "false";
    return has_map + "1\n" + uniform + "TexCoords " + name + "_coords(Point p) { return " + coords + "; }\nvec4 " +
           name + "_texel(Point p) { return read_map(" + sampler + ", " + name + "_coords(p), " + has_levels + "); }\n";
}

std::string map_functions(const Features& f) {
    std::string text;
    for (const TextureRole& role : texture_roles()) text += map_function(f, role);
    return text;
}

const char* main_of(Output output) {
    switch (output) {
        case Output::color:
            return "engines/opengl/glsl/color_main.glsl";
        case Output::shadow:
            return "engines/opengl/glsl/shadow_main.glsl";
        case Output::sky:
            return "engines/opengl/glsl/sky_main.glsl";
        case Output::user_terms:
            return "engines/opengl/glsl/user_terms_main.glsl";
        default:
            return "engines/opengl/glsl/channels_main.glsl";
    }
}

std::string declaration(const std::string& qualifiers, const ShaderVariable& v) {
    return qualifiers + v.type + " " + v.name + (v.count > 0 ? "[" + std::to_string(v.count) + "]" : "") + ";\n";
}

/// Terms of a lighting of the user's: globals, 0 for each light; RL_TERM_0 to 3 for glsl/user_terms_main.glsl.
std::string term_declarations(const std::vector<ShaderVariable>& terms) {
    std::string globals, cleared, shown;
    for (std::size_t i = 0; i < 4; ++i) {
        std::string value = "vec4(0.0)";
        if (i < terms.size()) {
            const ShaderVariable& v = terms[i];
            globals += declaration("", v);
            cleared += " " + v.name + " = " + v.type + "(0.0);";
            value = "vec4(" + v.name;
            for (int k = v.components(); k < 4; ++k) value += ", 0.0";
            value += ")";
        }
        shown += "#define RL_TERM_" + std::to_string(i) + " " + value + "\n";
    }
    return globals + "void clear_terms() {" + cleared + " }\n" + shown;
}

/// What texts of the user's declare: shader_text.h.
std::string user_declarations(const Features& f, const UserShaders& user) {
    if (f.is_user == 0 && f.has_vertex_shader == 0) return {};
    std::string text = "uniform highp float rl_time;\n";
    for (const ShaderVariable& v : user.uniforms) text += declaration("uniform highp ", v);
    for (const ShaderVariable& v : user.passed)
        if (f.has_vertex_shader != 0) text += declaration("RL_ATTRIBUTE RL_VARYING ", v);
    return f.is_user != 0 ? text + term_declarations(user.terms) : text;
}

/// What both stages begin with.
void begin(StageMaker& stage, const Features& f, const Driver& driver, const UserShaders& user, bool is_vertex) {
    stage.add(version_of(driver) + definitions_of(f) + qualifiers(f, driver, is_vertex) + numbers_of(f));
    stage.add_lighting();
    stage.add(material_text());
    stage.add_file("engines/opengl/glsl/frame_uniforms.glsl");
    // What functions of pixels alone can do stays away from vertices that are not lit.
    const bool calls_lighting = f.is_user != 0 && (!is_vertex || f.lit_at != lit_at_pixels);
    stage.add(std::string("#define RL_CALLS_LIGHTING ") + (calls_lighting ? "1\n" : "0\n"));
    stage.add(user_declarations(f, user));
    if (f.is_user != 0) stage.add_file("engines/opengl/glsl/user.glsl");
    const bool is_main = !is_vertex || f.has_vertex_shader == 0;
    if (calls_lighting) stage.add_user(user.lighting_name, user.lighting, is_main);
    stage.add_file("engines/opengl/glsl/points.glsl");
}

/// Where triangles are cut: what a vertex shader of the user's hands on is the sum of that of its corners. The sums have numbers:
/// of the names b[1] and b_1 one could be made twice.
std::string sums_of_passed(const std::vector<ShaderVariable>& passed) {
    std::string sums, added, given;
    int number = 0;
    for (const ShaderVariable& v : passed)
        for (int i = 0; i < std::max(v.count, 1); ++i) {
            const std::string place = v.count > 0 ? v.name + "[" + std::to_string(i) + "]" : v.name;
            const std::string sum = "rl_sum_" + std::to_string(number++);
            sums += v.type + " " + sum + ";\n";
            added += " " + sum + " = " + place + " * weight + (is_first ? " + v.type + "(0.0) : " + sum + ");";
            given += " " + place + " = " + sum + ";";
        }
    return sums + "void add_passed(bool is_first, float weight) {" + added + " }\nvoid hand_on_passed() {" + given +
           " }\n";
}

/// Vertices, and what the user's shader makes of them.
void add_vertices(StageMaker& stage, const Features& f, const UserShaders& user) {
    if (f.is_cut != 0 && f.has_vertex_shader != 0) stage.add(sums_of_passed(user.passed));
    stage.add_file("engines/opengl/glsl/vertices.glsl");
    if (f.has_vertex_shader != 0) stage.add_user(user.vertex_name, user.vertex, true);
}

}  // namespace

std::string_view embedded_text(std::string_view path) {
    for (const EmbeddedText& text : embedded_texts)
        if (text.path == path) return text.text;
    throw Error(ErrorCode::failed, "the program lacks its text " + std::string(path));
}

ProgramText program_text(const Features& f, const Driver& driver, const UserShaders& user) {
    ProgramText out{.has_vertex_shader = f.has_vertex_shader != 0};
    StageMaker vertices, pixels;
    if (f.output == Output::sky) {
        vertices.add(version_of(driver));
        vertices.add_file("engines/opengl/glsl/screen_vertex.glsl");
    } else {
        begin(vertices, f, driver, user, true);
        vertices.add_file("engines/opengl/glsl/varyings.glsl");
        add_vertices(vertices, f, user);
        vertices.add_file("engines/opengl/glsl/vertex_main.glsl");
    }
    begin(pixels, f, driver, user, false);
    for (const char* const name : {"varyings", "texels"})
        if (f.output != Output::sky) pixels.add_file(std::string("engines/opengl/glsl/") + name + ".glsl");
    if (f.output != Output::sky) {
        pixels.add(map_functions(f));
        for (const char* const name : {"material", "bumps", "environment", "pixels"})
            pixels.add_file(std::string("engines/opengl/glsl/") + name + ".glsl");
    } else {
        pixels.add_file("engines/opengl/glsl/environment.glsl");
    }
    pixels.add_file(main_of(f.output));
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText screen_text(const Driver& driver, const std::string& text) {
    ProgramText out;
    StageMaker vertices, pixels;
    vertices.add(version_of(driver));
    vertices.add_file("engines/opengl/glsl/screen_vertex.glsl");
    pixels.add(version_of(driver) + text);
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText display_text(const Driver& driver, int tone) {
    ProgramText out = screen_text(driver, {});
    StageMaker pixels;
    pixels.add(version_of(driver) + "#define RL_SHOWS_CODES " + (tone < 0 ? "1\n" : "0\n") + "#define RL_TONE " +
               std::to_string(tone) + "\n");
    pixels.add_file("math/prelude.glsl");
    pixels.add("struct Maps { float unused; };\n");
    for (const char* const path : {"image/agx_curves.glsl", "image/tone.glsl", "engines/opengl/glsl/display_main.glsl"})
        pixels.add_file(path);
    out.pixels = pixels.take();
    return out;
}

/// Of lines and points: both stages, and what a vertex shader of the user's needs beside.
static void begin_marks(StageMaker& stage, const Features& f, const Driver& driver, const UserShaders& user,
                        bool is_vertex) {
    stage.add(version_of(driver) + definitions_of(f) + numbers_of(f) + "#define RL_IS_VERTEX " +
              (is_vertex ? "1\n" : "0\n") + "#define RL_IS_REVERSED " + (driver.has_reversed_depth ? "1\n" : "0\n") +
              "#define RL_OUTPUT_COLOR " + std::to_string(int(Output::color)) + "\n#define RL_CONSTANT flat\n");
    if (f.has_vertex_shader == 0 || !is_vertex) {
        stage.add("uniform vec3 rl_view_direction;\nuniform vec4 rl_ray[3];\n");
        return stage.add_file("math/prelude.glsl");
    }
    stage.add_lighting();
    stage.add_file("engines/opengl/glsl/frame_uniforms.glsl");
    stage.add("#define RL_ATTRIBUTE\n#define RL_VARYING out\n" + user_declarations(f, user));
}

ProgramText mark_text(const Features& f, const Driver& driver, const UserShaders& user) {
    ProgramText out{.has_vertex_shader = f.has_vertex_shader != 0};
    StageMaker vertices, pixels;
    begin_marks(vertices, f, driver, user, true);
    add_vertices(vertices, f, user);
    begin_marks(pixels, f, driver, user, false);
    for (StageMaker* const stage : {&vertices, &pixels}) stage->add_file("engines/opengl/glsl/marks_main.glsl");
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText line_text(const Driver& driver) {
    ProgramText out;
    StageMaker vertices, pixels;
    for (StageMaker* const stage : {&vertices, &pixels}) {
        stage->add(version_of(driver) + "#define RL_IS_VERTEX " + (stage == &vertices ? "1\n" : "0\n") +
                   "#define RL_IS_REVERSED " + (driver.has_reversed_depth ? "1\n" : "0\n"));
        stage->add_file("engines/opengl/glsl/lines_main.glsl");
    }
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText pose_text(const PoseFeatures& f, const Driver& driver) {
    ProgramText out;
    StageMaker vertices, pixels;
    const auto define = [](const char* word, int value) {
        return std::string("#define ") + word + " " + std::to_string(value) + "\n";
    };
    vertices.add(version_of(driver) + define("RL_HAS_NORMALS", f.has_normals) +
                 define("RL_HAS_TANGENTS", f.has_tangents) + define("RL_IS_SKINNED", f.is_skinned) +
                 define("RL_HAS_MORE", f.has_more) + define("RL_FETCH_WIDTH", fetch_width));
    vertices.add_file("engines/opengl/glsl/pose_main.glsl");
    pixels.add(version_of(driver) + "void main() {}\n");  // ES has no programs of one stage
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

std::string named_fault(const std::string& log, const TextFiles& files) {
    // "12:34(5): error: ..." (Mesa) and "12(34) : error ..." (NVIDIA): file, line; warnings may stand before
    static const std::regex fault(R"((^|\n)(?:ERROR: )?(\d+)[:(](\d+)\)?([^\n]*))");
    std::smatch match, first;
    for (auto from = log.cbegin(); std::regex_search(from, log.cend(), match, fault); from = match.suffix().first) {
        const std::string words = match[4].str();
        const bool is_error = words.find("rror") != words.npos || match[0].str().find("ERROR") != words.npos;
        if (first.empty() || is_error) first = match;
        if (is_error) break;
    }
    if (first.empty()) return log.substr(0, log.find('\n'));
    const std::size_t number = std::strtoul(first[2].str().c_str(), nullptr, 10);
    std::string line = first[3].str();
    TextFiles::File file = number < files.all.size() ? files.all[number] : TextFiles::File{};
    if (file.last_line == 0 && files.all[0].last_line > 0) file = files.all[0], line = std::to_string(file.last_line);
    return file.name + ":" + line + first[4].str();
}

}  // namespace rakelight::opengl
