// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <span>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "io/pictures/image_rows.h"
#include "tools/report_json.h"
#include "tools/window_bands.h"

#include <rakelight_internal/tools/join_windows.h>

namespace rakelight {
namespace {

/// A part whose header is read.
struct Part {
    std::string file;
    io::RowHeader header;
};

std::string quoted(const std::string& file) { return "'" + one_line(file, 80) + "'"; }

std::string size_text(int width, int height) { return format_text("{} x {}", width, height); }

std::string describe(const io::RowKind& kind) {
    if (kind.format == io::RowFormat::hdr) return "HDR";
    if (kind.format == io::RowFormat::png)
        return format_text("PNG of {} channels with {} bits", kind.channels, 8 * size_of(kind.component));
    std::string text = "EXR of ";
    for (const io::ExrChannel& channel : kind.exr_channels)
        text += (text.ends_with(' ') ? "" : ",") + channel.name +
                (channel.type == io::ExrType::f16   ? ":half"
                 : channel.type == io::ExrType::u32 ? ":integer"
                                                    : "");
    return one_line(text, 120);
}

void check_kind(const Part& part, const Part& first) {
    if (part.header.kind == first.header.kind) return;
    const std::string mine = describe(part.header.kind), other = describe(first.header.kind);
    const std::string reason = mine == other ? "its comment differs from that of " + quoted(first.file)
                                             : "is " + mine + ", and " + quoted(first.file) + " is " + other;
    throw Error(ErrorCode::bad_file, reason, {}, "join windows of one picture").with_file(part.file);
}

/// Its place: given by the caller, else recorded in the file. A single file without a place is the whole picture.
void place(Part& part, const WindowPart& asked, bool is_alone) {
    io::ImagePlace& place = part.header.place;
    if (asked.x >= 0 && asked.y >= 0)
        place = {asked.x, asked.y, 0, 0};
    else if (place.width == 0 && is_alone)
        place = {0, 0, part.header.width, part.header.height};
    else if (place.width == 0)
        throw Error(ErrorCode::usage, "does not record which window of a picture it is", {},
                    "name its place, as " + one_line(part.file, 80) + "@X,Y")
            .with_file(part.file);
}

std::vector<Part> read_parts(const JoinRequest& request, Context& context) {
    if (request.parts.empty()) throw Error(ErrorCode::usage, "no window is named");
    std::vector<Part> parts;
    for (const WindowPart& asked : request.parts) {
        context.throw_if_cancelled();
        Part part{asked.file, io::read_rows(asked.file, context)->header()};
        place(part, asked, request.parts.size() == 1);
        if (!parts.empty()) check_kind(part, parts[0]);
        parts.push_back(std::move(part));
    }
    return parts;
}

/// As the request says, else as the first part does that knows.
void set_size(const JoinRequest& request, std::span<const Part> parts, JoinResult& result) {
    result.width = request.width, result.height = request.height;
    const auto knows = [](const Part& part) { return part.header.place.width != 0; };
    const auto first = std::ranges::find_if(parts, knows);
    if (result.width == 0) {
        if (first == parts.end())
            throw Error(ErrorCode::usage, "the windows do not record how large the whole picture is")
                .about("resolution");
        result.width = first->header.place.width, result.height = first->header.place.height;
    }
    constexpr int most = int(io::codec::max_row_side);
    if (result.width < 1 || result.height < 1 || result.width > most || result.height > most)
        throw Error(ErrorCode::bad_file,
                    "is a window of a picture of " + size_text(result.width, result.height) + " pixels")
            .with_file(first == parts.end() ? request.output : first->file);
}

std::vector<Window> windows_of(std::span<const Part> parts, const JoinResult& whole) {
    std::vector<Window> windows;
    for (const Part& part : parts) {
        const io::RowHeader& h = part.header;
        const auto& [x, y, width, height] = h.place;
        if (width != 0 && (width != whole.width || height != whole.height))
            throw Error(ErrorCode::bad_file, "is a window of a picture of " + size_text(width, height) +
                                                 " pixels, not of " + size_text(whole.width, whole.height))
                .with_file(part.file);
        if (x < 0 || y < 0 || x > whole.width - h.width || y > whole.height - h.height)
            throw Error(ErrorCode::bad_file,
                        format_text("with its {} pixels at {},{} it extends beyond the picture of {}",
                                    size_text(h.width, h.height), x, y, size_text(whole.width, whole.height)))
                .with_file(part.file);
        windows.push_back({x, y, h.width, h.height});
    }
    return windows;
}

/// The rows of the whole picture, from top to bottom.
class JoinedRows {
public:
    JoinedRows(std::span<const Part> parts, std::span<const Window> windows, int width, int height, Context& context)
        : parts_(parts),
          windows_(windows),
          width_(width),
          height_(height),
          pixel_(parts[0].header.kind.pixel_bytes()),
          charge_(context.memory(), 2 * std::uint64_t(width) * pixel_, "rows of the picture"),
          row_(std::size_t(width) * pixel_),
          piece_(row_.size()) {}

