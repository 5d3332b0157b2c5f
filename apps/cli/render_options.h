// SPDX-License-Identifier: Apache-2.0
// The options of `rakelight render` as words, and what they mean.
#pragma once
#include <string>
#include <vector>

#include <rakelight/picture.h>

#include "scene_options.h"
#include "subdivision_options.h"
#include "surface_options.h"

namespace CLI {
class App;
}

namespace rakelight::cli {

/// The words as given; empty where not given.
struct RenderWords {
    std::string output, engine, resolution, window, background, channels, channel_files, exr_colors;
    std::vector<std::string> shading;
    SurfaceWords surface;
    SceneWords scene;
    SubdivisionWords subdivision;
    std::string front_face, cull, visibility, interpolation, samples, anisotropy;
    std::string line_width, line_color, points, point_size;
    std::string normals, crease_angle, weight, uv, tangents, orthogonalize;
    std::string displacement_edge, displacement_triangles;
    std::string view, camera, position, focal_point, up, view_angle, horizontal_angle, near, far;
    bool orthographic = false, keep_instances = false, stats = false, edges = false, wireframe = false,
         point_sprites = false;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_render_options(CLI::App& app, RenderWords& words);
/// For verbs that look into surfaces: --edges and the like are refused with their own message, so the help leaves them
/// out.
void hide_drawn_lines(CLI::App& app);

/// The part about normals and tangents; `which` is the help for --normals.
void add_normal_options(CLI::App& app, const char* which, RenderWords& words);

/// The part that says where the camera stands.
void add_view_options(CLI::App& app, const char* group, RenderWords& words);

/// What was given, by keys of [render].
std::vector<WorldValue> values_of(const RenderWords& words);

/// @throws Error usage
void apply(const RenderWords& words, PictureRequest& request);

}  // namespace rakelight::cli
