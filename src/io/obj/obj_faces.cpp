// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/name_table.h"
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

bool is_finite(dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

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

/// An entry of a table by names, without what a long name keeps outside.
constexpr std::uint64_t group_bytes = sizeof(std::string) + 48;

/// What a string keeps outside itself, at most.
std::uint64_t heap_bytes(const std::string& text) { return text.size() < 16 ? 0 : text.size() + 1; }

class ElementReader {
public:
    ElementReader(std::string_view file, const Contents& contents, const VertexData& data,
                  const FindMaterial& find_material, Remarks& remarks, Context& context, const FaceObserver& observe)
        : file_(file),
          contents_(contents),
          data_(data),
          find_material_(find_material),
          remarks_(remarks),
          context_(context),
          observe_(observe),
          charge_(context.memory()) {
        elements_.charge = MemoryCharge(context.memory());
    }

    Elements read(const std::string& default_object) {
        name_ = default_object;
        LineReader lines(file_);
        for (Line line; lines.next(line);) {
            if (line.number % 65536 == 0) {
                context_.throw_if_cancelled();
                context_.progress("load", 0.4 + 0.6 * double(line.begin) / double(file_.size()));
            }
            line_ = line.number;
            at_ = &line;
            if (!line.keyword.text.empty()) statement(line, lines.arguments(line));
        }
        return std::move(elements_);
    }

private:
    void statement(const Line& line, Tokens words) {
        const std::string_view key = line.keyword.text;
        if (key == "v")
            ++seen_positions_;
        else if (key == "vt")
            ++seen_texcoords_;
        else if (key == "vn")
            ++seen_normals_;
        else if (key == "f" || key == "fo")
            face(words);
        else if (key == "l")
            polyline(words);
        else if (key == "p")
            points(words);
        else if (key == "o")
            begin_object(name_text(file_, line.keyword.end(), line.end));
        else if (key == "g") {
            if (!contents_.has_objects) resume_group(joined_words(words));
        } else if (key == "s")
            smoothing(words);
        else if (key == "usemtl")
            use_material(name_text(file_, line.keyword.end(), line.end));
        else if (key == "mtllib")
            return;
        else if (is_in(key, free_form_keywords))
            remarks_.add(Issue::free_form, line_);
        else if (is_in(key, display_keywords))
            remarks_.add(Issue::display_attribute, line_);
        else if (key == "call" || key == "csh")
            remarks_.add(Issue::external_call, line_);
        else
            remarks_.add(Issue::unknown_keyword, line_);
    }

    // --- state ---

    void begin_object(std::string name) {
        name_ = std::move(name);
        object_ = no_index;
    }

    void resume_group(std::string name) {
        if (name == name_ && object_ != no_index) return;
        const auto known = groups_.find(name);
        object_ = known != groups_.end() ? known->second : no_index;
        name_ = std::move(name);
    }

    void use_material(std::string name) {
        material_name_ = std::move(name);
        material_line_ = line_;
        is_material_known_ = false;
    }

    void smoothing(Tokens words) {
        Token word;
        smoothing_ = 0;
        if (!words.next(word) || word.text == "off") return;
        const auto number = parse_integer(word.text);
        if (number && *number >= 0 && *number < std::int64_t(no_index))
            smoothing_ = std::uint32_t(*number);
        else
            remarks_.add(Issue::smoothing_syntax, line_);
    }

    GrowingMesh& mesh(Topology topology, bool has_normals) {
        if (object_ == no_index) {
            object_ = std::uint32_t(elements_.objects.size());
            make_room(elements_.objects, elements_.charge);
            elements_.charge.grow(heap_bytes(name_), "the names of an OBJ file");
            elements_.objects.push_back(name_);
            if (!contents_.has_objects) {
                charge_.grow(group_bytes + heap_bytes(name_), "the names of an OBJ file");
                groups_.emplace(name_, object_);
            }
        }
        if (!is_material_known_) {
            material_ = find_material_(material_name_, material_line_);
            is_material_known_ = true;
        }
        return elements_.meshes.mesh({object_, material_, topology, has_normals}, elements_.charge);
    }

    // --- elements ---

    /// Reads the corners of an element into corners_. @return false when one of them makes the element unusable
    bool read_corners(Tokens words, Issue syntax) {
        corners_.clear();
        for (Token word; words.next(word);) {
            const auto token = parse_face_token(word.text);
            if (!token) return remarks_.add(syntax, line_), false;
            Corner c;
            c.position = resolved(token->position, seen_positions_, contents_.positions);
            if (c.position == no_index) return remarks_.add(Issue::face_index, line_), false;
            if (token->texcoord) {
                c.texcoord = resolved(*token->texcoord, seen_texcoords_, contents_.texcoords);
                if (c.texcoord == no_index) remarks_.add(Issue::face_texcoord_index, line_);
            }
            if (token->normal) {
                c.normal = resolved(*token->normal, seen_normals_, contents_.normals);
                if (c.normal == no_index) remarks_.add(Issue::face_normal_index, line_);
            }
            push_charged(corners_, c, charge_);
        }
        return true;
    }

    void face(Tokens words) {
        if (!read_corners(words, Issue::face_syntax)) return;
        if (corners_.size() < 3) return remarks_.add(Issue::face_short, line_);
        bool has_normals = true;
        for (const Corner& c : corners_)
            has_normals = has_normals && c.normal != no_index && !(data_.normals[c.normal] == vec3{});
        if (!has_normals)
            for (Corner& c : corners_) c.normal = no_index;
        cut();
        GrowingMesh& target = mesh(Topology::triangles, has_normals);
        if (observe_) {
            const auto number = std::size_t(&target - elements_.meshes.meshes().data());
            observe_({*at_, number, target.indices.size(), corners_, triangles_});
        }
        if (triangles_.size() > 3) add_polygon(target);
        for (std::size_t i = 0; i < triangles_.size(); i += 3) {
            bool is_drawable = true;
            for (std::size_t k = i; k < i + 3; ++k) {
                const Corner& c = corners_[triangles_[k]];
                add_index(target, c);
                is_drawable = is_drawable && is_finite(data_.positions[c.position]);
            }
            elements_.drawable += is_drawable;
            if (contents_.has_smoothing) push_charged(target.smoothing, smoothing_, elements_.charge);
        }
    }

    /// The number of a polygon is that of its first triangle, so that triangles before it need no thought.
    void add_polygon(GrowingMesh& target) {
        const std::size_t first = target.indices.size() / 3, end = first + triangles_.size() / 3;
        for (std::size_t t = target.polygons.size(); t < end; ++t)
            push_charged(target.polygons, std::uint32_t(std::min(t, first)), elements_.charge);
    }

    void cut() {
        triangles_.clear();
        if (corners_.size() == 3) {
            triangles_ = {0, 1, 2};
            return;
        }
        context_.memory().check(corners_.size() * 120, "a polygon of an OBJ file");
        polygon_.clear();
        for (const Corner& c : corners_) polygon_.push_back(data_.positions[c.position]);
        const PolygonCut result = triangulate(polygon_, triangles_);
        if (result == PolygonCut::crossed) remarks_.add(Issue::polygon_crossed, line_);
        if (result == PolygonCut::complex) remarks_.add(Issue::polygon_complex, line_);
    }

    void polyline(Tokens words) {
        if (!read_corners(words, Issue::element_syntax)) return;
        if (corners_.size() < 2) return remarks_.add(Issue::element_syntax, line_);
        GrowingMesh& target = mesh(Topology::lines, false);
        for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
            add_index(target, without_normal(corners_[i]));
            add_index(target, without_normal(corners_[i + 1]));
            elements_.drawable += is_finite(data_.positions[corners_[i].position]) &&
                                  is_finite(data_.positions[corners_[i + 1].position]);
        }
    }

    void points(Tokens words) {
        if (!read_corners(words, Issue::element_syntax) || corners_.empty()) return;
        GrowingMesh& target = mesh(Topology::points, false);
        for (const Corner& c : corners_) {
            add_index(target, without_normal(c));
            elements_.drawable += is_finite(data_.positions[c.position]);
        }
    }

    static Corner without_normal(Corner c) {
        c.normal = no_index;
        return c;
    }

    void add_index(GrowingMesh& target, const Corner& corner) {
        push_charged(target.indices, target.table.index_of(corner, elements_.charge), elements_.charge);
    }

    std::string_view file_;
    const Contents& contents_;
    const VertexData& data_;
    const FindMaterial& find_material_;
    Remarks& remarks_;
    Context& context_;
    const FaceObserver& observe_;
    const Line* at_ = nullptr;  ///< the line at hand
    Elements elements_;
    std::uint64_t line_ = 0, material_line_ = 0, seen_positions_ = 0, seen_texcoords_ = 0, seen_normals_ = 0;
    std::string name_, material_name_;
    NameMap<std::uint32_t> groups_;  ///< name -> object, in files without `o`
    std::uint32_t object_ = no_index, material_ = no_index, smoothing_ = 0;
    bool is_material_known_ = false;
    MemoryCharge charge_;          ///< pays for groups_ and corners_
    std::vector<Corner> corners_;  ///< of the element at hand
    std::vector<dvec3> polygon_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace

Elements read_elements(std::string_view file, const Contents& contents, const VertexData& data,
                       const std::string& default_object, const FindMaterial& find_material, Remarks& remarks,
                       Context& context, const FaceObserver& observe) {
    return ElementReader(file, contents, data, find_material, remarks, context, observe).read(default_object);
}

}  // namespace rakelight::io::obj
