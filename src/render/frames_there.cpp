// SPDX-License-Identifier: Apache-2.0
#include "render/frames_there.h"

#include <filesystem>
#include <string>

#include <rakelight/sequence.h>
#include <rakelight/tools/file_ending.h>

#include "io/file.h"
#include "io/whole_picture.h"
#include "render/picture_steps.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;

/// @throws Error as size_of_whole_picture()
bool is_as_requested(const PictureRequest& request, const std::string& path, Context& context) {
    const Window window = whole_window(request.settings);
    const io::PictureSize size{window.width, window.height};
    if (file_ending(path) != "png") return io::size_of_whole_picture(path, context) == size;
    const io::PngHeader header = io::header_of_whole_png(path, context);
    return io::PictureSize{int(header.width), int(header.height)} == size &&
           header.has_alpha() == (request.settings.background.w < 1);
}

/// What a file of this name is: there, or, if not, why it does not count.
struct Found {
    bool is_there = false;
    std::string damage{};  ///< empty: there is no such picture
};

Found found(const PictureRequest& request, const std::string& path, Context& context) {
    if (!io::is_regular_file(path)) return {};
    try {
        return {.is_there = is_as_requested(request, path, context)};
    } catch (const Error& error) {
        context.throw_if_cancelled();
        return {.damage = error.reason()};
    }
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
    std::vector<Found> all(frames.size());
    context.parallel_for(
        frames.size(), [&](std::size_t i) { all[i] = found(request, frame_name(request.output, frames[i]), context); });
    std::vector<char> there;
    for (std::size_t i = 0; i < all.size(); ++i) {
        there.push_back(all[i].is_there);
        if (!all[i].damage.empty())
            context.report().add(Remark::warning, frame_name(request.output, frames[i]), "",
                                 "is damaged, so it is drawn again: " + all[i].damage);
    }
    return there;
}

}  // namespace rakelight
