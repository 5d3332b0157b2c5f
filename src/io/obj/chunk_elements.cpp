// SPDX-License-Identifier: Apache-2.0
#include "io/obj/chunk_elements.h"

#include <array>
#include <cmath>

#include <rakelight/scene/words.h>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"
#include "io/obj/polygon.h"

namespace rakelight::io::obj {
namespace {

constexpr std::array free_form_keywords{"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2",
                                        "surf", "parm",   "trim", "hole", "scrv", "sp",   "end",
                                        "con",  "bsp",    "bzp",  "cdc",  "cdp",  "res"};
constexpr std::array display_keywords{"mg",        "bevel", "c_interp", "d_interp", "lod",   "shadow_obj",
                                      "trace_obj", "ctech", "stech",    "maplib",   "usemap"};

template <class List>
bool is_in(std::string_view key, const List& list) {
    for (const char* word : list)
        if (key == word) return true;
    return false;
}

bool is_finite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Words of a group line with single blanks between: "back  cube" is "back cube".
std::string joined_words(Tokens words) {
    std::string joined;
    for (Token word; words.next(word);) joined += (joined.empty() ? "" : " ") + std::string(word.text);
    return joined;
}

/// 0-based index, or `no_index` for 0 and out of range. Negative ones count back from the `seen` lines so far.
std::uint32_t resolved(std::int64_t written, std::uint64_t seen, std::uint64_t total) {
    if (written > 0) return std::uint64_t(written) <= total ? std::uint32_t(written - 1) : no_index;
    const std::uint64_t back = std::uint64_t(0) - std::uint64_t(written);  // defined for the least integer too
    return back != 0 && back <= seen ? std::uint32_t(seen - back) : no_index;
}

class ChunkReader {
public:
    ChunkReader(std::string_view file, const ChunkContents& chunk, const Contents& contents, const VertexData& data,
                bool keep_faces, ChunkScratch& scratch, Context& context)
        : file_(file),
          chunk_(chunk),
          contents_(contents),
          data_(data),
          keep_faces_(keep_faces),
          out_(scratch.elements),
          scratch_(scratch),
          context_(context),
          seen_positions_(chunk.positions_before),
          seen_texcoords_(chunk.texcoords_before),
          seen_normals_(chunk.normals_before) {}

    void read() {
        LineReader lines(file_, chunk_.chunk, chunk_.first_line);
        for (Line line; lines.next(line);) {
            if (line.number % 65536 == 0) context_.throw_if_cancelled();
            line_ = &line;
            if (!line.keyword.text.empty()) statement(line, lines.arguments(line));
        }
        end_run();
    }

private:
    void statement(const Line& line, Tokens words) {
        const std::string_view key = line.keyword.text;
        if (key == "f" || key == "fo")
            face(words);
        else if (key == "v")
            ++seen_positions_, vertices_end_ = line.next;
        else if (key == "vt")
            ++seen_texcoords_, vertices_end_ = line.next;
        else if (key == "vn")
            ++seen_normals_, vertices_end_ = line.next;
        else if (key == "l")
            polyline(words);
        else if (key == "p")
            points(words);
        else if (key == "o")
            change(StateChange::Kind::object, name_text(file_, line.keyword.end(), line.end));
        else if (key == "g") {
            if (!contents_.has_objects) change(StateChange::Kind::group, joined_words(words));
        } else if (key == "s")
            smoothing(words);
        else if (key == "usemtl")
            change(StateChange::Kind::material, name_text(file_, line.keyword.end(), line.end));
        else if (key != "mtllib")
            remark(left_out(key));
    }

    static Issue left_out(std::string_view key) {
        if (is_in(key, free_form_keywords)) return Issue::free_form;
        if (is_in(key, display_keywords)) return Issue::display_attribute;
        return key == "call" || key == "csh" ? Issue::external_call : Issue::unknown_keyword;
    }

    void remark(Issue issue) { out_.remarks.add(issue, line_->number); }

    void change(StateChange::Kind kind, std::string name) {
        out_.changes.push_back({kind, std::move(name), line_->number});
    }

    void smoothing(Tokens words) {
        Token word;
        std::uint32_t group = 0;
        if (words.next(word) && !same_word("off", word.text)) {
            const auto number = same_word("on", word.text) ? std::int64_t(1) : parse_integer(word.text);
            if (number && *number >= 0 && *number < std::int64_t(no_index))
                group = std::uint32_t(*number);
            else
                remark(Issue::smoothing_syntax);
        }
        out_.smoothing.push_back({triangles_, group});
    }

    // --- elements ---

    /// What follows goes into a mesh of that kind.
    void begin(Topology topology, bool has_normals) {
        if (!out_.runs.empty()) {
            const Run& last = out_.runs.back();
            if (last.topology == topology && last.has_normals == has_normals && last.changes == out_.changes.size())
                return;
        }
        end_run();
        out_.runs.push_back({topology, has_normals, out_.changes.size(), out_.indices.size(), out_.corners.size(),
                             triangles_, vertices_end_});
    }

    void end_run() {
        const std::vector<Corner>& corners = scratch_.table.keys();
        out_.corners.insert(out_.corners.end(), corners.begin(), corners.end());
        scratch_.table.clear();
    }

    void add_index(const Corner& corner) {
        if (scratch_.table.keys().size() >= UniqueTable<Corner>::most)
            throw Error(ErrorCode::bad_file, "a mesh has more than 4294967294 vertices");
        out_.indices.push_back(scratch_.table.number_of(corner));
    }

