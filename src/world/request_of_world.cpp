// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <rakelight/request.h>

namespace rakelight {
namespace {

/// Names of files count from the world's folder.
void resolve(WorldValue& value, const std::string& world, bool allow_outside) {
    for (std::string& word : value.words) {
        std::string file = resolve_in_world(world, word, allow_outside);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored))
            throw Error(ErrorCode::not_found, "'" + one_line(word, 80) + "': there is no such file");
        word = std::move(file);
    }
}

void check(const WorldValue& value, const RenderKey* key) {
    if (value.key == "material")
        throw Error(ErrorCode::bad_file, "'material' is no key of [render]", {}, "[[material]] changes materials");
    if (key == nullptr) return;  // read_render_keys() says so
    const bool is_flag = key->kind == RenderKey::Kind::flag || key->kind == RenderKey::Kind::switched;
    if (is_flag && value.words != std::vector<std::string>{"on"} && value.words != std::vector<std::string>{"off"})
        throw Error(ErrorCode::bad_file, "'" + value.key + "' must be true or false");
}

/// An error about a value of the world, with its place.
Error placed(const Error& error, std::span<const WorldValue> values, const std::string& path) {
    std::vector<std::string> settings = error.related();
    settings.insert(settings.begin(), error.setting().substr(0, error.setting().find(' ')));
    for (const std::string& setting : settings)
        if (const auto value = std::ranges::find(values, setting, &WorldValue::key); value != values.end())
            return Error(ErrorCode::bad_file, error.reason(), to_text(value->place), error.advice())
                .about(error.setting(), error.related())
                .with_file(path);
    return Error(ErrorCode::bad_file, error.reason(), error.place(), error.advice()).with_file(path);
}

}  // namespace

PictureRequest request_of_world(const std::string& path, const LoadOptions& options, Context& context) {
    std::vector<WorldValue> values = read_world(path, context).render;
    for (WorldValue& value : values) {
        try {
            const RenderKey* const key = find_render_key(value.key);
            check(value, key);
            if (key && key->kind == RenderKey::Kind::file) resolve(value, path, options.allow_outside);
        } catch (const Error& error) {
            throw Error(error.code(), error.reason(), to_text(value.place), error.advice()).with_file(path);
        }
    }
    PictureRequest request;
    request.input = path;
    request.load = options;
    try {
        read_render_keys(values, request);
    } catch (const Error& error) {
        throw placed(error, values, path);
    }
    return request;
}

}  // namespace rakelight
