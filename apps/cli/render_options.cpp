// SPDX-License-Identifier: Apache-2.0
// The words of `rakelight render` as the keys of [render] that they are.
#include "render_options.h"

#include <rakelight/version.h>

#include "values.h"

namespace rakelight::cli {
namespace {

struct WordOfKey {
    const char* key;
    std::string RenderWords::*word;
};
constexpr WordOfKey words_of_keys[] = {
    {"engine", &RenderWords::engine},
    {"resolution", &RenderWords::resolution},
    {"window", &RenderWords::window},
    {"samples", &RenderWords::samples},
    {"anisotropy", &RenderWords::anisotropy},
    {"background", &RenderWords::background},
    {"channels", &RenderWords::channels},
    {"channel-files", &RenderWords::channel_files},
    {"exr-colors", &RenderWords::exr_colors},
    {"front-face", &RenderWords::front_face},
    {"cull", &RenderWords::cull},
    {"visibility", &RenderWords::visibility},
    {"interpolation", &RenderWords::interpolation},
    {"points", &RenderWords::points},
    {"line-width", &RenderWords::line_width},
    {"point-size", &RenderWords::point_size},
    {"line-color", &RenderWords::line_color},
    {"normals", &RenderWords::normals},
    {"crease-angle", &RenderWords::crease_angle},
    {"weight", &RenderWords::weight},
    {"uv", &RenderWords::uv},
    {"tangents", &RenderWords::tangents},
    {"orthogonalize", &RenderWords::orthogonalize},
    {"displacement-edge", &RenderWords::displacement_edge},
    {"displacement-triangles", &RenderWords::displacement_triangles},
    {"view", &RenderWords::view},
    {"camera-index", &RenderWords::camera},
    {"camera-position", &RenderWords::position},
    {"camera-focal-point", &RenderWords::focal_point},
    {"camera-view-up", &RenderWords::up},
    {"camera-view-angle", &RenderWords::view_angle},
    {"camera-horizontal-angle", &RenderWords::horizontal_angle},
    {"near", &RenderWords::near},
    {"far", &RenderWords::far},
};

struct FlagOfKey {
    const char* key;
    bool RenderWords::*flag;
};
constexpr FlagOfKey flags_of_keys[] = {
    {"edges", &RenderWords::edges},
    {"wireframe", &RenderWords::wireframe},
    {"point-sprites", &RenderWords::point_sprites},
    {"camera-orthographic", &RenderWords::orthographic},
    {"keep-instances", &RenderWords::keep_instances},
};

void check_engine(const std::string& name) {
    std::string all;
    for (const std::string& known : build_info().engines) {
        if (name == known) return;
        all += (all.empty() ? "" : ", ") + known;
    }
    throw wrong("engine", "'" + one_line(name, 40) + "' is not built in", "this build has: " + all);
}

}  // namespace

std::vector<WorldValue> values_of(const RenderWords& words) {
    std::vector<WorldValue> values;
    for (const WordOfKey& of : words_of_keys)
        if (!(words.*of.word).empty()) values.push_back({.key = of.key, .words = {words.*of.word}});
    for (const FlagOfKey& of : flags_of_keys)
        if (words.*of.flag) values.push_back({.key = of.key, .words = {"on"}});
    if (!words.shading.empty()) values.push_back({.key = "shading", .words = words.shading});
    add_values(words.surface, values);
    add_values(words.subdivision, values);
    add_values(words.scene, values);
    return values;
}

void apply(const RenderWords& words, PictureRequest& request) {
    request.output = words.output;
    read_render_keys(values_of(words), request);
    check_engine(request.engine);
}

}  // namespace rakelight::cli
