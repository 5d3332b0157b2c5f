// SPDX-License-Identifier: Apache-2.0
// OpenEXR: gray or RGB, with or without alpha, as floats in linear light. EXR holds colors multiplied by alpha
// ("Technical Introduction to OpenEXR", section "Alpha"); Pixels hold them apart, so they are divided here.
// Row by row: scan lines of one part, every channel as it is, without a division by alpha.
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "io/pictures/image_exr_check.h"
#include "io/pictures/image_formats.h"

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

constexpr std::uint64_t most_header_bytes = 1 << 20;  // of files read by rows

class FileInput final : public Imf::IStream {
public:
    explicit FileInput(InputFile& file) : IStream("picture"), file_(file) {}
    bool read(char to[], int count) override {
        if (count < 0 || file_.read({reinterpret_cast<std::byte*>(to), std::size_t(count)}) != std::size_t(count))
            throw std::runtime_error("it ends too early");
        return file_.position() < file_.size();
    }
    std::uint64_t tellg() override { return file_.position(); }
    void seekg(std::uint64_t position) override {
        if (position > file_.size()) throw std::runtime_error("it ends too early");
        file_.seek(position);
    }

private:
    InputFile& file_;
};

/// What the library throws, as an Error.
template <class Call>
auto called(const Call& call) {
    try {
        return call();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        bad_picture("decoding it takes more memory than there is");
    } catch (const std::exception& error) {
        bad_picture(std::string("broken EXR: ") + error.what());
    }
}

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

Pixels read_exr(std::span<const std::byte> bytes, Want want, Context& context) {
    check_exr(bytes, context);
    return called([&] {
        Pixels pixels = read_any(bytes, want, context);
        pixels.is_linear = true;
        if (want == Want::pixels) divide_by_alpha(pixels);
        return pixels;
    });
}

std::uint64_t work_of_exr(const Pixels& header, std::span<const std::byte> bytes, int, Context&) {
    const std::uint64_t values =
        std::uint64_t(header.width) * std::uint64_t(header.height) * std::uint64_t(header.channels);
    return (3 * values + 2 * bytes.size()) / 4;  // floats and further channels need more bytes
}

void check_head(InputFile& file, Context& context) {
    std::vector<std::byte> head(std::size_t(std::min(file.size(), most_header_bytes)));
    head.resize(file.read(head));
    check_exr(head, context, max_row_side);
    file.seek(0);
}

ExrType type_of(const Imf::Channel& channel) {
    if (channel.xSampling != 1 || channel.ySampling != 1)
        bad_picture("EXR channels with fewer samples than pixels are not supported");
    return channel.type == Imf::UINT ? ExrType::u32 : channel.type == Imf::HALF ? ExrType::f16 : ExrType::f32;
}

/// "Technical Introduction to OpenEXR", section "Data Compression"; the most for one that is not known.
std::uint64_t lines_a_block(Imf::Compression compression) {
    switch (compression) {
        case Imf::NO_COMPRESSION:
        case Imf::RLE_COMPRESSION:
        case Imf::ZIPS_COMPRESSION:
            return 1;
        case Imf::ZIP_COMPRESSION:
        case Imf::PXR24_COMPRESSION:
            return 16;
        case Imf::PIZ_COMPRESSION:
        case Imf::B44_COMPRESSION:
        case Imf::B44A_COMPRESSION:
        case Imf::DWAA_COMPRESSION:
            return 32;
        default:
            return 256;
    }
}

class ExrRows final : public RowReader {
public:
    ExrRows(std::unique_ptr<InputFile> file, Context& context) : file_(std::move(file)), input_(*file_) {
        check_head(*file_, context);
        called([&] { open(context); });
    }

    void read_row(void* row) override {
        called([&] { part_->readPixels(next_); });
        ++next_;
        std::copy(row_.begin(), row_.end(), static_cast<float*>(row));
    }

private:
    void open(Context& context) {
        exr_ = std::make_unique<Imf::MultiPartInputFile>(input_, 0, false);
        const Imf::Header& header = exr_->header(0);
        if (exr_->parts() != 1 || header.hasTileDescription() || (header.hasType() && Imf::isDeepData(header.type())))
            bad_picture("is an EXR picture of several parts, in tiles or deep");
        read_header(header);
        charge(context, header.compression());
        part_ = std::make_unique<Imf::InputPart>(*exr_, 0);
        set_buffer(header.dataWindow());
    }

    void read_header(const Imf::Header& header) {
        const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
        const auto side = [](int low, int high) {
            return std::uint64_t(std::max<std::int64_t>(std::int64_t(high) - low + 1, 0));
        };
        const std::uint64_t width = side(data.min.x, data.max.x), height = side(data.min.y, data.max.y);
        check_row_size(width, height);
        check_row_size(side(display.min.x, display.max.x), side(display.min.y, display.max.y));
        header_.width = int(width), header_.height = int(height);
        header_.place = {data.min.x - display.min.x, data.min.y - display.min.y,
                         int(side(display.min.x, display.max.x)), int(side(display.min.y, display.max.y))};
        header_.kind.format = RowFormat::exr, header_.kind.component = Component::f32;
        for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
            header_.kind.exr_channels.push_back({c.name(), type_of(c.channel())});
        if (header_.kind.exr_channels.empty()) bad_picture("an EXR picture without channels");
        header_.kind.channels = int(header_.kind.exr_channels.size());
        const auto* comment = header.findTypedAttribute<Imf::StringAttribute>("comments");
        if (comment) header_.kind.comment = comment->value();
    }

    /// A block of lines as the library holds it, packed and unpacked, and a row.
    void charge(Context& context, Imf::Compression compression) {
        const std::uint64_t lines = std::min(lines_a_block(compression), std::uint64_t(header_.height));
        charge_ =
            MemoryCharge(context.memory(), std::uint64_t(header_.width) * header_.kind.pixel_bytes() * (2 * lines + 1),
                         "rows of the picture");
        row_.resize(std::size_t(header_.width) * header_.kind.exr_channels.size());
    }

    /// A row stride of 0: every row comes to the same place. The library adds x times the pixel's stride.
    void set_buffer(const Imath::Box2i& data) {
        const std::vector<ExrChannel>& channels = header_.kind.exr_channels;
        const std::size_t stride = sizeof(float) * channels.size();
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const auto first = reinterpret_cast<std::uintptr_t>(row_.data() + c) -
                               std::uintptr_t(std::int64_t(data.min.x) * std::int64_t(stride));
            const Imf::PixelType type = channels[c].type == ExrType::u32 ? Imf::UINT : Imf::FLOAT;
            buffer.insert(channels[c].name, Imf::Slice(type, reinterpret_cast<char*>(first), stride, 0));
        }
        part_->setFrameBuffer(buffer);
        next_ = data.min.y;
    }

    std::unique_ptr<InputFile> file_;
    FileInput input_;
    MemoryCharge charge_;
    std::vector<float> row_;
    std::unique_ptr<Imf::MultiPartInputFile> exr_;
    std::unique_ptr<Imf::InputPart> part_;
    int next_ = 0;
};

std::unique_ptr<RowReader> read_exr_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<ExrRows>(std::move(file), context);
}

}  // namespace

constinit const ReadableFormat readable_exr = {.read = read_exr, .work = work_of_exr, .read_rows = read_exr_rows};

}  // namespace rakelight::io::codec