    /// Reads the corners of an element. @return false when one of them makes the element unusable
    bool read_corners(Tokens words, Issue syntax) {
        corners_.clear();
        std::optional<FaceToken> token = FaceToken();
        const auto take = [&](const char* at, const char* end) { return take_plain_corner(at, end, *token); };
        for (Token word; words.next_plain(take) || words.next(word);) {
            if (!word.text.empty()) token = parse_face_token(word.text);
            word = {};
            if (!token) return remark(syntax), false;
            Corner c;
            c.position = resolved(token->position, seen_positions_, contents_.positions);
            if (c.position == no_index) return remark(Issue::face_index), false;
            if (token->texcoord) {
                c.texcoord = resolved(*token->texcoord, seen_texcoords_, contents_.texcoords);
                if (c.texcoord == no_index) remark(Issue::face_texcoord_index);
            }
            if (token->normal) {
                c.normal = resolved(*token->normal, seen_normals_, contents_.normals);
                if (c.normal == no_index) remark(Issue::face_normal_index);
            }
            corners_.push_back(c);
        }
        return true;
    }

    void face(Tokens words) {
        if (!read_corners(words, Issue::face_syntax)) return;
        if (corners_.size() < 3) return remark(Issue::face_short);
        bool has_normals = true;
        for (const Corner& c : corners_) has_normals = has_normals && c.normal != no_index;
        if (!has_normals)
            for (Corner& c : corners_) c.normal = no_index;
        cut();
        begin(Topology::triangles, has_normals);
        if (keep_faces_) keep_face();
        if (cut_.size() > 3) out_.polygons.push_back({triangles_, cut_.size() / 3});
        for (std::size_t i = 0; i < cut_.size(); i += 3) {
            bool is_drawable = true;
            for (std::size_t k = i; k < i + 3; ++k) {
                const Corner& c = corners_[cut_[k]];
                add_index(c);
                is_drawable = is_drawable && is_finite(data_.positions[c.position]);
            }
            out_.drawable += is_drawable;
            ++triangles_;
        }
    }

    void keep_face() {
        out_.faces.push_back({line_->begin, out_.indices.size(), std::uint32_t(corners_.size())});
        if (corners_.size() == 3) return;
        const std::size_t first = out_.places.size();
        out_.places.resize(first + corners_.size(), no_index);
        for (std::size_t i = cut_.size(); i-- > 0;)
            out_.places[first + cut_[i]] = std::uint32_t(i);  // the first counts
    }

    void cut() {
        if (corners_.size() == 3) {
            cut_ = {0, 1, 2};
            return;
        }
        cut_.clear();
        context_.memory().check(corners_.size() * polygon_bytes, "a polygon of an OBJ file");
        scratch_.polygon.clear();
        for (const Corner& c : corners_) scratch_.polygon.push_back(data_.positions[c.position]);
        const PolygonCut result = triangulate(scratch_.polygon, cut_);
        if (result == PolygonCut::crossed) remark(Issue::polygon_crossed);
        if (result == PolygonCut::complex) remark(Issue::polygon_complex);
    }

    void polyline(Tokens words) {
        if (!read_corners(words, Issue::element_syntax)) return;
        if (corners_.size() < 2) return remark(Issue::element_syntax);
        begin(Topology::lines, false);
        for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
            add_index(without_normal(corners_[i]));
            add_index(without_normal(corners_[i + 1]));
            out_.drawable += is_finite(data_.positions[corners_[i].position]) &&
                             is_finite(data_.positions[corners_[i + 1].position]);
        }
    }

    void points(Tokens words) {
        if (!read_corners(words, Issue::element_syntax) || corners_.empty()) return;
        begin(Topology::points, false);
        for (const Corner& c : corners_) {
            add_index(without_normal(c));
            out_.drawable += is_finite(data_.positions[c.position]);
        }
    }

    static Corner without_normal(Corner c) {
        c.normal = no_index;
        return c;
    }

    std::string_view file_;
    const ChunkContents& chunk_;
    const Contents& contents_;
    const VertexData& data_;
    const bool keep_faces_;
    ChunkElements& out_;
    ChunkScratch& scratch_;
    std::vector<Corner>& corners_ = scratch_.corners;       ///< of the element at hand
    std::vector<std::uint32_t>& cut_ = scratch_.triangles;  ///< its triangles
    Context& context_;
    const Line* line_ = nullptr;  ///< at hand
    std::uint64_t seen_positions_, seen_texcoords_, seen_normals_;
    std::size_t triangles_ = 0, vertices_end_ = 0;
};

template <class T>
std::vector<T> fitted_copy(std::vector<T>& array) {
    std::vector<T> copy(std::make_move_iterator(array.begin()), std::make_move_iterator(array.end()));
    array.clear();
    return copy;
}

}  // namespace

ChunkElements read_chunk(std::string_view file, const ChunkContents& chunk, const Contents& contents,
                         const VertexData& data, bool keep_faces, ChunkScratch& scratch, Context& context) {
    ChunkElements& made = scratch.elements;
    scratch.table.clear();
    ChunkReader(file, chunk, contents, data, keep_faces, scratch, context).read();
    ChunkElements out{fitted_copy(made.changes),      fitted_copy(made.runs),     fitted_copy(made.corners),
                      fitted_copy(made.indices),      fitted_copy(made.polygons), fitted_copy(made.smoothing),
                      fitted_copy(made.faces),        fitted_copy(made.places),   std::exchange(made.drawable, 0),
                      std::exchange(made.remarks, {})};
    return out;
}

}  // namespace rakelight::io::obj
