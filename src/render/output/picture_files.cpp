// SPDX-License-Identifier: Apache-2.0
#include "render/output/picture_files.h"

#include <bit>
#include <cstring>
#include <filesystem>

#include <rakelight_internal/base/file_ending.h>

#include "render/channel_view.h"

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

io::ExrType type_of(const ChannelInfo& info, bool half) {
    return info.is_integer()                         ? io::ExrType::u32
           : info.kind == ChannelKind::color && half ? io::ExrType::f16
                                                     : io::ExrType::f32;
}

/// R, G, B and, for four, A.
std::vector<io::ExrChannel> color_channels(int count, bool half) {
    std::vector<io::ExrChannel> list;
    list.reserve(std::size_t(count));
    for (int c = 0; c < count; ++c)
        list.push_back({std::string(1, "RGBA"[c]), half ? io::ExrType::f16 : io::ExrType::f32});
    return list;
}

/// A number as files of one channel hold it.
std::uint32_t float_word(const ChannelInfo& info, std::uint32_t number) {
    return std::bit_cast<std::uint32_t>(info.kind == ChannelKind::number && number == no_index ? -1.0f : float(number));
}

}  // namespace

PixelFormat format_for(const std::string& output, bool transparent) {
    return named(output, [&] {
        return PixelFormat{io::component_for(output) == Component::f32 ? Component::f32 : Component::u8,
                           transparent ? 4 : 3};
    });
}

Window whole_window(const RenderSettings& s) {
    return s.window.width == 0 ? Window{0, 0, s.width, s.height} : s.window;
}

io::ImagePlace place_of(const RenderSettings& settings) {
    const Window window = whole_window(settings);
    return {window.x, window.y, settings.width, settings.height};
}

std::string comment_of(const RenderSettings& settings) {
    if (settings.method != RayMethod::path || !settings.paths.denoise) return {};
    return "rakelight: denoised by joint NL-means filtering (Rousselle, Manzi, Zwicker 2013)";
}

bool is_exr(const std::string& path) { return file_ending(path) == "exr"; }

void check_alpha(const std::string& path, const PixelFormat& format) {
    const std::string ending = file_ending(path);
    if (format.channels == 4 && (ending == "jpg" || ending == "jpeg" || ending == "ppm" || ending == "hdr"))
        throw Error(ErrorCode::usage, "this format has no alpha for a transparent background", {},
                    "use .png, .webp or .exr");
}

std::unique_ptr<io::ImageWriter> make_color_writer(const io::OutputTarget& target, int width, int height,
                                                   PixelFormat format, bool half) {
    return is_exr(target.path) ? io::make_exr_writer(target, width, height, color_channels(format.channels, half))
                               : io::make_image_writer(target, width, height, format.channels, format.component);
}

std::string channel_file(const std::string& output, const std::string& channel, const std::string& ending) {
    std::filesystem::path path(output);
    path.replace_extension();
    return path.string() + "." + channel + ending;
}

std::vector<std::string> channel_files_of(const std::string& output, std::uint32_t channels, std::uint32_t files) {
    std::vector<std::string> names;
    if (channels != 0 && (files & channel_files_layers) && !is_exr(output))
        names.push_back(channel_file(output, "channels"));
    for (const ChannelInfo& info : all_channels()) {
        if (!(channels & info.channel)) continue;
        if (files & channel_files_exr) names.push_back(channel_file(output, info.word));
        if (files & channel_files_png) names.push_back(channel_file(output, info.word, ".png"));
    }
    return names;
}

PictureFiles::PictureFiles(const std::string& output, int width, int height, PixelFormat format,
                           const ChannelWishes& wishes, io::ImagePlace place)
    : output_(output), width_(width), height_(height), format_(format), place_(place) {
    const bool layers = wishes.channels != 0 && (wishes.files & channel_files_layers),
               inside = layers && is_exr(output);
    needs_linear_ = layers && !inside;
    if (inside)
        add_layers(output, wishes);
    else
        add_color(wishes);
    std::size_t plane = 0;
    for (const ChannelInfo& info : all_channels())
        if ((wishes.channels & info.channel) && (wishes.files & channel_files_exr))
            add_exr(info.channel, plane++, wishes.half_colors);
    if (needs_linear_) add_layers(channel_file(output, "channels"), wishes);
    plane = 0;
    for (const ChannelInfo& info : all_channels())
        if ((wishes.channels & info.channel) && (wishes.files & channel_files_png))
            add_png(info.channel, plane++, wishes.range);
}

io::OutputTarget PictureFiles::target(const std::string& path) const {
    io::OutputTarget target(path);
    target.place = place_;
    return target;
}

