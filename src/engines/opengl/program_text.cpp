// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/program_text.h"

#include <regex>

#include <rakelight/error.h>

#include "engines/opengl/embedded_texts.h"
#include "engines/opengl/material_numbers.h"
#include "scene/material_table.h"
#include "shading/text_numbers.h"

namespace rakelight::opengl {
namespace {

/// A stage as it grows; every file begins with its number for the compiler's messages.
class StageText {
public:
    explicit StageText(std::vector<std::string>& files) : files_(files) {}
    void add(const std::string& lines) { text_ += lines; }
    void add_file(const std::string& path) { add_text(path, embedded_text(path)); }
    void add_text(const std::string& name, std::string_view text) {
        text_ += "#line 1 " + std::to_string(files_.size()) + "\n";
        files_.push_back(name);
        text_.append(text);
        text_ += "\n";
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
    std::string take() { return std::move(text_); }

private:
    std::vector<std::string>& files_;
    std::string text_;
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
        default:
            return "engines/opengl/glsl/channels_main.glsl";
    }
}

/// What both stages begin with.
void begin(StageText& stage, const Features& f, const Driver& driver, const UserLighting& user, bool is_vertex) {
    stage.add(version_of(driver) + definitions_of(f) + qualifiers(f, driver, is_vertex) + numbers_of(f));
    stage.add_lighting();
    stage.add(material_text());
    stage.add_file("engines/opengl/glsl/frame_uniforms.glsl");
    if (f.is_user) stage.add_text(user.name, user.text);
    stage.add_file("engines/opengl/glsl/points.glsl");
}

}  // namespace

std::string_view embedded_text(std::string_view path) {
    for (const EmbeddedText& text : embedded_texts)
        if (text.path == path) return text.text;
    throw Error(ErrorCode::failed, "the program lacks its text " + std::string(path));
}

ProgramText program_text(const Features& f, const Driver& driver, const UserLighting& user) {
    ProgramText out;
    StageText vertices(out.files), pixels(out.files);
    if (f.output == Output::sky) {
        vertices.add(version_of(driver));
        vertices.add_file("engines/opengl/glsl/screen_vertex.glsl");
    } else {
        begin(vertices, f, driver, user, true);
        for (const char* const name : {"varyings", "vertices", "vertex_main"})
            vertices.add_file(std::string("engines/opengl/glsl/") + name + ".glsl");
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
    StageText vertices(out.files), pixels(out.files);
    vertices.add(version_of(driver));
    vertices.add_file("engines/opengl/glsl/screen_vertex.glsl");
    pixels.add(version_of(driver) + text);
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText display_text(const Driver& driver, int tone) {
    ProgramText out = screen_text(driver, {});
    StageText pixels(out.files);
    pixels.add(version_of(driver) + "#define RL_SHOWS_CODES " + (tone < 0 ? "1\n" : "0\n") + "#define RL_TONE " +
               std::to_string(tone) + "\n");
    pixels.add_file("math/prelude.glsl");
    pixels.add("struct Maps { float unused; };\n");
    for (const char* const path : {"image/agx_curves.glsl", "image/tone.glsl", "engines/opengl/glsl/display_main.glsl"})
        pixels.add_file(path);
    out.pixels = pixels.take();
    return out;
}

ProgramText mark_text(const Features& f, const Driver& driver) {
    ProgramText out;
    StageText vertices(out.files), pixels(out.files);
    for (StageText* const stage : {&vertices, &pixels}) {
        stage->add(version_of(driver) + definitions_of(f) + numbers_of(f) + "#define RL_IS_VERTEX " +
                   (stage == &vertices ? "1\n" : "0\n") + "#define RL_IS_REVERSED " +
                   (driver.has_reversed_depth ? "1\n" : "0\n") + "#define RL_OUTPUT_COLOR " +
                   std::to_string(int(Output::color)) +
                   "\n#define RL_CONSTANT flat\nuniform vec3 rl_view_direction;\nuniform vec4 rl_ray[3];\n");
        stage->add_file("math/prelude.glsl");
        if (stage == &vertices) stage->add_file("engines/opengl/glsl/vertices.glsl");
        stage->add_file("engines/opengl/glsl/marks_main.glsl");
    }
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText line_text(const Driver& driver) {
    ProgramText out;
    StageText vertices(out.files), pixels(out.files);
    for (StageText* const stage : {&vertices, &pixels}) {
        stage->add(version_of(driver) + "#define RL_IS_VERTEX " + (stage == &vertices ? "1\n" : "0\n") +
                   "#define RL_IS_REVERSED " + (driver.has_reversed_depth ? "1\n" : "0\n"));
        stage->add_file("engines/opengl/glsl/lines_main.glsl");
    }
    out.vertices = vertices.take(), out.pixels = pixels.take();
    return out;
}

ProgramText pose_text(const PoseFeatures& f, const Driver& driver) {
    ProgramText out;
    StageText vertices(out.files), pixels(out.files);
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

std::string with_file_names(const std::string& log, const std::vector<std::string>& files) {
    // "12:34(5): error: ..." (Mesa) and "12(34) : error ..." (NVIDIA): file, line
    static const std::regex place(R"((^|\n)(ERROR: |WARNING: )?(\d+)[:(](\d+))");
    std::string out;
    auto from = log.cbegin();
    for (std::sregex_iterator at(log.begin(), log.end(), place), end; at != end; ++at) {
        out.append(from, (*at)[0].first);
        const std::size_t number = std::strtoul((*at)[3].str().c_str(), nullptr, 10);
        out += (*at)[1].str() + (number < files.size() ? files[number] : (*at)[3].str()) + ":" + (*at)[4].str();
        from = (*at)[0].second;
    }
    return out.append(from, log.cend());
}

}  // namespace rakelight::opengl
