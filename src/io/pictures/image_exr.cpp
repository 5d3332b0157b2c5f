// SPDX-License-Identifier: Apache-2.0
// OpenEXR: gray or RGB, with or without alpha, as floats in linear light. EXR holds colors multiplied by alpha
// ("Technical Introduction to OpenEXR", section "Alpha"); Pixels hold them apart, so they are divided here and
// multiplied on writing. Colors are written as floats unless halves are requested: what the engine computed, and data
// needs them.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include <rakelight/base/current_error.h>

#include "io/files/output_file.h"
#include "io/pictures/image_codecs.h"

namespace rakelight::io::codec {
namespace {

class MemoryInput final : public Imf::IStream {
public:
    explicit MemoryInput(std::span<const std::byte> bytes) : IStream("picture"), bytes_(bytes) {}
    bool read(char to[], int count) override {
        if (count < 0 || at_ > bytes_.size() || bytes_.size() - at_ < std::size_t(count))
            throw std::runtime_error("it ends too early");
        std::memcpy(to, bytes_.data() + at_, std::size_t(count));
        at_ += std::size_t(count);
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t at_ = 0;
};

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

struct Layout {
    std::array<const char*, 4> names{};  // in the order of Pixels
    int channels = 0;
};

/// The unnamed layer's color. Missing ones of R, G, B count as zero.
Layout layout_of(const Imf::ChannelList& list) {
    const bool rgb = list.findChannel("R") || list.findChannel("G") || list.findChannel("B"),
               alpha = list.findChannel("A") != nullptr;
    if (!rgb && !list.findChannel("Y")) bad_picture("an EXR picture without the channels R, G, B or Y");
    Layout layout = rgb ? Layout{{"R", "G", "B", nullptr}, 3} : Layout{{"Y", nullptr, nullptr, nullptr}, 1};
    if (alpha) layout.names[std::size_t(layout.channels++)] = "A";
    for (int c = 0; c < layout.channels; ++c) {
        const Imf::Channel* channel = list.findChannel(layout.names[std::size_t(c)]);
        if (channel && (channel->xSampling != 1 || channel->ySampling != 1))
            bad_picture("EXR colors with fewer samples than pixels are not supported");
    }
    return layout;
}

void divide_by_alpha(Pixels& pixels) {
    if (pixels.channels != 2 && pixels.channels != 4) return;
    std::vector<float> row(std::size_t(pixels.width) * std::size_t(pixels.channels));
    for (int y = 0; y < pixels.height; ++y) {
        std::memcpy(row.data(), pixels.row(y), pixels.row_bytes());
        for (float* p = row.data(); p != row.data() + row.size(); p += pixels.channels) {
            const float alpha = p[pixels.channels - 1];
            if (alpha > 0 && alpha != 1)
                for (int c = 0; c + 1 < pixels.channels; ++c) p[c] /= alpha;
        }
        std::memcpy(pixels.row(y), row.data(), pixels.row_bytes());
    }
}

std::uint64_t side(int low, int high) { return std::uint64_t(std::int64_t(high) - low + 1); }

/// Luminance with two chroma channels of half the size; the library's own class turns it into RGB.
Pixels read_luminance_chroma(std::span<const std::byte> bytes, Want want, Context& context) {
    MemoryInput input(bytes);
    Imf::RgbaInputFile file(input, 0);
    const Imath::Box2i window = file.dataWindow();
    const bool alpha = (file.channels() & Imf::WRITE_A) != 0;
    Pixels pixels = make_pixels(side(window.min.x, window.max.x), side(window.min.y, window.max.y), alpha ? 4 : 3,
                                Component::f32, want, context);
    if (want == Want::header) return pixels;
    std::vector<Imf::Rgba> row{std::size_t(pixels.width)};
    std::vector<float> floats(row.size() * std::size_t(pixels.channels));
    for (int y = 0; y < pixels.height; ++y) {
        context.throw_if_cancelled();
        const std::int64_t line =
            std::int64_t(window.min.y) + y;  // the library adds base, x and y strides: row 0 is at -min
        file.setFrameBuffer(row.data() - window.min.x, 1, 0);
        file.readPixels(int(line));
        float* to = floats.data();
        for (const Imf::Rgba& p : row) {
            const float values[4] = {p.r, p.g, p.b, p.a};
            for (int c = 0; c < pixels.channels; ++c) *to++ = values[c];
        }
        std::memcpy(pixels.row(y), floats.data(), pixels.row_bytes());
    }
    return pixels;
}

Pixels read_part(Imf::MultiPartInputFile& file, Want want, Context& context) {
    Imf::InputPart part(file, 0);
    const Imath::Box2i window = part.header().dataWindow();
    const Layout layout = layout_of(part.header().channels());
    Pixels pixels = make_pixels(side(window.min.x, window.max.x), side(window.min.y, window.max.y), layout.channels,
                                Component::f32, want, context);
    if (want == Want::header) return pixels;
    Imf::FrameBuffer buffer;
    for (int c = 0; c < layout.channels; ++c)
        buffer.insert(layout.names[std::size_t(c)],
                      Imf::Slice::Make(Imf::FLOAT, pixels.bytes.data() + 4 * c, window,
                                       std::size_t(4 * layout.channels), pixels.row_bytes()));
    part.setFrameBuffer(buffer);
    constexpr std::int64_t rows_at_once = 256;  // more than a block of any compression
    for (std::int64_t y = window.min.y; y <= window.max.y; y += rows_at_once) {
        context.throw_if_cancelled();
        part.readPixels(int(y), int(std::min<std::int64_t>(y + rows_at_once - 1, window.max.y)));
    }
    return pixels;
}

Pixels read_any(std::span<const std::byte> bytes, Want want, Context& context) {
    MemoryInput input(bytes);
    Imf::MultiPartInputFile file(input, 0, false);
    const Imf::Header& header = file.header(0);
    if (header.hasType() && Imf::isDeepData(header.type())) bad_picture("deep EXR pictures are not supported");
    const Imf::ChannelList& list = header.channels();
    if (list.findChannel("RY") && list.findChannel("BY") && !list.findChannel("R"))
        return read_luminance_chroma(bytes, want, context);
    return read_part(file, want, context);
}

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

}  // namespace

Pixels read_exr(std::span<const std::byte> bytes, Want want, Context& context) {
    check_exr(bytes, context);
    try {
        Pixels pixels = read_any(bytes, want, context);
        pixels.is_linear = true;
        if (want == Want::pixels) divide_by_alpha(pixels);
        return pixels;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        bad_picture("decoding it takes more memory than there is");
    } catch (const std::exception& error) {  // the library's own
        bad_picture(std::string("broken EXR: ") + error.what());
    }
}

std::unique_ptr<ImageWriter> write_exr(const OutputTarget& target, int width, int height, int channels, Component) {
    const Layout layout =
        channels < 3 ? Layout{{"Y", "A", nullptr, nullptr}, channels} : Layout{{"R", "G", "B", "A"}, channels};
    std::vector<ExrChannel> list;
    for (int c = 0; c < channels; ++c) list.push_back({layout.names[std::size_t(c)], ExrType::f32});
    return std::make_unique<ExrWriter>(target, width, height, std::move(list), channels % 2 == 0);
}

std::unique_ptr<ImageWriter> write_exr_channels(const OutputTarget& target, int width, int height,
                                                std::vector<ExrChannel> channels) {
    return std::make_unique<ExrWriter>(target, width, height, std::move(channels), false);
}

}  // namespace rakelight::io::codec
