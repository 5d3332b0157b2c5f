// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_faces.h"

#include <algorithm>
#include <cmath>

#include "io/obj/polygon.h"
#include "io/ply/ply_vertices.h"

namespace rakelight::io::ply {
namespace {

/// Room for `more` elements; its growth is charged before it happens.
template <class T>
void make_room(std::vector<T>& array, std::size_t more, MemoryCharge& charge) {
    if (array.capacity() - array.size() >= more) return;
    const std::size_t before = array.capacity(), capacity = std::max(2 * before, array.size() + more);
    charge.grow(capacity * sizeof(T), "the faces of a file");
    array.reserve(capacity);
    charge.shrink(before * sizeof(T));
}

/// What a property of a face is for.
enum class Use : std::uint8_t { none, corners, texcoords, color };

Use use_of(const Property& p, bool takes_colors) {
    if (p.count_type && p.name.starts_with("vertex_ind")) return Use::corners;
    if (p.count_type && p.name == "texcoord") return Use::texcoords;
    return !p.count_type && takes_colors && color_component(p.name) ? Use::color : Use::none;
}

class FaceReader {
public:
    FaceReader(Cursor& cursor, const Element& element, Format format, const VertexTable& vertices, bool takes_colors,
               Faces& out)
        : cursor_(cursor), vertices_(vertices), out_(out), first_value_(out.triangles.size()) {
        for (const Property& p : element.properties) {
            Use use = use_of(p, takes_colors);
            const std::size_t component = use == Use::color ? *color_component(p.name) : 0;
            if (use == Use::color && !columns_.take(component, kind_of(p, format).color)) use = Use::none;
            uses_.push_back({&p, use, component});
            out.have_texcoords |= use == Use::texcoords;
            has_values_ |= use == Use::color || use == Use::texcoords;
            if (use == Use::none) unused_.push_back(p.name);
        }
        out.have_colors |= columns_.any();
    }

    void read_row() {
        corners_.clear(), uvs_.clear();
        bool is_fine = true;
        for (const auto& [property, use, component] : uses_) {
            if (use == Use::corners)
                is_fine = read_corners(*property);
            else if (use == Use::texcoords)
                read_texcoords(*property);
            else if (use == Use::none)
                cursor_.skip(*property);
            else
                read_color(component, cursor_.number(property->type));
        }
        if (!is_fine)
            ++bad_;
        else if (corners_.size() < 3)
            ++short_;
        else
            add();
    }

    /// The colors of all faces, as the file has them, become linear: what range they have is known now.
    void finish_colors(const std::string& path, Report& report) {
        if (!columns_.any()) return;
        const std::span<CornerValue> values =
            std::span(out_.values).subspan(std::min(first_value_, out_.values.size()));
        for (const CornerValue& v : values) columns_.look_at(v.color);
        columns_.settle("face", path, report);
        for (CornerValue& v : values) v.color = columns_.linear(v.color);
    }

    void say(const std::string& path, Report& report) const {
        const auto count = [&](std::uint64_t n, const char* what) {
            if (n > 0) report.add(Remark::warning, path, "", std::to_string(n) + what);
        };
        count(bad_, " faces have vertex numbers out of range and are left out");
        count(short_, " faces have fewer than 3 corners and are left out");
        for (const std::string& name : unused_)
            report.add(Remark::dropped, path, "", "the face property '" + one_line(name, 40) + "' is left out");
    }

private:
    struct PropertyUse {
        const Property* property;
        Use use;
        std::size_t component;  ///< of a color
    };

    void read_color(std::size_t component, double value) { color_[component] = std::isnan(value) ? 0 : float(value); }

    bool read_corners(const Property& p) {
        const std::uint64_t count = cursor_.list(p);
        make_room(corners_, std::size_t(count), out_.charge);
        bool is_fine = true;
        for (std::uint64_t i = 0; i < count; ++i) {
            const double v = cursor_.number(p.type);
            const bool is_in = v >= 0 && v < double(vertices_.count());
            corners_.push_back(is_in ? std::uint32_t(v) : 0);
            is_fine = is_fine && is_in;
        }
        return is_fine;
    }
    void read_texcoords(const Property& p) {
        const std::uint64_t count = cursor_.list(p);
        make_room(uvs_, std::size_t(count), out_.charge);
        for (std::uint64_t i = 0; i < count; ++i) uvs_.push_back(float(cursor_.number(p.type)));
    }

    void add() {
        values_.clear(), triangles_.clear();
        for (const std::uint32_t k : cutter_.cut(corners_, vertices_, out_.charge)) {
            if (has_values_) values_.push_back(value_of(k));
            triangles_.push_back(corners_[k]);
        }
        out_.add(triangles_, values_);
    }

    CornerValue value_of(std::uint32_t corner) const {
        CornerValue value;
        if (2 * std::size_t(corner) + 1 < uvs_.size()) {
            const vec2 uv{uvs_[2 * corner], 1 - uvs_[2 * corner + 1]};
            if (std::isfinite(uv.x) && std::isfinite(uv.y)) value.uv = uv;
        }
        if (columns_.any()) value.color = color_;
        return value;
    }

