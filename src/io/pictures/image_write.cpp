// SPDX-License-Identifier: Apache-2.0
// Which writer a file name's ending asks for.
#include <algorithm>
#include <array>
#include <utility>

#include <programs/base/file_ending.h>

#include "base/format_text.h"
#include "io/pictures/image_codecs.h"

namespace rakelight::io {
namespace {

constexpr int max_written_side = 65536;

using MakeWriter = std::unique_ptr<ImageWriter> (*)(const OutputTarget&, int, int, int, Component);

struct Ending {
    const char* name;
    Component component;
    MakeWriter make;
};

constexpr std::array endings{
    Ending{"png", Component::u8, codec::write_png},   Ending{"jpg", Component::u8, codec::write_jpeg},
    Ending{"jpeg", Component::u8, codec::write_jpeg}, Ending{"webp", Component::u8, codec::write_webp},
    Ending{"ppm", Component::u8, codec::write_ppm},   Ending{"exr", Component::f32, codec::write_exr},
    Ending{"hdr", Component::f32, codec::write_hdr}};

const Ending& ending_of(const std::string& path) {
    const std::string name = file_ending(path);
    std::string all;
    for (const Ending& ending : endings) {
        if (name == ending.name) return ending;
        all += (all.empty() ? "." : ", .") + std::string(ending.name);
    }
    throw Error(ErrorCode::usage, "a picture file cannot end in '" + one_line(name, 40) + "'", {},
                "use one of " + all + "; of movies .mp4, .webm, .gif, .apng, .webp")
        .with_file(path);
}

}  // namespace

Component component_for(const std::string& path) { return ending_of(path).component; }

namespace {

void check_written_size(const std::string& path, int width, int height, std::size_t channels, std::size_t most) {
    if (width < 1 || height < 1 || width > max_written_side || height > max_written_side || channels < 1 ||
        channels > most)
        throw Error(ErrorCode::usage, format_text("a picture of {} x {} pixels with {} channels cannot be written",
                                                  width, height, channels))
            .with_file(path);
}

}  // namespace

std::unique_ptr<ImageWriter> make_image_writer(const OutputTarget& target, int width, int height, int channels,
                                               Component component) {
    const Ending& ending = ending_of(target.path);
    const bool is_deep_png = component == Component::u16 && ending.make == codec::write_png;
    if (component != ending.component && !is_deep_png)
        throw Error(ErrorCode::usage, std::string("a .") + ending.name + " picture cannot hold such components")
            .with_file(target.path);
    check_written_size(target.path, width, height, std::size_t(std::max(channels, 0)), 4);
    return ending.make(target, width, height, channels, component);
}

std::unique_ptr<ImageWriter> make_exr_writer(const OutputTarget& target, int width, int height,
                                             std::vector<ExrChannel> channels) {
    check_written_size(target.path, width, height, channels.size(), 1024);
    if (target.place.width != 0)
        check_written_size(target.path, target.place.width, target.place.height, channels.size(), 1024);
    return codec::write_exr_channels(target, width, height, std::move(channels));
}

void write_image(OutputTarget target, const Pixels& pixels, Sync sync) {
    target.is_data |= pixels.is_linear;
    const auto writer = make_image_writer(target, pixels.width, pixels.height, pixels.channels, pixels.component);
    for (int y = 0; y < pixels.height; ++y) writer->write_row(pixels.row(y));
    writer->finish(sync);
}

}  // namespace rakelight::io