io::OutputTarget PictureFiles::color_target(const std::string& path, const ChannelWishes& wishes) const {
    io::OutputTarget color = target(path);
    color.comment = wishes.comment, color.memory = wishes.memory;
    return color;
}

void PictureFiles::add(std::vector<File>& to, const std::string& path,
                       const std::function<std::unique_ptr<io::ImageWriter>()>& make, Row row) {
    to.push_back({path, named(path, make), std::move(row)});
}

void PictureFiles::add_color(const ChannelWishes& wishes) {
    add(
        color_, output_,
        [&] { return make_color_writer(color_target(output_, wishes), width_, height_, format_, wishes.half_colors); },
        [](const PictureSink& strip, int y) -> const void* { return strip.color_row(y); });
}

void PictureFiles::add_exr(std::uint32_t channel, std::size_t plane, bool half) {
    const ChannelInfo& info = info_of(channel);
    const int components = info.components();
    std::vector<io::ExrChannel> list =
        components == 1 ? std::vector<io::ExrChannel>{{"Y"}} : color_channels(components, false);
    if (type_of(info, half) == io::ExrType::f16)
        for (io::ExrChannel& c : list) c.type = io::ExrType::f16;
    const std::string path = channel_file(output_, info.word);
    Row row = [plane](const PictureSink& strip, int y) -> const void* { return strip.channel_row(plane, y); };
    if (info.is_integer())
        row = [plane, &info, values = std::vector<std::uint32_t>(std::size_t(width_))](const PictureSink& strip,
                                                                                       int y) mutable -> const void* {
            const std::uint32_t* from = strip.channel_row(plane, y);
            for (std::uint32_t& value : values) value = float_word(info, *from++);
            return values.data();
        };
    add(
        channels_, path, [&] { return io::make_exr_writer(target(path), width_, height_, std::move(list)); },
        std::move(row));
}

void PictureFiles::add_layers(const std::string& path, const ChannelWishes& wishes) {
    std::vector<io::ExrChannel> list = color_channels(format_.channels, wishes.half_colors);
    for (const ChannelInfo& info : all_channels())
        for (const char* part = info.parts; (wishes.channels & info.channel) && *part; ++part)
            list.push_back({std::string(info.layer) + "." + *part, type_of(info, wishes.half_colors)});
    const std::size_t step = list.size(), width = std::size_t(width_), colors = std::size_t(format_.channels);
    Row row = [=, linear = needs_linear_, values = std::vector<std::uint32_t>(step * width)](
                  const PictureSink& strip, int y) mutable -> const void* {
        std::size_t at = 0;
        const auto put = [&](const void* from, std::size_t components) {
            const auto* bytes = static_cast<const std::byte*>(from);
            const std::size_t size = components * sizeof(std::uint32_t);
            for (std::size_t x = 0; x < width; ++x) std::memcpy(&values[x * step + at], bytes + x * size, size);
            at += components;
        };
        put(linear ? static_cast<const void*>(strip.linear_row(y)) : strip.color_row(y), colors);
        for (std::size_t p = 0; p < strip.planes().size(); ++p)
            put(strip.channel_row(p, y), std::size_t(strip.planes()[p].components));
        return values.data();
    };
    add(
        path == output_ ? color_ : channels_, path,
        [&] { return io::make_exr_writer(color_target(path, wishes), width_, height_, std::move(list)); },
        std::move(row));
}

void PictureFiles::add_png(std::uint32_t channel, std::size_t plane, const ChannelRange& range) {
    const ChannelInfo& info = info_of(channel);
    const std::string path = channel_file(output_, info.word, ".png");
    add(
        channels_, path, [&] { return io::make_image_writer(target(path), width_, height_, 3, Component::u8); },
        [=, &info, rgb = std::vector<std::uint8_t>(3 * std::size_t(width_))](const PictureSink& strip,
                                                                             int y) mutable -> const void* {
            view_row(info, range, strip.channel_row(plane, y), rgb.size() / 3, rgb.data());
            return rgb.data();
        });
}

void PictureFiles::write(const PictureSink& strip, int rows) {
    for (std::vector<File>* files : {&color_, &channels_})
        for (File& file : *files)
            named(file.path, [&] {
                for (int y = 0; y < rows; ++y) file.writer->write_row(file.row(strip, y));
            });
}

void PictureFiles::finish() {
    for (std::vector<File>* files : {&channels_, &color_})
        for (File& file : *files) named(file.path, [&] { file.writer->finish(); });
}

std::vector<std::string> PictureFiles::channel_names() const {
    std::vector<std::string> names;
    for (const File& file : channels_) names.push_back(file.path);
    return names;
}

}  // namespace rakelight
