// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "io/file.h"
#include "io/import/collada_cameras.h"
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

/// A file that is large for an honest reason gets more time in proportion.
double seconds_for(std::size_t bytes, const ReadOptions& options) {
    constexpr double usual_bytes = 32 * 1024 * 1024;
    return options.import_seconds * std::max(1.0, double(bytes) / usual_bytes);
}

Scene read_checked(const std::string& path, const ReadOptions& options, Context& context) {
    const std::string ending = ending_of(path);
    HelperLimits limits;
    std::map<std::string, ColladaOptics> cameras;
    {
        const Bytes bytes = read_file(path, context);  // let go before the helper starts
        check_before_import(ending, {*bytes, path, context.report()});
        limits.seconds = seconds_for(bytes->size(), options);
        if (ending == "dae") cameras = collada_cameras({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    }
    limits.memory_bytes = helper_memory(context.memory());
    limits.allow_outside = options.allow_outside;
    HelperProcess helper(find_import_helper(), path, limits, context);
    import_stream::Import import = import_stream::read_import(helper, context);
    complete_views(cameras, import.document.views);
    Scene scene = scene_from_import(std::move(import), path, ending, options, context);
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
