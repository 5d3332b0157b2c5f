// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/name_table.h"
#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"
#include "math/color.h"

namespace rakelight::io::obj {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t lines_between_checks = 1 << 16;

/// The numbers of one line; those that cannot be read are NaN and remarked on.
struct Numbers {
    static constexpr int most = 8;
    double values[most];
    int count = 0;  ///< words in the line, at most `most`
};

Numbers read_numbers(Tokens words, std::uint64_t line, Remarks& remarks) {
    Numbers numbers;
    for (Token word; numbers.count < Numbers::most && words.next(word);) {
        const auto value = parse_number(word.text);
        if (!value) remarks.add(Issue::bad_number, line);
        numbers.values[numbers.count++] = value.value_or(nan);
    }
    return numbers;
}

double coordinate(const Numbers& n, int i, bool& is_bad) {
    const double value = i < n.count ? n.values[i] : nan;
    if (std::abs(value) <= double(std::numeric_limits<float>::max())) return value;
    is_bad = true;
    return nan;
}

class VertexReader {
public:
    VertexReader(const Contents& contents, Remarks& remarks, MemoryBudget& memory)
        : contents_(contents), remarks_(remarks) {
        data_.charge = MemoryCharge(memory);
        reserve(data_.positions, contents.positions, "the vertices of an OBJ file");
        reserve(data_.texcoords, contents.texcoords, "the texture coordinates of an OBJ file");
        reserve(data_.normals, contents.normals, "the normals of an OBJ file");
    }

    void position(const Numbers& n, std::uint64_t line) {
        bool is_bad = false;
        const dvec3 p{coordinate(n, 0, is_bad), coordinate(n, 1, is_bad), coordinate(n, 2, is_bad)};
        if (n.count < 3)
            remarks_.add(Issue::missing_numbers, line);
        else if (is_bad)
            remarks_.add(Issue::not_finite, line);
        data_.positions.push_back(p);
        if (n.count >= 6) color(n, line);
        if (n.count == 4 && n.values[3] != 1) remarks_.add(Issue::weight, line);
        if (n.count == 5 || n.count > 7) remarks_.add(Issue::extra_numbers, line);
    }

    void texcoord(const Numbers& n, std::uint64_t line) {
        const double u = n.count > 0 ? n.values[0] : 0, v = n.count > 1 ? n.values[1] : 0;
        vec2 uv{float(u), float(1 - v)};  // bottom origin in the file
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            remarks_.add(Issue::bad_texcoord, line);
            uv = {};
        }
        data_.texcoords.push_back(uv);
    }

    void normal(const Numbers& n, std::uint64_t line) {
        bool is_bad = false;
        const dvec3 v{coordinate(n, 0, is_bad), coordinate(n, 1, is_bad), coordinate(n, 2, is_bad)};
        const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);  // coordinates fit in float: no overflow
        if (is_bad || !(length > 1e-30)) {
            remarks_.add(Issue::bad_normal, line);
            data_.normals.push_back({});
        } else {
            data_.normals.push_back({float(v.x / length), float(v.y / length), float(v.z / length)});
        }
    }

    VertexData take() {
        finish_colors();
        return std::move(data_);
    }