    Cursor& cursor_;
    const VertexTable& vertices_;
    Faces& out_;
    std::vector<PropertyUse> uses_;
    std::vector<std::string> unused_;
    std::vector<std::uint32_t> corners_, triangles_;
    std::vector<CornerValue> values_;  ///< of `triangles_`
    bool has_values_ = false;          ///< of this element's faces
    std::vector<float> uvs_;
    PolygonCutter cutter_;
    ColorColumns columns_;
    vec4 color_{0, 0, 0, 1};   ///< of the face, as the file has it
    std::size_t first_value_;  ///< of this element, in the values of all
    std::uint64_t bad_ = 0, short_ = 0;
};

}  // namespace

std::span<const std::uint32_t> PolygonCutter::cut(std::span<const std::uint32_t> corners, const VertexTable& vertices,
                                                  MemoryCharge& charge) {
    triangles_.clear();
    if (corners.size() == 3) {
        triangles_ = {0, 1, 2};
        return triangles_;
    }
    places_.clear();
    const std::uint64_t work = corners.size() * obj::polygon_bytes;
    charge.grow(work, "a polygon");
    for (const std::uint32_t c : corners) places_.push_back(vertices.position(c));
    obj::triangulate(places_, triangles_);
    charge.shrink(work);
    return triangles_;
}

void Faces::add(std::span<const std::uint32_t> corners, std::span<const CornerValue> own) {
    const std::size_t before = triangles.size() / 3, after = before + corners.size() / 3;
    make_room(triangles, corners.size(), charge);
    triangles.insert(triangles.end(), corners.begin(), corners.end());
    if (corners.size() > 3 || !polygons.empty()) {
        make_room(polygons, after - polygons.size(), charge);
        while (polygons.size() < before) polygons.push_back(std::uint32_t(polygons.size()));
        polygons.resize(after, std::uint32_t(before));
    }
    if (own.empty() && values.empty()) return;
    make_room(values, 3 * after - values.size(), charge);
    values.resize(3 * before);  // of faces that said nothing
    values.insert(values.end(), own.begin(), own.end());
    values.resize(3 * after);
}

void read_faces(Cursor& cursor, const Element& element, Format format, const VertexTable& vertices, bool takes_colors,
                Faces& out, const std::string& path, Context& context) {
    cursor.begin(element);
    FaceReader reader(cursor, element, format, vertices, takes_colors, out);
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        if (i % 65536 == 0) context.throw_if_cancelled();
        reader.read_row();
    }
    reader.finish_colors(path, context.report());
    reader.say(path, context.report());
}

void read_strips(Cursor& cursor, const Element& element, const VertexTable& vertices, Faces& out,
                 const std::string& path, Context& context) {
    cursor.begin(element);
    std::uint64_t bad = 0;
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
        for (const Property& p : element.properties) {
            if (!p.count_type || !p.name.starts_with("vertex_ind")) {
                cursor.skip(p);
                continue;
            }
            const std::uint64_t count = cursor.list(p);
            std::uint32_t before[2] = {0, 0};
            std::uint64_t length = 0;
            for (std::uint64_t k = 0; k < count; ++k) {
                if (k % 65536 == 0) context.throw_if_cancelled();
                const double v = cursor.number(p.type);
                const bool is_in = v >= 0 && v < double(vertices.count());
                bad += !is_in && v != -1;
                if (!is_in) length = 0;
                if (!is_in) continue;
                const auto corner = std::uint32_t(v);
                if (++length >= 3 && corner != before[0] && corner != before[1] && before[0] != before[1]) {
                    const bool is_odd = length % 2 == 0;
                    const std::uint32_t triangle[3] = {before[is_odd ? 1 : 0], before[is_odd ? 0 : 1], corner};
                    out.add(triangle, {});
                }
                before[0] = before[1], before[1] = corner;
            }
        }
    if (bad > 0)
        context.report().add(Remark::warning, path, "",
                             std::to_string(bad) + " vertex numbers of strips are out of range and end them");
}

void read_edges(Cursor& cursor, const Element& element, const VertexTable& vertices, Faces& out,
                const std::string& path, Context& context) {
    cursor.begin(element);
    std::uint64_t bad = 0;
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        if (i % 65536 == 0) context.throw_if_cancelled();
        double ends[2] = {-1, -1};
        for (const Property& p : element.properties) {
            if (!p.count_type && (p.name == "vertex1" || p.name == "vertex2"))
                ends[p.name == "vertex2"] = cursor.number(p.type);
            else
                cursor.skip(p);
        }
        const auto is_in = [&](double v) { return v >= 0 && v < double(vertices.count()); };
        bad += !is_in(ends[0]) || !is_in(ends[1]);
        if (!is_in(ends[0]) || !is_in(ends[1])) continue;
        make_room(out.lines, 2, out.charge);
        out.lines.insert(out.lines.end(), {std::uint32_t(ends[0]), std::uint32_t(ends[1])});
    }
    if (bad > 0)
        context.report().add(Remark::warning, path, "",
                             std::to_string(bad) + " edges have vertex numbers out of range and are left out");
}

}  // namespace rakelight::io::ply
