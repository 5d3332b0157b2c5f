// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_vertices.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"
#include "io/obj/parallel_ranges.h"
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
    const auto take = [&](const char* at, const char* end) {
        return take_plain_number(at, end, numbers.values[numbers.count]);
    };
    for (Token word; numbers.count < Numbers::most;) {
        if (words.next_plain(take)) {
            ++numbers.count;
            continue;
        }
        if (!words.next(word)) break;
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

/// What is known of the colors only when all were read.
struct ColorRange {
    float largest = 0;
    std::uint64_t first_large = std::numeric_limits<std::uint64_t>::max();  ///< line
};

/// The arrays that all chunks fill, each its own part.
class VertexArrays {
public:
    VertexArrays(const Contents& contents, MemoryBudget& memory) {
        data.charge = MemoryCharge(memory);
        make(data.positions, contents.positions, "the vertices of an OBJ file");
        make(data.texcoords, contents.texcoords, "the texture coordinates of an OBJ file");
        make(data.normals, contents.normals, "the normals of an OBJ file");
    }

    void make_colors() {
        const std::lock_guard lock(mutex_);
        if (!data.colors.empty()) return;
        data.charge.grow(data.positions.size() * (sizeof(vec4) + 1), "the vertex colors of an OBJ file");
        data.has_color.resize(data.positions.size());
        data.colors.resize(data.positions.size(), {1, 1, 1, 1});
    }

    VertexData data;

private:
    template <class T>
    void make(std::vector<T>& array, std::uint64_t count, const char* what) {
        data.charge.grow(count * sizeof(T), what);  // counts are below 2^32
        array.resize(std::size_t(count));
    }
    std::mutex mutex_;
};

/// Reads the v, vt and vn lines of one chunk.
class ChunkVertices {
public:
    ChunkVertices(const ChunkContents& chunk, VertexArrays& arrays, Remarks& remarks, ColorRange& range)
        : arrays_(arrays),
          data_(arrays.data),
          remarks_(remarks),
          range_(range),
          positions_(std::size_t(chunk.positions_before)),
          texcoords_(std::size_t(chunk.texcoords_before)),
          normals_(std::size_t(chunk.normals_before)) {}

    void read(LineReader lines, Context& context) {
        for (Line line; lines.next(line);) {
            if (line.number % lines_between_checks == 0) context.throw_if_cancelled();
            const std::string_view key = line.keyword.text;
            if (key == "v")
                position(read_numbers(lines.arguments(line), line.number, remarks_), line.number);
            else if (key == "vt")
                texcoord(read_numbers(lines.arguments(line), line.number, remarks_), line.number);
            else if (key == "vn")
                normal(read_numbers(lines.arguments(line), line.number, remarks_), line.number);
        }
    }

private:
    void position(const Numbers& n, std::uint64_t line) {
        bool is_bad = false;
        const dvec3 p{coordinate(n, 0, is_bad), coordinate(n, 1, is_bad), coordinate(n, 2, is_bad)};
        if (n.count < 3)
            remarks_.add(Issue::missing_numbers, line);
        else if (is_bad)
            remarks_.add(Issue::not_finite, line);
        data_.positions[positions_] = p;
        if (n.count >= 6) color(n, line);
        if (n.count == 4 && n.values[3] != 1) remarks_.add(Issue::weight, line);
        if (n.count == 5 || n.count > 7) remarks_.add(Issue::extra_numbers, line);
        ++positions_;
    }

    void texcoord(const Numbers& n, std::uint64_t line) {
        const double u = n.count > 0 ? n.values[0] : 0, v = n.count > 1 ? n.values[1] : 0;
        vec2 uv{float(u), float(1 - v)};  // bottom origin in the file
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            remarks_.add(Issue::bad_texcoord, line);
            uv = {};
        }
        data_.texcoords[texcoords_++] = uv;
    }

    void normal(const Numbers& n, std::uint64_t line) {
        bool is_bad = false;
        const dvec3 v{coordinate(n, 0, is_bad), coordinate(n, 1, is_bad), coordinate(n, 2, is_bad)};
        const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);  // coordinates fit in float: no overflow
        const bool is_unusable = is_bad || !(length > 1e-30);
        if (is_unusable) remarks_.add(Issue::bad_normal, line);
        // Unit to the rounding of floats: what was written with all digits keeps its bits.
        const double scale = std::fabs(length - 1) <= 0x1p-23 ? 1 : length;
        data_.normals[normals_++] =
            is_unusable ? vec3{} : vec3{float(v.x / scale), float(v.y / scale), float(v.z / scale)};
    }

    void color(const Numbers& n, std::uint64_t line) {
        if (!has_colors_) arrays_.make_colors();
        has_colors_ = true;
        vec4 c{float(n.values[3]), float(n.values[4]), float(n.values[5]), n.count > 6 ? float(n.values[6]) : 1};
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z) || !std::isfinite(c.w)) {
            remarks_.add(Issue::bad_color, line);
            c = {1, 1, 1, 1};
        }
        range_.largest = std::max({range_.largest, c.x, c.y, c.z});
        if (c.x > 1 || c.y > 1 || c.z > 1) range_.first_large = std::min(range_.first_large, line);
        data_.colors[positions_] = c;
        data_.has_color[positions_] = 1;
    }

    VertexArrays& arrays_;
    VertexData& data_;
    Remarks& remarks_;
    ColorRange& range_;
    std::size_t positions_, texcoords_, normals_;  ///< where the next one goes
    bool has_colors_ = false;                      ///< the arrays are there
};

// Display values 0..1 become linear. Some scanners write 0..255: then all of the file's colors are.
void finish_colors(VertexData& data, const ColorRange& range, Remarks& remarks, Context& context) {
    const bool are_bytes = range.largest > 1;
    if (are_bytes) remarks.add(Issue::bytes_as_colors, range.first_large);
    const float scale = are_bytes ? 1.0f / 255 : 1.0f;
    parallel_ranges(data.colors.size(), context, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!data.has_color[i]) continue;
            vec4& c = data.colors[i];
            const vec3 linear = linear_from_srgb(vec3{c.x * scale, c.y * scale, c.z * scale});
            c = {linear.x, linear.y, linear.z, std::clamp(c.w > 1 ? c.w * scale : c.w, 0.0f, 1.0f)};
        }
    });
}

}  // namespace

VertexData read_vertices(std::string_view file, const Contents& contents, Remarks& remarks, Context& context) {
    VertexArrays arrays(contents, context.memory());
    std::vector<const ChunkContents*> chunks;
    for (const ChunkContents& chunk : contents.chunks)
        if (chunk.has_vertices()) chunks.push_back(&chunk);
    std::vector<Remarks> found(chunks.size());
    std::vector<ColorRange> ranges(chunks.size());
    std::atomic<std::size_t> done{0};
    context.parallel_for(chunks.size(), [&](std::size_t i) {
        const ChunkContents& chunk = *chunks[i];
        ChunkVertices(chunk, arrays, found[i], ranges[i])
            .read(LineReader(file, chunk.chunk, chunk.first_line), context);
        context.progress("load", 0.4 * double(++done) / double(chunks.size()));
    });
    ColorRange range;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        remarks.append(found[i]);
        range.largest = std::max(range.largest, ranges[i].largest);
        range.first_large = std::min(range.first_large, ranges[i].first_large);
    }
    finish_colors(arrays.data, range, remarks, context);
    return std::move(arrays.data);
}

}  // namespace rakelight::io::obj
