// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a picture before anything is loaded.
#include <cmath>
#include <filesystem>

#include "engines/check_settings.h"
#include "render/engines.h"
#include "render/picture_files.h"

#include <rakelight/picture.h>

namespace rakelight {
namespace {

void check_output(const PictureRequest& request) {
    const PixelFormat format = format_for(request.output, request.settings.background.w < 1);
    std::string ending = std::filesystem::path(request.output).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    if (format.channels == 4 && (ending == ".jpg" || ending == ".jpeg" || ending == ".hdr"))
        throw Error(ErrorCode::usage, "this format has no alpha for a transparent background", {},
                    "use .png, .webp or .exr");
    std::error_code ignored;
    const std::filesystem::path path(request.output);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(ErrorCode::failed, "the folder '" + one_line(folder.string(), 160) + "' does not exist", {},
                    "create it first");
    if (std::filesystem::is_directory(path, ignored)) throw Error(ErrorCode::failed, "a folder has this name");
}

}  // namespace

void check_request(const PictureRequest& request) {
    check_engine_name(request.engine);
    check_settings(request.settings);
    if (!(request.light_cutoff >= 0 && request.light_cutoff <= 1))
        throw Error(ErrorCode::usage, "the light cutoff must be 0 to 1");
    if (!(request.light_intensity >= 0 && std::isfinite(request.light_intensity)))
        throw Error(ErrorCode::usage, "the intensity of the lights must be a number >= 0");
    (void)ToneCurve(request.tone);  // an exposure that cannot be
    try {
        check_output(request);
    } catch (const Error& error) {
        throw error.with_file(request.output);
    }
}

}  // namespace rakelight
