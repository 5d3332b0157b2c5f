// SPDX-License-Identifier: Apache-2.0
// The text of a program: version, choices, the lighting text as it stands in src/lighting, the engine's own stages.
#pragma once
#include <compare>
#include <string>
#include <vector>

#include "engines/opengl/driver.h"
#include "engines/opengl/features.h"

namespace rakelight::opengl {

inline constexpr int fetch_width = 4096;  ///< [texels] a row of textures that are tables
inline constexpr int light_texels = 11;   ///< a light

/// Texts of both stages.
struct ProgramText {
    std::string vertices, pixels;
    std::vector<std::string> files;  ///< by the numbers of #line
};

/// A lighting model of the user's: its name (file) and text; empty: none.
struct UserLighting {
    std::string name, text;
};

ProgramText program_text(const Features& features, const Driver& driver, const UserLighting& user);

/// One triangle over all pixels. @param pixels  text of the pixel stage, whole
ProgramText screen_text(const Driver& driver, const std::string& pixels);
/// A picture on the screen. @param tone  RL_TONE_...; -1: codes as they are
ProgramText display_text(const Driver& driver, int tone);
/// Lines and points of pictures: the output, from_triangles, is_parallel and what a mesh has count of the features.
ProgramText mark_text(const Features& features, const Driver& driver);
ProgramText line_text(const Driver& driver);

/// What a program that poses vertices reads and writes.
struct PoseFeatures {
    bool has_normals = false, has_tangents = false, is_skinned = false;
    bool has_more = false;  ///< MeshPose::more_influences
    auto operator<=>(const PoseFeatures&) const = default;
};
ProgramText pose_text(const PoseFeatures& features, const Driver& driver);

/// A compiler's words with the files' names instead of their numbers.
std::string with_file_names(const std::string& log, const std::vector<std::string>& files);

/// A file of the text by its path in src/, as it was when the program was built.
/// @throws Error failed: there is none
std::string_view embedded_text(std::string_view path);

}  // namespace rakelight::opengl
