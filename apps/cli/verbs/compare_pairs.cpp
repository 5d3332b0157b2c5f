// SPDX-License-Identifier: Apache-2.0
#include "compare_pairs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <rakelight/tools/compare.h>
#include <rakelight/world/values.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/tools/compare_page.h>

#include "../inputs.h"
#include "../output_names.h"

namespace rakelight::cli {
namespace {

namespace fs = std::filesystem;

/// Names of the pictures in a folder, by their endings, that are not hidden.
std::set<std::string> picture_names(const std::string& folder) {
    std::set<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        const std::string name = at->path().filename().string();
        if (!name.starts_with('.') && has_picture_ending(name) && at->is_regular_file(ignored)) names.insert(name);
    }
    if (error) throw Error(ErrorCode::not_found, "cannot be read: " + error.message()).with_file(folder);
    return names;
}

std::vector<ComparedPair> pairs_of_folders(const std::string& a, const std::string& b) {
    const std::set<std::string> in_a = picture_names(a), in_b = picture_names(b);
    std::set<std::string> all = in_a;
    all.insert(in_b.begin(), in_b.end());
    if (all.empty())
        throw Error(ErrorCode::not_found, "neither this folder nor '" + one_line(b, 160) + "' contains a picture")
            .with_file(a);
    std::vector<ComparedPair> pairs;
    for (const std::string& name : all) {
        const std::string path_a = (fs::path(a) / name).string(), path_b = (fs::path(b) / name).string();
        ComparedPair pair{{path_a, {}}, {path_b, {}}, {}, {}};
        if (!in_b.contains(name))
            pair.error =
                Error(ErrorCode::check_failed, "there is no such file in '" + one_line(b, 160) + "'").with_file(path_a);
        if (!in_a.contains(name))
            pair.error =
                Error(ErrorCode::check_failed, "there is no such file in '" + one_line(a, 160) + "'").with_file(path_b);
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

ComparedSide side_of(const Run& run, const std::string& name) {
    return {name, is_scene(name) ? std::optional(request_for(run, name)) : std::nullopt};
}

/// `method` is that of engine trace; the others draw smooth edges then.
void follow_no_rays(RenderSettings& s) {
    if (s.method == RayMethod::path) s.samples = 8, s.paths = {};
    s.method = RayMethod::automatic;
}

std::vector<ComparedPair> pairs_of_engines(const Run& run) {
    const std::string list = run.given.word("engines");
    const std::vector<std::string_view> engines = values::split(list, ',');
    if (engines.size() < 2) throw values::wrong("engines", "needs two or more", "write for example --engines soft,gl");
    if (std::ranges::any_of(run.given.settings(), [](const WorldValue& v) { return v.key == "engine"; }))
        throw Error(ErrorCode::usage, "--engine and --engines exclude each other");
    std::vector<ComparedPair> pairs;
    const bool has_plain = std::ranges::find(engines, "trace") != engines.end();  // it has no look
    for (const std::string& scene : run.inputs) {
        InputRequest request = request_for(run, scene);
        if (has_plain) request.picture.look = Look::plain;
        const auto drawn_by = [&](std::string_view engine) {
            ComparedSide side{scene, request};
            side.scene->picture.engine = engine;
            if (engine != "trace") follow_no_rays(side.scene->picture.settings);
            return side;
        };
        for (std::size_t i = 1; i < engines.size(); ++i)
            pairs.push_back({drawn_by(engines[0]), drawn_by(engines[i]), {}, request.error});
    }
    return pairs;
}

std::vector<ComparedPair> pairs_of_inputs(const Run& run) {
    if (run.given.has("engines")) return pairs_of_engines(run);
    if (run.inputs.size() != 2)
        throw Error(ErrorCode::usage,
                    "compare takes two pictures, folders or scenes, not " + std::to_string(run.inputs.size()), {},
                    "see rakelight compare --help");
    const std::string &a = run.inputs[0], &b = run.inputs[1];
    if (is_folder(a) && is_folder(b)) return pairs_of_folders(a, b);
    for (const std::string* input : {&a, &b})
        if (is_folder(*input)) throw Error(ErrorCode::usage, "is a folder, but the other is not").with_file(*input);
    return {{side_of(run, a), side_of(run, b), {}, {}}};
}

/// Refuses early what would otherwise be refused only after the first picture was drawn.
void check_drawn(const Run& run, std::vector<ComparedPair>& pairs) {
    bool draws = false;
    for (ComparedPair& pair : pairs)
        for (ComparedSide* side : {&pair.a, &pair.b}) {
            if (!side->scene) continue;
            draws = true;
            try {
                if (!side->scene->error) check_drawing(side->scene->picture);
            } catch (const Error& error) {
                if (!side->scene->world || at_world_value(error, *side->scene->world).file() == error.file()) throw;
                pair.error = at_world_value(error, *side->scene->world);
            }
        }
    if (!draws && !run.given.settings().empty())
        throw Error(ErrorCode::usage, "applies to scenes, but these are pictures")
            .about(run.given.settings().front().key);
}

}  // namespace

std::vector<ComparedPair> compared_pairs(const Run& run) {
    std::vector<ComparedPair> pairs = pairs_of_inputs(run);
    check_drawn(run, pairs);
    const std::string& output = run.picture.output;
    if (output.empty()) return pairs;
    if (is_page(output)) {
        check_comparison_output(output);
        return pairs;
    }
    OutputNames names(run, pairs.size());
    for (ComparedPair& pair : pairs) {
        pair.output = names.of(pair.b.name);
        check_comparison_output(pair.output);
    }
    return pairs;
}

}  // namespace rakelight::cli
