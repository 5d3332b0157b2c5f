// SPDX-License-Identifier: Apache-2.0
// The files of one picture: its color and its data channels. Rows are added strip by strip; all files appear together
// at the end or not at all.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/pictures/image_io.h"
#include "render/output/picture_sink.h"

#include <rakelight/render/picture.h>

namespace rakelight {

/// Format of the color file for an output name: @throws Error usage for an unknown ending.
PixelFormat format_for(const std::string& output, bool transparent);

/// The window that is rendered: the whole picture where none is requested.
Window whole_window(const RenderSettings& settings);
/// Where that is in the whole picture.
io::ImagePlace place_of(const RenderSettings& settings);
/// The color settings that a reader of the file needs.
std::string comment_of(const RenderSettings& settings);

/// By the ending of its name.
bool is_exr(const std::string& path);

/// @throws Error usage: a transparent picture in a format without alpha
void check_alpha(const std::string& path, const PixelFormat& format);

/// Takes rows of convert_row(). @throws Error usage, failed
std::unique_ptr<io::ImageWriter> make_color_writer(const io::OutputTarget& target, int width, int height,
                                                   PixelFormat format, bool half = false);

/// "out/a.png", "depth", ".exr" -> "out/a.depth.exr"
std::string channel_file(const std::string& output, const std::string& channel, const std::string& ending = ".exr");

/// The files beside a picture. @param channels, files  as in ChannelWishes
std::vector<std::string> channel_files_of(const std::string& output, std::uint32_t channels, std::uint32_t files);

/// What is written beside the color.
struct ChannelWishes {
    std::uint32_t channels = 0;               ///< Channel bits
    std::uint32_t files = channel_files_exr;  ///< ChannelFiles bits
    bool half_colors = false;
    ChannelRange range;
    std::string comment{};                     ///< into the metadata of the colors' file
    std::vector<std::byte>* memory = nullptr;  ///< destination of the color file; null: it is a file
};

class PictureFiles {
public:
    /// Opens all files under temporary names. PNG, EXR and HDR files know their place in the whole picture.
    /// @throws Error failed, with the file's name
    PictureFiles(const std::string& output, int width, int height, PixelFormat format, const ChannelWishes& wishes,
                 io::ImagePlace place = {});
    /// Whether the sink must keep linear colors.
    bool needs_linear() const { return needs_linear_; }
    void write(const PictureSink& strip, int rows);  ///< the next `rows` rows of the picture
    void finish();
    std::vector<std::string> channel_names() const;

private:
    /// Gives row y of a strip as the file's writer takes it; the memory lives until the next call.
    using Row = std::function<const void*(const PictureSink&, int y)>;
    struct File {
        std::string path;
        std::unique_ptr<io::ImageWriter> writer;
        Row row;
    };
    io::OutputTarget target(const std::string& path) const;
    io::OutputTarget color_target(const std::string& path, const ChannelWishes& wishes) const;
    void add(std::vector<File>& to, const std::string& path,
             const std::function<std::unique_ptr<io::ImageWriter>()>& make, Row row);
    void add_color(const ChannelWishes& wishes);
    void add_exr(std::uint32_t channel, std::size_t plane, bool half);
    void add_layers(const std::string& path, const ChannelWishes& wishes);
    void add_png(std::uint32_t channel, std::size_t plane, const ChannelRange& range);

    std::string output_;
    int width_, height_;
    PixelFormat format_;
    io::ImagePlace place_;
    bool needs_linear_ = false;
    std::vector<File> color_, channels_;  ///< one of color
};

}  // namespace rakelight
