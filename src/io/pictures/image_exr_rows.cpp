// SPDX-License-Identifier: Apache-2.0
// OpenEXR row by row: scan lines of one part, every channel as it is, without a division by alpha.
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>

#include "io/pictures/image_codecs.h"
#include "io/pictures/image_rows.h"

namespace rakelight::io::codec {
namespace {

constexpr std::uint64_t most_header_bytes = 1 << 20;

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

}  // namespace

std::unique_ptr<RowReader> read_exr_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<ExrRows>(std::move(file), context);
}

}  // namespace rakelight::io::codec