    /// @throws Error bad_file: pixels that no part covers
    void check_cover() const {
        for (int y = 0; y < height_;) y = band_at(windows_, y, width_, height_).end;
    }

    void write_to(io::ImageWriter& writer, Context& context) {
        for (int y = 0; y < height_;) {
            const Band band = band_at(windows_, y, width_, height_);
            for (const BandPiece& piece : band.pieces)
                if (!readers_.contains(piece.window)) open(piece.window, context);
            for (; y < band.end; ++y) {
                context.throw_if_cancelled();
                context.progress("join", double(y) / height_);
                for (const BandPiece& piece : band.pieces) lay(piece, band, y);
                writer.write_row(row_.data());
            }
            std::erase_if(readers_,
                          [&](const auto& open) { return windows_[open.first].y + windows_[open.first].height <= y; });
        }
    }

private:
    void open(std::size_t number, Context& context) {
        const Part& part = parts_[number];
        std::unique_ptr<io::RowReader> reader = io::read_rows(part.file, context);
        if (reader->header().kind != part.header.kind || reader->header().width != part.header.width ||
            reader->header().height != part.header.height)
            throw Error(ErrorCode::bad_file, "changed while it was read").with_file(part.file);
        readers_.emplace(number, std::move(reader));
    }

    /// Its next row comes beside those before it, with which it has to agree.
    void lay(const BandPiece& piece, const Band& band, int y) {
        try {
            readers_.at(piece.window)->read_row(piece_.data());
        } catch (const Error& error) {
            throw error.with_file(parts_[piece.window].file);
        }
        for (int x = piece.begin; x < piece.own; ++x)
            if (std::memcmp(row_.data() + at(x), piece_.data() + at(x - piece.begin), pixel_) != 0)
                refuse_difference(piece, band, x, y);
        std::memcpy(row_.data() + at(piece.own), piece_.data() + at(piece.own - piece.begin),
                    at(piece.end - piece.own));
    }

    [[noreturn]] void refuse_difference(const BandPiece& piece, const Band& band, int x, int y) const {
        const auto other =
            std::ranges::find_if(band.pieces, [&](const BandPiece& p) { return x >= p.own && x < p.end; });
        throw Error(ErrorCode::bad_file, format_text("differs from {} at pixel {},{}, which both cover",
                                                     quoted(parts_[other->window].file), x, y))
            .with_file(parts_[piece.window].file);
    }

    std::size_t at(int columns) const { return std::size_t(columns) * pixel_; }

    std::span<const Part> parts_;
    std::span<const Window> windows_;
    int width_, height_;
    std::size_t pixel_;  ///< [bytes]
    MemoryCharge charge_;
    std::vector<std::byte> row_, piece_;
    std::map<std::size_t, std::unique_ptr<io::RowReader>> readers_;  ///< of the parts that the row meets
};

}  // namespace

JoinResult join_windows(const JoinRequest& request, Context& context) {
    JoinResult result{.output = request.output, .parts = request.parts.size()};
    try {
        const std::vector<Part> parts = read_parts(request, context);
        set_size(request, parts, result);
        const std::vector<Window> windows = windows_of(parts, result);
        JoinedRows rows(parts, windows, result.width, result.height, context);
        rows.check_cover();
        const auto writer = io::write_rows(request.output, result.width, result.height, parts[0].header.kind);
        rows.write_to(*writer, context);
        writer->finish();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.output);
    } catch (const Error& error) {
        throw error.with_file(request.output);
    }
    return result;
}

std::string to_json(std::span<const JoinRow> rows) {
    Json list = Json::array();
    for (const JoinRow& row : rows) {
        Json json = {{"output", row.result.output}};
        if (row.error)
            json["error"] = error_json(*row.error);
        else
            json.update({{"width", row.result.width}, {"height", row.result.height}, {"parts", row.result.parts}});
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.join-windows/1", std::move(list));
}

}  // namespace rakelight
