// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <string_view>
#include <vector>

#include <rakelight/scene/words.h>

#include "base/format_text.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

std::string list_of_cameras(const Scene& scene) {
    if (scene.cameras.empty()) return "the model has none";
    std::vector<std::string> cameras;
    for (const Camera& camera : scene.cameras)
        cameras.push_back(format_text("{} '{}'", cameras.size(), one_line(camera.name, 24)));
    return format_text("the model has {}: {}", cameras.size(), list_of_names(cameras));
}

}  // namespace

std::size_t find_camera(const Scene& scene, const std::string& wanted) {
    std::size_t number = 0;
    const auto [end, fault] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (fault == std::errc() && end == wanted.data() + wanted.size() && number < scene.cameras.size()) return number;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        if (scene.cameras[i].name == wanted) return i;
        names.push_back(scene.cameras[i].name);
    }
    const std::string meant = nearest_word(wanted, names);
    throw Error(ErrorCode::usage, "there is no camera '" + one_line(wanted, 60) + "'", {},
                meant.empty() ? list_of_cameras(scene) : "did you mean '" + one_line(meant, 60) + "'?")
        .about("camera-index");
}

}  // namespace rakelight
