// SPDX-License-Identifier: Apache-2.0
// OpenEXR: colors are multiplied by alpha (image_exr_read.cpp says why), channels with names are not. Colors are written
// as floats unless halves are requested: what the engine computed, and data needs them.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include <rakelight/base/current_error.h>

#include "io/files/output_file.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

class FileOutput final : public Imf::OStream {
public:
    explicit FileOutput(std::FILE* file) : OStream("picture"), file_(file) {}
    void write(const char from[], int count) override {
        if (std::fwrite(from, 1, std::size_t(count), file_) != std::size_t(count)) fail();
    }
    std::uint64_t tellp() override { return std::uint64_t(std::ftell(file_)); }
    void seekp(std::uint64_t position) override {
        if (std::fseek(file_, long(position), SEEK_SET) != 0) fail();
    }

private:
    [[noreturn]] static void fail() { throw std::system_error(errno, std::generic_category()); }
    std::FILE* file_;
};

Imf::PixelType pixel_type(ExrType type) {
    return type == ExrType::f32 ? Imf::FLOAT : type == ExrType::f16 ? Imf::HALF : Imf::UINT;
}

/// The half that is nearest, kept finite where the float is.
void round_to_half(float& value) {
    const half rounded(value - value == 0 ? std::clamp(value, -float(HALF_MAX), float(HALF_MAX)) : value);
    const std::uint16_t bits = rounded.bits();
    std::memcpy(&value, &bits, sizeof bits);
}

/// Rows of four bytes a value; halves stand in the first two.
class ExrWriter final : public ImageWriter {
public:
    /// @param alpha  the last channel is alpha: the others are multiplied by it
    ExrWriter(const OutputTarget& target, int width, int height, std::vector<ExrChannel> channels, bool alpha)
        : path_(target.path),
          channels_(std::move(channels)),
          alpha_(alpha),
          rows_left_(height),
          file_(target),
          output_(file_.handle()),
          row_(std::size_t(width) * channels_.size()) {
        const ImagePlace place = target.place.width != 0 ? target.place : ImagePlace{0, 0, width, height};
        const Imath::Box2i whole({0, 0}, {place.width - 1, place.height - 1});
        Imf::Header header(whole, {{place.x, place.y}, {place.x + width - 1, place.y + height - 1}});
        header.compression() = Imf::ZIP_COMPRESSION;
        if (!target.comment.empty()) header.insert("comments", Imf::StringAttribute(target.comment));
        for (const ExrChannel& c : channels_) header.channels().insert(c.name, Imf::Channel(pixel_type(c.type)));
        call([&] { exr_ = std::make_unique<Imf::OutputFile>(output_, header, 0); });
        // A row stride of 0: every row is handed over in the same place. The library adds x times the pixel's stride.
        Imf::FrameBuffer buffer;
        const std::size_t stride = 4 * channels_.size();
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            const auto first = reinterpret_cast<std::uintptr_t>(row_.data() + c) - std::size_t(place.x) * stride;
            buffer.insert(channels_[c].name,
                          Imf::Slice(pixel_type(channels_[c].type), reinterpret_cast<char*>(first), stride, 0));
        }
        call([&] { exr_->setFrameBuffer(buffer); });
    }

    void write_row(const void* row) override {
        const std::size_t step = channels_.size();
        std::memcpy(row_.data(), row, row_.size() * sizeof(float));
        if (alpha_)
            for (std::size_t i = 0; i < row_.size(); i += step)
                for (std::size_t c = 0; c + 1 < step; ++c) row_[i + c] *= row_[i + step - 1];
        for (std::size_t c = 0; c < step; ++c)
            if (channels_[c].type == ExrType::f16)
                for (std::size_t i = c; i < row_.size(); i += step) round_to_half(row_[i]);
        --rows_left_;
        call([&] { exr_->writePixels(1); });
    }

    void finish(Sync sync) override {
        if (rows_left_ != 0) throw Error(ErrorCode::failed, "the picture is not complete").with_file(path_);
        call([&] { exr_.reset(); });  // writes the table of lines
        file_.commit(sync);
    }

private:
    template <class Call>
    void call(const Call& body) const {
        try {
            body();
        } catch (const std::bad_alloc&) {
            throw current_error().with_file(path_);
        } catch (const std::exception& error) {
            throw Error(ErrorCode::failed, std::string("cannot be written: ") + error.what()).with_file(path_);
        }
    }

    std::string path_;
    std::vector<ExrChannel> channels_;
    bool alpha_;
    int rows_left_;
    OutputFile file_;
    FileOutput output_;
    std::vector<float> row_;
    std::unique_ptr<Imf::OutputFile> exr_;  // goes first: it writes to the others
};

std::unique_ptr<ImageWriter> write_exr(const OutputTarget& target, int width, int height, int channels, Component) {
    static constexpr const char *gray[] = {"Y", "A"}, *color[] = {"R", "G", "B", "A"};
    const char* const* const names = channels < 3 ? gray : color;
    std::vector<ExrChannel> list;
    for (int c = 0; c < channels; ++c) list.push_back({names[c], ExrType::f32});
    return std::make_unique<ExrWriter>(target, width, height, std::move(list), channels % 2 == 0);
}

std::unique_ptr<ImageWriter> write_exr_channels(const OutputTarget& target, int width, int height,
                                                std::vector<ExrChannel> channels) {
    return std::make_unique<ExrWriter>(target, width, height, std::move(channels), false);
}

}  // namespace

constinit const WritableFormat writable_exr = {
    .component = Component::f32, .write = write_exr, .write_channels = write_exr_channels};

}  // namespace rakelight::io::codec