private:
    template <class T>
    void reserve(std::vector<T>& array, std::uint64_t count, const char* what) {
        data_.charge.grow(count * sizeof(T), what);  // counts are below 2^32
        array.reserve(std::size_t(count));
    }

    void color(const Numbers& n, std::uint64_t line) {
        if (data_.colors.empty()) {
            data_.charge.grow(contents_.positions * (sizeof(vec4) + 1), "the vertex colors of an OBJ file");
            data_.colors.resize(std::size_t(contents_.positions), {1, 1, 1, 1});
            data_.has_color.resize(std::size_t(contents_.positions));
        }
        vec4 c{float(n.values[3]), float(n.values[4]), float(n.values[5]), n.count > 6 ? float(n.values[6]) : 1};
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z) || !std::isfinite(c.w)) {
            remarks_.add(Issue::bad_color, line);
            c = {1, 1, 1, 1};
        }
        largest_color_ = std::max({largest_color_, c.x, c.y, c.z});
        if (c.x > 1 || c.y > 1 || c.z > 1) first_large_color_ = std::min(first_large_color_, line);
        data_.colors[data_.positions.size() - 1] = c;
        data_.has_color[data_.positions.size() - 1] = true;
    }

    // Display values 0..1 become linear. Some scanners write 0..255: then all of the file's colors are.
    void finish_colors() {
        const bool are_bytes = largest_color_ > 1;
        if (are_bytes) remarks_.add(Issue::bytes_as_colors, first_large_color_);
        const float scale = are_bytes ? 1.0f / 255 : 1.0f;
        for (std::size_t i = 0; i < data_.colors.size(); ++i) {
            if (!data_.has_color[i]) continue;
            vec4& c = data_.colors[i];
            const vec3 linear = linear_from_srgb(vec3{c.x * scale, c.y * scale, c.z * scale});
            c = {linear.x, linear.y, linear.z, std::clamp(c.w > 1 ? c.w * scale : c.w, 0.0f, 1.0f)};
        }
    }

    const Contents& contents_;
    Remarks& remarks_;
    VertexData data_;
    float largest_color_ = 0;
    std::uint64_t first_large_color_ = std::numeric_limits<std::uint64_t>::max();
};

void check_text(std::string_view file, Remarks& remarks) {
    const std::string_view mark = file.substr(0, 2);
    if (mark == "\xFF\xFE" || mark == "\xFE\xFF")
        throw Error(ErrorCode::bad_file, "the text is UTF-16, which OBJ does not allow", {},
                    "save it as UTF-8 or ASCII");
    const std::size_t nul = file.find('\0');
    if (nul == std::string_view::npos) return;
    const auto line = 1 + std::count(file.begin(), file.begin() + std::ptrdiff_t(nul), '\n');
    remarks.add(Issue::nul_bytes, std::uint64_t(line));
}

}  // namespace

Contents count_contents(std::string_view file, Remarks& remarks, Context& context) {
    check_text(file, remarks);
    Contents contents;
    NameSet libraries;
    LineReader lines(file);
    for (Line line; lines.next(line);) {
        if (line.number % lines_between_checks == 0) context.throw_if_cancelled();
        const std::string_view key = line.keyword.text;
        if (key == "v")
            ++contents.positions;
        else if (key == "vt")
            ++contents.texcoords;
        else if (key == "vn")
            ++contents.normals;
        else if (key == "f" || key == "fo" || key == "l" || key == "p")
            ++contents.elements;
        else if (key == "o")
            contents.has_objects = true;
        else if (key == "s")
            contents.has_smoothing = true;
        else if (key == "mtllib") {
            std::string name = name_text(file, line.keyword.end(), line.end);
            if (!name.empty() && libraries.insert(name).second) contents.libraries.push_back(std::move(name));
        }
        if (lines.saw_lone_cr() && remarks.count(Issue::lone_cr) == 0) remarks.add(Issue::lone_cr, line.number);
    }
    const std::uint64_t most = std::max({contents.positions, contents.texcoords, contents.normals});
    if (most >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::bad_file, "more than 4294967294 vertices are not supported");
    return contents;
}

VertexData read_vertices(std::string_view file, const Contents& contents, Remarks& remarks, Context& context) {
    VertexReader reader(contents, remarks, context.memory());
    LineReader lines(file);
    for (Line line; lines.next(line);) {
        if (line.number % lines_between_checks == 0) {
            context.throw_if_cancelled();
            context.progress("load", 0.4 * double(line.begin) / double(file.size()));
        }
        const std::string_view key = line.keyword.text;
        if (key == "v")
            reader.position(read_numbers(lines.arguments(line), line.number, remarks), line.number);
        else if (key == "vt")
            reader.texcoord(read_numbers(lines.arguments(line), line.number, remarks), line.number);
        else if (key == "vn")
            reader.normal(read_numbers(lines.arguments(line), line.number, remarks), line.number);
    }
    return reader.take();
}

}  // namespace rakelight::io::obj
