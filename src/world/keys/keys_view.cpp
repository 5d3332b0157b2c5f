// SPDX-License-Identifier: Apache-2.0
// Keys of the camera's placement.
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

constexpr Word<bool> side_words[] = {{"front", true},     {"back", true},    {"left", true},
                                     {"right", true},     {"top", true},     {"bottom", true},
                                     {"isometric", true}, {"default", true}, {"file", true}};

/// In the case of the table.
std::string side(const std::string& text) {
    std::vector<const char*> names;
    for (const Word<bool>& word : side_words) names.push_back(word.name);
    return names[values::word_number("view", text, names)];
}

double angle(const char* key, const std::string& text) {
    const double degrees = values::number(key, text);
    if (!(degrees > 0 && degrees < 180)) throw values::wrong(key, "must be more than 0 and less than 180 degrees");
    return radians(degrees);
}

double distance(const char* key, const std::string& text) {
    const double meters = values::number(key, text);
    if (!(meters > 0)) throw values::wrong(key, "must be more than 0 meters");
    return meters;
}

/// "+Z", "z", "-x", or a vector that is not zero.
dvec3 axis(const char* key, const std::string& text) {
    const std::size_t letter = text.size() == 2 && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    if (text.size() == letter + 1) {
        const double sign = text[0] == '-' ? -1 : 1;
        switch (text[letter] | 0x20) {
            case 'x':
                return {sign, 0, 0};
            case 'y':
                return {0, sign, 0};
            case 'z':
                return {0, 0, sign};
            default:
                break;
        }
    }
    if (text.find(',') == std::string::npos) throw values::wrong(key, "must be +X, -X, +Y, -Y, +Z, -Z or X,Y,Z");
    return values::vector3(key, text);
}

std::string axis_of(dvec3 v) {
    for (const char* word : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"})
        if (axis("up", word) == v) return word;
    return text_of(v);
}

constexpr RenderKey table_of_view[] = {
    {"view", Kind::value, [](PictureRequest& r, Words w) { r.view.side = side(w[0]); },
     [](const PictureRequest& r) -> Written { return r.view.side.empty() ? Written{} : Written{r.view.side}; }},
    RL_KEY("camera-index", value, r.view.camera, w[0], {r.view.camera}),
    RL_KEY("camera-position", value, r.view.position, values::vector3("camera-position", w[0]),
           {text_of(*r.view.position)}),
    RL_KEY("camera-focal-point", value, r.view.focal_point, values::vector3("camera-focal-point", w[0]),
           {text_of(*r.view.focal_point)}),
    RL_KEY("camera-view-up", value, r.view.up, values::vector3("camera-view-up", w[0]), {text_of(*r.view.up)}),
    RL_KEY("up", value, r.view.world_up, axis("up", w[0]), {axis_of(*r.view.world_up)}),
    RL_KEY("camera-direction", value, r.view.direction, values::vector3("camera-direction", w[0]),
           {text_of(*r.view.direction)}),
    RL_KEY("camera-azimuth-angle", value, r.view.azimuth_rad,
           radians(values::number("camera-azimuth-angle", w[0], -3600, 3600)), {degrees_of(*r.view.azimuth_rad)}),
    RL_KEY("camera-elevation-angle", value, r.view.elevation_rad,
           radians(values::number("camera-elevation-angle", w[0], -3600, 3600)), {degrees_of(*r.view.elevation_rad)}),
    RL_KEY("camera-zoom-factor", value, r.view.zoom_factor, values::number("camera-zoom-factor", w[0], 1e-3, 1e3),
           {text_of(*r.view.zoom_factor)}),
    RL_KEY("camera-view-angle", value, r.view.vertical_fov_rad, angle("camera-view-angle", w[0]),
           {degrees_of(*r.view.vertical_fov_rad)}),
    RL_KEY("camera-horizontal-angle", value, r.view.horizontal_fov_rad, angle("camera-horizontal-angle", w[0]),
           {degrees_of(*r.view.horizontal_fov_rad)}),
    RL_KEY("near", value, r.view.z_near, distance("near", w[0]), {text_of(*r.view.z_near)}),
    RL_KEY("far", value, r.view.z_far, distance("far", w[0]), {text_of(*r.view.z_far)}),
    RL_KEY("camera-orthographic", flag, r.view.orthographic, w[0] == "on", {"on"}),
};

}  // namespace

constinit const KeyTable view_keys = table_of_view;

}  // namespace rakelight::keys
