// SPDX-License-Identifier: Apache-2.0
#include "io/obj/write/rewrite_normals.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>

#include "io/files/beside.h"
#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/obj/material_files.h"
#include "io/obj/mtl_materials.h"
#include "io/obj/obj_numbers.h"
#include "io/obj/write/kept_obj.h"
#include "io/obj/write/new_normals.h"
#include "io/obj/write/text_buffer.h"

namespace rakelight::io {
namespace obj {
namespace {

/// As the reader keeps it, of a file that was read without.
std::shared_ptr<const KeptObj> read_again(const std::string& path, const ReadOptions& options, Context& context,
                                          std::size_t chunk_bytes) {
    const auto file = std::make_shared<KeptObj>();
    file->bytes = read_file(path, context);
    file->text = std::make_shared<const PlainText>(
        std::string_view(reinterpret_cast<const char*>(file->bytes->data()), file->bytes->size()), path, context);
    const std::string_view text = file->text->view();
    Remarks remarks(path);  // made when the scene was read
    file->contents = count_contents(text, remarks, context, chunk_bytes);
    if (file->contents.elements == 0) return file;
    Scene scratch;  // the library tells names of one material apart as the reader did
    MaterialLibrary library(scratch, path, options.allow_outside, context);
    for (const std::string& argument : file->contents.libraries) library.load(argument);
    file->data = read_vertices(text, file->contents, remarks, context);
    const FindMaterial find = [&](const std::string& name, std::uint64_t line) { return library.find(name, line); };
    const std::string stem = std::filesystem::path(path).stem().string();
    file->elements = read_elements(text, file->contents, file->data, stem, find, remarks, context, true);
    return file;
}

/// A piece of the new file: lines of the old one, or normals of a block.
struct Piece {
    std::size_t chunk = 0;               ///< that the lines stand in
    Chunk text;                          ///< the lines
    std::uint64_t written = 0;           ///< normals before it in the new file
    const NormalBlock* block = nullptr;  ///< null: lines
    std::size_t first = 0, count = 0;    ///< of the block's normals
};

/// The pieces in the order of the file.
std::vector<Piece> pieces_of(const Contents& contents, const NewNormals& normals) {
    constexpr std::size_t normals_a_piece = 1 << 14;
    std::vector<Piece> pieces;
    std::uint64_t written = 0;
    std::size_t next = 0;
    for (std::size_t c = 0; c < contents.chunks.size(); ++c) {
        Chunk rest = contents.chunks[c].chunk;
        for (; next < normals.write_order.size(); ++next) {
            const NormalBlock& block = normals.blocks[normals.write_order[next]];
            if (block.at >= rest.end) break;
            pieces.push_back({c, {rest.begin, block.at}, written});
            for (std::size_t first = 0; first < block.normals.size(); first += normals_a_piece)
                pieces.push_back(
                    {c, {}, written, &block, first, std::min(normals_a_piece, block.normals.size() - first)});
            written += block.normals.size();
            rest.begin = block.at;
        }
        pieces.push_back({c, rest, written});
    }
    return pieces;
}

void write_normals(const Piece& piece, std::string_view line_end, TextBuffer& out) {
    constexpr std::size_t most_digits = 16;  // "-1.17549435e-38"
    for (std::size_t i = piece.first; i < piece.first + piece.count; ++i) {
        const vec3 n = piece.block->normals[i].normal();
        char* at = out.room(2 + 3 * (most_digits + 1) + line_end.size());
        *at++ = 'v', *at++ = 'n';
        for (const float x : {n.x, n.y, n.z}) {
            *at++ = ' ';
            at = std::to_chars(at, at + most_digits, x).ptr;
        }
        std::memcpy(at, line_end.data(), line_end.size());
        out.end_at(at + line_end.size());
    }
}

/// Writes lines of one chunk with the new normals.
class LineWriter {
public:
    LineWriter(std::string_view text, const Piece& piece, const KeptObj& file, const NewNormals& normals,
               TextBuffer& out)
        : text_(text),
          piece_(piece),
          faces_(file.elements.chunks[piece.chunk].faces),
          chunk_(normals.chunks[piece.chunk]),
          blocks_(normals.blocks),
          out_(out) {
        for (; face_ < faces_.size() && faces_[face_].line_begin < piece.text.begin; ++face_)
            corner_ += faces_[face_].corners;
    }

