// SPDX-License-Identifier: Apache-2.0
#include "io/file.h"
#include "io/import/helper_process.h"
#include "io/import/precheck.h"
#include "io/import/scene_from_import.h"
#include "io/reader.h"
#include "scene/scene_tools.h"

namespace rakelight::io {
namespace {

std::string ending_of(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return ending;
}

/// Address space of the helper: three quarters of what the data of files may take, for Assimp holds its own copy beside ours.
std::uint64_t helper_memory(const MemoryBudget& budget) { return budget.limit() / 4 * 3; }

Scene read_checked(const std::string& path, const ReadOptions& options, Context& context) {
    const std::string ending = ending_of(path);
    {
        const Bytes bytes = read_file(path, context);  // let go before the helper starts
        check_before_import(ending, {*bytes, path, context.report()});
    }
    HelperLimits limits;
    limits.seconds = options.import_seconds;
    limits.memory_bytes = helper_memory(context.memory());
    limits.allow_outside = options.allow_outside;
    HelperProcess helper(find_import_helper(), path, limits, context);
    Scene scene = scene_from_import(import_stream::read_import(helper, context), path, ending, options, context);
    validate(scene);
    return scene;
}

}  // namespace

Scene read_with_import_helper(const std::string& path, const ReadOptions& options, Context& context) {
    try {
        return read_checked(path, options, context);
    } catch (const Error& e) {
        throw e.with_file(path);
    }
}

}  // namespace rakelight::io
