// SPDX-License-Identifier: Apache-2.0
#include "drop.h"

#include <algorithm>
#include <filesystem>

#include <rakelight/io/world.h>
#include <rakelight_internal/base/file_ending.h>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

template <std::size_t n>
bool ends_in_one_of(const char* const (&endings)[n], const std::string& file) {
    const std::string ending = file_ending(file);
    return std::ranges::any_of(endings, [&](const char* one) { return ending == one; });
}

bool may_be_model(const std::string& file) {
    constexpr const char* endings[] = {"glb",   "gltf", "obj", "fbx", "dae", "3ds", "ase",
                                       "blend", "stl",  "ply", "off", "x",   "xyz", "pts"};
    return ends_in_one_of(endings, file) || is_world_file(file);
}

bool is_radiance(const std::string& file) {
    constexpr const char* endings[] = {"hdr", "exr"};
    return ends_in_one_of(endings, file);
}

bool is_picture(const std::string& file) {
    constexpr const char* endings[] = {"png", "jpg", "jpeg", "webp", "tga", "bmp"};
    return ends_in_one_of(endings, file);
}

bool is_folder(const std::string& path) {
    std::error_code fault;
    return fs::is_directory(path, fault);
}

}  // namespace

DropPlan plan_of_drop(const std::vector<std::string>& files, bool is_shift_down) {
    DropPlan plan;
    std::string unknown;
    for (const std::string& file : files) {
        if (is_folder(file) || may_be_model(file))
            for (std::string& model : models_in(file)) plan.models.push_back(std::move(model));
        else if (is_radiance(file) || (is_picture(file) && is_shift_down))
            plan.environment = file;
        else if (is_picture(file))
            plan.picture = file;
        else if (unknown.empty())
            unknown = file;
    }
    if (!plan.models.empty()) {
        plan.environment.clear(), plan.picture.clear();
    } else if (plan.environment.empty() && plan.picture.empty()) {
        if (!unknown.empty()) plan.models.push_back(unknown);  // loading it says what is wrong
        plan.is_empty_folder = unknown.empty() && !files.empty();
    }
    return plan;
}

std::vector<std::string> models_in(const std::string& path) {
    if (!is_folder(path)) return {path};
    constexpr std::size_t most = 10000;
    std::error_code fault;
    std::vector<std::string> files;
    for (fs::directory_iterator at(path, fault), end; !fault && at != end && files.size() < most; at.increment(fault))
        if (may_be_model(at->path().string()) && !is_folder(at->path().string())) files.push_back(at->path().string());
    std::ranges::sort(files);
    return files;
}

}  // namespace rakelight::viewer
