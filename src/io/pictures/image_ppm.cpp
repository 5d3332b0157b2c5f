// SPDX-License-Identifier: Apache-2.0
// PPM and PGM (Netpbm's P6 and P5): a header in text, then the bytes of the rows. For pipes.
#include <cstring>

#include "base/format_text.h"
#include "io/files/output_file.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

class PpmWriter final : public ImageWriter {
public:
    PpmWriter(const OutputTarget& target, int width, int height, int channels)
        : path_(target.path),
          width_(std::size_t(width)),
          channels_(std::size_t(channels)),
          rows_left_(height),
          file_(target) {
        const std::string comment = target.comment.empty() ? "" : "# " + target.comment + "\n";
        const std::string header =
            format_text("{}{}{} {}\n255\n", channels < 3 ? "P5\n" : "P6\n", comment, width, height);
        file_.write(std::as_bytes(std::span(header.data(), header.size())));
        row_.resize(width_ * colors());
    }

    void write_row(const void* row) override {
        const auto* from = static_cast<const std::byte*>(row);
        for (std::size_t x = 0; x < width_; ++x) std::memcpy(&row_[x * colors()], from + x * channels_, colors());
        --rows_left_;
        file_.write(row_);
    }

    void finish(Sync sync) override {
        if (rows_left_ != 0) throw Error(ErrorCode::failed, "the picture is not complete").with_file(path_);
        file_.commit(sync);
    }

private:
    std::size_t colors() const { return channels_ < 3 ? 1 : 3; }  // there is no alpha

    std::string path_;
    std::size_t width_, channels_;
    int rows_left_;
    OutputFile file_;
    std::vector<std::byte> row_;
};

std::unique_ptr<ImageWriter> write_ppm(const OutputTarget& target, int width, int height, int channels, Component) {
    return std::make_unique<PpmWriter>(target, width, height, channels);
}

}  // namespace

constinit const WritableFormat writable_ppm = {.write = write_ppm};

}  // namespace rakelight::io::codec
