// SPDX-License-Identifier: Apache-2.0
#include "io/obj/rewrite_normals.h"

#include <array>
#include <bit>
#include <charconv>
#include <filesystem>
#include <unordered_map>

#include "base/hash_key.h"
#include "io/beside.h"
#include "io/file.h"
#include "io/obj/material_files.h"
#include "io/obj/mtl_materials.h"
#include "io/obj/obj_faces.h"
#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"
#include "io/obj/obj_vertices.h"
#include "io/same_attributes.h"

namespace rakelight::io {
namespace obj {
namespace {

/// The normals of one object, each once.
class NormalBlock {
public:
    std::uint32_t number_of(vec3 n) {
        const std::array key{std::bit_cast<std::uint32_t>(n.x), std::bit_cast<std::uint32_t>(n.y),
                             std::bit_cast<std::uint32_t>(n.z)};
        const auto [entry, is_new] = numbers_.try_emplace(key, std::uint32_t(normals_.size()));
        if (is_new) normals_.push_back(n);
        return entry->second;
    }
    const std::vector<vec3>& normals() const { return normals_; }
    std::size_t at = 0;       ///< where in the file its lines go: the first byte of a line
    std::uint64_t first = 0;  ///< normals in the blocks before

private:
    struct Hash {
        std::size_t operator()(const std::array<std::uint32_t, 3>& k) const {
            const HashKey key = hash_key_of_this_run();
            return std::size_t(folded_product((std::uint64_t(k[0]) << 32 | k[1]) ^ key.a, k[2] ^ key.b));
        }
    };
    std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, Hash> numbers_;
    std::vector<vec3> normals_;
};

/// A face that gets normals: its line and the numbers of its corners' normals in the block of its object.
struct FaceNormals {
    std::size_t line_begin = 0, first_corner = 0;
    std::uint32_t object = 0, corners = 0;
};

class Rewriter {
public:
    Rewriter(std::string_view text, const std::string& path, const ReadOptions& options, const Scene& after,
             Context& context)
        : text_(text), path_(path), after_(after), context_(context) {
        quiet_.memory().note_read(text.size());
        Remarks remarks(path);
        const Contents contents = count_contents(text, remarks, quiet_);
        Scene scratch;  // the library tells names of one material apart as the reader did
        MaterialLibrary library(scratch, path, options.allow_outside, quiet_);
        for (const std::string& argument : contents.libraries) library.load(argument);
        data_ = read_vertices(text, contents, remarks, quiet_);
        const FindMaterial find = [&](const std::string& name, std::uint64_t line) { return library.find(name, line); };
        const std::string stem = std::filesystem::path(path).stem().string();
        Elements elements =
            read_elements(text, contents, data_, stem, find, remarks, quiet_, [this](const ReadFace& f) { keep(f); });
        if (elements.meshes.meshes().size() != after.meshes.size())
            throw Error(ErrorCode::failed, "the file changed while it was worked on");
        blocks_.resize(elements.objects.size());
        choose_normals(elements.meshes.meshes());
        place_blocks();
    }

    bool is_changed() const { return is_changed_; }

    std::string rewritten() {
        LineReader lines(text_);
        std::size_t block = 0, face = 0;
        for (Line line; lines.next(line);) {
            if (line.number % 65536 == 0) context_.throw_if_cancelled();
            if (line.number == 1) begin_output(line);
            for (; block < write_order_.size() && write_order_[block]->at == line.begin; ++block)
                write_block(*write_order_[block]);
            const std::string_view key = line.keyword.text;
            if (key == "vn") continue;
            // surf: free-form surfaces are not read, but their control points may name normals that are gone.
            if (key != "f" && key != "fo" && key != "surf") {
                out_.append(text_.substr(line.begin, line.next - line.begin));
                continue;
            }
            const bool is_read = face < faces_.size() && faces_[face].line_begin == line.begin;
            write_face(line, lines.arguments(line), is_read ? &faces_[face] : nullptr);
            face += is_read;
        }
        if (lost_references_ > 0)
            context_.report().add(
                Remark::dropped, path_, {},
                std::to_string(lost_references_) +
                    " references to normals were removed from faces and free-form surfaces that are not read");
        return std::move(out_);
    }

private:
    void keep(const ReadFace& f) {
        // The first place of each corner among the triangles' corners.
        const std::size_t first = corner_places_.size();
        context_.memory().check((first + f.corners.size()) * 16, "the faces of an OBJ file");
        corner_places_.resize(first + f.corners.size(), no_index);
        old_normals_.resize(corner_places_.size(), no_index);
        for (std::size_t i = f.triangles.size(); i-- > 0;) corner_places_[first + f.triangles[i]] = std::uint32_t(i);
        for (std::size_t k = 0; k < f.corners.size(); ++k) old_normals_[first + k] = f.corners[k].normal;
        faces_.push_back({f.line.begin, first, 0, std::uint32_t(f.corners.size())});
        read_.push_back({f.mesh, f.first_index});
    }

