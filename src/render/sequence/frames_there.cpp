// SPDX-License-Identifier: Apache-2.0
#include "render/sequence/frames_there.h"

#include <filesystem>
#include <string>

#include <rakelight/render/sequence.h>
#include <rakelight_internal/base/file_ending.h>

#include "io/files/file.h"
#include "io/pictures/whole_picture.h"
#include "render/output/picture_files.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;

/// @throws Error as size_of_whole_picture()
bool is_as_requested(const PictureRequest& request, const std::string& path, Context& context) {
    const Window window = whole_window(request.settings);
    const io::PictureSize size{window.width, window.height};
    for (const std::string& name : channel_files_of(path, request.settings.channels, request.channel_files))
        if (!io::is_regular_file(name) || io::size_of_whole_picture(name, context) != size) return false;
    if (file_ending(path) != "png") return io::size_of_whole_picture(path, context) == size;
    const io::PngHeader header = io::header_of_whole_png(path, context);
    return io::PictureSize{int(header.width), int(header.height)} == size &&
           header.has_alpha() == (request.settings.background.w < 1);
}

}  // namespace

void check_frame_names(const PictureRequest& request, std::span<const std::int64_t> frames) {
    for (const std::int64_t frame : frames) {
        const std::string path = frame_name(request.output, frame);
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored);
        if (fs::exists(status) && !fs::is_regular_file(status))
            throw Error(ErrorCode::failed,
                        fs::is_directory(status) ? "a folder has the name of a picture"
                                                 : "what has the name of a picture is not a regular file",
                        {}, "give the pictures another name")
                .with_file(path);
    }
}

std::vector<char> frames_there(const PictureRequest& request, std::span<const std::int64_t> frames, Context& context) {
    std::vector<char> there(frames.size(), false);
    const auto look = [&](std::size_t i) {
        const std::string path = frame_name(request.output, frames[i]);
        there[i] = io::is_regular_file(path) && is_as_requested(request, path, context);
    };
    const auto faults = io::faults_of_pictures(frames.size(), look, context);
    for (std::size_t i = 0; i < faults.size(); ++i)
        if (faults[i])
            context.report().add(Remark::warning, frame_name(request.output, frames[i]), "",
                                 "is damaged, so it is drawn again: " + faults[i]->reason());
    return there;
}

}  // namespace rakelight
