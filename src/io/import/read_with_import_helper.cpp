// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <span>

#include <rakelight/scene/validate.h>
#include <rakelight_internal/base/file_ending.h>

#include "io/files/file.h"
#include "io/import/collada_cameras.h"
#include "io/import/helper_process.h"
#include "io/import/precheck.h"
#include "io/import/scene_from_import.h"
#include "io/import/temporary_file.h"
#include "io/model_readers.h"

namespace rakelight::io {
namespace {

/// Address space of the helper: three quarters of what the data of files may take, for Assimp holds its own copy beside ours.
std::uint64_t helper_memory(const MemoryBudget& budget) { return budget.limit() / 4 * 3; }

/// A file that is large for an honest reason gets more time in proportion.
double seconds_for(std::size_t bytes, const ReadOptions& options) {
    constexpr double usual_bytes = 32 * 1024 * 1024;
    return options.import_seconds * std::max(1.0, double(bytes) / usual_bytes);
}

/// What is known of a file before the helper reads it.
struct Checked {
    std::string ending;
    HelperLimits limits;
    std::map<std::string, ColladaOptics> cameras;
};

Checked checked(const std::string& path, std::span<const std::byte> bytes, const ReadOptions& options,
                Context& context) {
    Checked out{.ending = file_ending(path), .limits = {}, .cameras = {}};
    check_before_import(out.ending, {bytes, path, context.report()});
    out.limits = {seconds_for(bytes.size(), options), helper_memory(context.memory()), options.allow_outside};
    if (out.ending == "dae") out.cameras = collada_cameras(bytes);
    return out;
}

/// Blender changes its files with each version, and Assimp knows the old ones: whatever is wrong, there is a way around it.
Error advised(const Error& e, const std::string& path) {
    if (file_ending(path) != "blend" || e.code() != ErrorCode::bad_file || !e.advice().empty())
        return e.with_file(path);
    return Error(e.code(), e.reason(), e.place(), "export glTF from Blender: File > Export > glTF 2.0").with_file(path);
}

/// @param file  what the helper reads, with the same ending as `path`
Scene import_file(const std::string& path, const std::string& file, const Checked& known, const ReadOptions& options,
                  Context& context) {
    HelperProcess helper(find_import_helper(context.import_helper()), file, known.limits, context);
    import_stream::Import import = import_stream::read_import(helper, context);
    complete_views(known.cameras, import.document.views);
    Scene scene = scene_from_import(std::move(import), path, known.ending, options, context);
    validate(scene);
    return scene;
}

Scene read(const std::string& path, const ReadOptions& options, Context& context) {
    try {
        // The bytes are let go before the helper starts.
        const Checked known = checked(path, *read_file(path, context), options, context);
        return import_file(path, path, known, options, context);
    } catch (const Error& e) {
        throw advised(e, path);
    }
}

Scene read_bytes(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context) {
    try {
        const Checked known = checked(path, *bytes, options, context);
        const TemporaryFile file("model." + known.ending, *bytes);
        return import_file(path, file.path(), known, options, context);
    } catch (const Error& e) {
        throw advised(e, path);
    }
}

}  // namespace

constinit const ModelReader import_reader = {.read_bytes = read_bytes, .read_file = read};

}  // namespace rakelight::io