    void choose_normals(const std::vector<GrowingMesh>& meshes) {
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const auto [number, first_index] = read_[f];
            const Mesh& mesh = after_.meshes[number];
            faces_[f].object = meshes[number].key.object;
            for (std::size_t k = faces_[f].first_corner; k < faces_[f].first_corner + faces_[f].corners; ++k) {
                const std::size_t at = first_index + corner_places_[k];
                if (corner_places_[k] == no_index || at >= mesh.indices.size() || mesh.normals.empty())
                    throw Error(ErrorCode::failed, "the file changed while it was worked on");
                const vec3 n = mesh.normals[mesh.indices[at]];
                is_changed_ = is_changed_ || old_normals_[k] == no_index || !is_near(data_.normals[old_normals_[k]], n);
                corner_places_[k] = blocks_[faces_[f].object].number_of(n);
            }
        }
    }

    void place_blocks() {
        LineReader lines(text_);
        std::vector<bool> placed(blocks_.size(), false);
        std::vector<NormalBlock*> in_order;
        std::size_t after_data = 0, face = 0;
        for (Line line; lines.next(line);) {
            const std::string_view key = line.keyword.text;
            if (key == "v" || key == "vt" || key == "vn") after_data = line.next;
            if (face >= faces_.size() || faces_[face].line_begin != line.begin) continue;
            const std::uint32_t object = faces_[face++].object;
            if (placed[object]) continue;
            placed[object] = true;
            const std::size_t last = in_order.empty() ? 0 : in_order.back()->at;
            blocks_[object].at = after_data > last ? after_data : line.begin;
            in_order.push_back(&blocks_[object]);
        }
        std::uint64_t count = 0;
        for (NormalBlock* b : in_order) {
            b->first = count;
            count += b->normals().size();
        }
        write_order_ = std::move(in_order);
    }

    void begin_output(const Line& first) {
        out_.append(text_.substr(0, first.begin));  // a byte order mark
        const std::string_view end = text_.substr(first.end, first.next - first.end);
        if (!end.empty()) line_end_ = end;
    }

    void write_block(const NormalBlock& block) {
        for (const vec3 n : block.normals()) {
            out_ += "vn";
            for (const float x : {n.x, n.y, n.z}) {
                std::array<char, 32> digits;
                const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
                out_ += ' ';
                out_.append(digits.data(), end);
            }
            out_ += line_end_;
        }
        written_ += block.normals().size();
    }

    void write_face(const Line& line, Tokens words, const FaceNormals* face) {
        std::size_t from = line.begin, k = 0;
        for (Token word; words.next(word); ++k) {
            const auto token = parse_face_token(word.text);
            if (!token) continue;  // of a face that is not read
            out_.append(text_.substr(from, word.begin - from));
            from = word.end();
            const std::size_t slash = word.text.find('/');
            const std::size_t second = slash == std::string_view::npos ? slash : word.text.find('/', slash + 1);
            const std::string_view position = word.text.substr(0, slash);
            const std::string_view texcoord =
                slash == std::string_view::npos ? "" : word.text.substr(slash + 1, second - slash - 1);
            out_.append(position);
            if (face || !texcoord.empty()) out_ += '/';
            out_.append(texcoord);
            if (!face) {
                lost_references_ += token->normal.has_value();
                continue;
            }
            const std::uint64_t number = blocks_[face->object].first + corner_places_[face->first_corner + k];
            out_ += '/';
            out_ += token->position < 0 ? "-" + std::to_string(written_ - number) : std::to_string(number + 1);
        }
        out_.append(text_.substr(from, line.next - from));
    }

    std::string_view text_;
    std::string path_;
    const Scene& after_;
    Context& context_;
    Context quiet_{{.threads = 1, .max_memory = context_.memory().limit(), .parent = &context_}};
    VertexData data_;
    std::vector<FaceNormals> faces_;
    std::vector<std::pair<std::size_t, std::size_t>> read_;  ///< [faces] mesh and first index
    std::vector<std::uint32_t> corner_places_, old_normals_;
    std::vector<NormalBlock> blocks_;  ///< [objects]
    std::vector<NormalBlock*> write_order_;
    std::string line_end_ = "\n", out_;
    std::uint64_t written_ = 0, lost_references_ = 0;
    bool is_changed_ = false;
};

}  // namespace
}  // namespace obj

bool rewrite_obj_normals(const std::string& source, const Scene& after, const std::string& output,
                         const ReadOptions& options, Context& context) {
    const Bytes bytes = read_file(source, context);
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    try {
        obj::Rewriter rewriter(text, source, options, after, context);
        const std::string result = rewriter.is_changed() ? rewriter.rewritten() : std::string(text);
        if (!is_same_folder(source, output))
            copy_beside(obj::material_files(text, source, options, context), output, context);
        write_file(output, std::as_bytes(std::span(result)));
        return rewriter.is_changed();
    } catch (const Error& error) {
        throw error.with_file(source);
    }
}

}  // namespace rakelight::io
