// SPDX-License-Identifier: Apache-2.0
// The text of a program: version, choices, the lighting text as it stands in src/lighting, the engine's own stages.
#pragma once
#include <compare>
#include <string>
#include <vector>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/programs/features.h"
#include "engines/shader_text.h"

namespace rakelight::opengl {

inline constexpr int fetch_width = 4096;  ///< [texels] a row of textures that are tables
inline constexpr int light_texels = 11;   ///< a light

/// Files that a text is made of, by the numbers of #line. Number 0 is the user's: Mesa says 0 of whatever spans several
/// tokens, and texts without the user's have no faults.
struct TextFiles {
    struct File {
        std::string name;
        int last_line = 0;  ///< of a text of the user's; else 0
    };
    std::vector<File> all{{}};
};

struct StageText {
    std::string text;
    TextFiles files;
    const std::string& user() const { return files.all[0].name; }  ///< empty: there is none
};

/// Texts of both stages.
struct ProgramText {
    StageText vertices, pixels;
    bool has_vertex_shader = false;  ///< of the user's: files.all[0] of the vertices, else the lighting is
};

/// @param user  what of it the features ask for is in the text
ProgramText program_text(const Features& features, const Driver& driver, const UserShaders& user);

/// One triangle over all pixels. @param pixels  text of the pixel stage, whole
ProgramText screen_text(const Driver& driver, const std::string& pixels);
/// A picture on the screen. @param tone  RL_TONE_...; -1: codes as they are
ProgramText display_text(const Driver& driver, int tone);
/// Lines and points of pictures: the output, from_triangles, is_parallel and what a mesh has count of the features.
ProgramText mark_text(const Features& features, const Driver& driver, const UserShaders& user);
ProgramText line_text(const Driver& driver);

/// What a program that poses vertices reads and writes.
struct PoseFeatures {
    bool has_normals = false, has_tangents = false, is_skinned = false;
    bool has_more = false;  ///< MeshPose::more_influences
    auto operator<=>(const PoseFeatures&) const = default;
};
ProgramText pose_text(const PoseFeatures& features, const Driver& driver);

/// A compiler's first error in one line, with the file's name instead of its number. Where a text of the user's is in it,
/// what the compiler finds behind that text is said of its last line.
std::string named_fault(const std::string& log, const TextFiles& files);

/// A file of the text by its path in src/, as it was when the program was built.
/// @throws Error failed: there is none
std::string_view embedded_text(std::string_view path);

}  // namespace rakelight::opengl
