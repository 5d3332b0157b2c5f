// SPDX-License-Identifier: Apache-2.0
// The files of one picture: its color and, beside it, one file a data channel. Rows go in band by band; all files
// appear together at the end or not at all.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/image_io.h"
#include "render/picture_sink.h"

namespace rakelight {

/// Format of the color file for an output name: @throws Error usage for an unknown ending.
PixelFormat format_for(const std::string& output, bool transparent);

/// "out/a.png", "depth" -> "out/a.depth.exr"
std::string channel_file(const std::string& output, const std::string& channel);

class PictureFiles {
public:
    /// Opens all files under temporary names. @throws Error failed, with the file's name
    PictureFiles(const std::string& output, int width, int height, PixelFormat format, std::uint32_t channels);
    void write(const PictureSink& band, int rows);  ///< the next `rows` rows of the picture
    void finish();
    std::vector<std::string> channel_names() const;

private:
    struct File {
        std::string path;
        std::unique_ptr<io::ImageWriter> writer;
    };
    File color_;
    std::vector<File> channels_;
};

}  // namespace rakelight
