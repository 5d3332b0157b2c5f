// SPDX-License-Identifier: Apache-2.0
#include "render/picture_files.h"

#include <filesystem>

namespace rakelight {
namespace {

/// Runs a step of writing; what goes wrong carries the file's name.
template <class Step>
auto named(const std::string& path, const Step& step) {
    try {
        return step();
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace

PixelFormat format_for(const std::string& output, bool transparent) {
    return named(output, [&] {
        return PixelFormat{io::component_for(output) == Component::f32 ? Component::f32 : Component::u8,
                           transparent ? 4 : 3};
    });
}

std::string channel_file(const std::string& output, const std::string& channel) {
    std::filesystem::path path(output);
    path.replace_extension();
    return path.string() + "." + channel + ".exr";
}

PictureFiles::PictureFiles(const std::string& output, int width, int height, PixelFormat format, std::uint32_t channels)
    : color_{output, named(output, [&] {
                 return io::make_image_writer(output, width, height, format.channels, format.component);
             })} {
    for (std::uint32_t bit = 1; bit != 0 && bit <= channels; bit <<= 1) {
        if (!(channels & bit)) continue;
        const std::string path = channel_file(output, name_of_channel(bit));
        channels_.push_back({path, named(path, [&] {
                                 return io::make_image_writer(path, width, height, components_of_channel(bit),
                                                              Component::f32);
                             })});
    }
}

void PictureFiles::write(const PictureSink& band, int rows) {
    named(color_.path, [&] {
        for (int y = 0; y < rows; ++y) color_.writer->write_row(band.color_row(y));
    });
    for (std::size_t i = 0; i < channels_.size(); ++i)
        named(channels_[i].path, [&] {
            for (int y = 0; y < rows; ++y) channels_[i].writer->write_row(band.channel_row(i, y));
        });
}

void PictureFiles::finish() {
    for (File& file : channels_) named(file.path, [&] { file.writer->finish(); });
    named(color_.path, [&] { color_.writer->finish(); });
}

std::vector<std::string> PictureFiles::channel_names() const {
    std::vector<std::string> names;
    for (const File& file : channels_) names.push_back(file.path);
    return names;
}

}  // namespace rakelight