    /// @return references to normals that were removed
    std::uint64_t write(const Context& context) {
        std::size_t kept = piece_.text.begin;  // from here on nothing was written
        const auto keep_up_to = [&](std::size_t end) { out_.append(text_.substr(kept, end - kept)); };
        LineReader lines(text_, piece_.text);
        for (Line line; lines.next(line);) {
            if (line.number % 65536 == 0) context.throw_if_cancelled();
            const std::string_view key = line.keyword.text;
            const bool is_face = key == "f" || key == "fo";
            // surf: free-form surfaces are not read, but their control points may refer to removed normals.
            if (!is_face && key != "vn" && key != "surf") continue;
            keep_up_to(line.begin);
            kept = line.next;
            if (key == "vn") continue;
            const bool is_read = face_ < faces_.size() && faces_[face_].line_begin == line.begin;
            write_face(line, lines.arguments(line), is_read);
            if (is_read) corner_ += faces_[face_++].corners;
        }
        keep_up_to(piece_.text.end);
        return lost_references_;
    }

private:
    void write_face(const Line& line, Tokens words, bool is_read) {
        std::size_t from = line.begin, k = corner_;
        const NormalBlock* const block = is_read ? &blocks_[chunk_.object[face_]] : nullptr;
        for (Token word; words.next(word); ++k) {
            const auto token = parse_face_token(word.text);
            if (!token) continue;  // of a face that is not read
            const std::size_t slash = std::min(word.text.find('/'), word.text.size());
            const std::size_t second = std::min(word.text.find('/', slash + 1), word.text.size());
            const std::size_t kept =
                second - std::min(second, slash + 1) > 0 ? second : slash;  // with the coordinate or not
            out_.append(text_.substr(from, word.begin + kept - from));
            from = word.end();
            if (!is_read) {
                lost_references_ += token->normal.has_value();
                continue;
            }
            out_.append(kept > slash ? "/" : "//");
            const std::uint64_t number = block->first + chunk_.numbers[k];
            char* const at = out_.room(24);
            out_.end_at(
                std::to_chars(at, at + 24,
                              token->position < 0 ? -std::int64_t(piece_.written - number) : std::int64_t(number + 1))
                    .ptr);
        }
        out_.append(text_.substr(from, line.next - from));
    }

    std::string_view text_;
    const Piece& piece_;
    const std::vector<FaceRecord>& faces_;
    const ChunkNormals& chunk_;
    const std::vector<NormalBlock>& blocks_;
    TextBuffer& out_;
    std::size_t face_ = 0, corner_ = 0;  ///< of the next face that was read
    std::uint64_t lost_references_ = 0;
};

/// How the file's first line ends; that of a file of one line is made up.
std::string_view line_end_of(std::string_view text) {
    LineReader lines(text);
    Line line;
    return lines.next(line) && line.next > line.end ? text.substr(line.end, line.next - line.end) : "\n";
}

/// Some pieces are made at once while those before them are written, in order.
/// @return references to normals that were removed
std::uint64_t write_pieces(std::string_view text, const KeptObj& file, const NewNormals& normals, OutputFile& output,
                           Context& context) {
    constexpr std::size_t at_once = 32;
    const std::string_view line_end = line_end_of(text);
    const std::vector<Piece> pieces = pieces_of(file.contents, normals);
    std::vector<TextBuffer> made(at_once), ready(at_once);
    std::vector<std::uint64_t> lost(pieces.size());
    output.write(std::as_bytes(std::span(text.substr(0, pieces.front().text.begin))));  // a byte order mark
    for (std::size_t first = 0; first < pieces.size() + at_once; first += at_once) {
        const std::size_t count = first < pieces.size() ? std::min(at_once, pieces.size() - first) : 0;
        context.parallel_for(count + 1, [&](std::size_t i) {
            if (i == 0) {
                for (TextBuffer& text_ready : ready) output.write(std::as_bytes(std::span(text_ready.text())));
                return;
            }
            const Piece& piece = pieces[first + i - 1];
            if (piece.block)
                write_normals(piece, line_end, made[i - 1]);
            else
                lost[first + i - 1] = LineWriter(text, piece, file, normals, made[i - 1]).write(context);
        });
        for (TextBuffer& written : ready) written.clear();
        std::swap(made, ready);
    }
    std::uint64_t sum = 0;
    for (const std::uint64_t l : lost) sum += l;
    return sum;
}

}  // namespace
}  // namespace obj

bool rewrite_obj_normals(const std::string& source, const Scene& after, const std::string& output,
                         const ReadOptions& options, Context& context, std::size_t chunk_bytes) {
    try {
        Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
        const std::shared_ptr<const KeptObj> kept =
            options.keep_obj ? *options.keep_obj : obj::read_again(source, options, quiet, chunk_bytes);
        const KeptObj& file = *kept;
        const std::string_view text = file.text->view();
        const obj::NewNormals normals =
            file.contents.elements == 0  // a cloud of points
                ? obj::NewNormals{}
                : obj::choose_normals(file.elements, file.contents, file.data, after, context);
        if (!is_same_folder(source, output))
            copy_beside(obj::material_files(text, source, options, context), output, context);
        OutputFile written(output);
        std::uint64_t lost = 0;
        if (normals.is_changed)
            lost = obj::write_pieces(text, file, normals, written, context);
        else
            written.write(*file.bytes);
        if (lost > 0)
            context.report().add(
                Remark::dropped, source, {},
                std::to_string(lost) +
                    " references to normals were removed from faces and free-form surfaces that are not read");
        written.commit();
        return normals.is_changed;
    } catch (const Error& error) {
        throw error.with_file(source);
    }
}

void copy_obj(const std::string& source, const std::string& output, const ReadOptions& options, Context& context) {
    const Bytes bytes = read_file(source, context);
    const PlainText text(std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()), source,
                         context);
    if (!is_same_folder(source, output))
        copy_beside(obj::material_files(text.view(), source, options, context), output, context);
    write_file(output, *bytes);
}

}  // namespace rakelight::io
