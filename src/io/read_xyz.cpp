// SPDX-License-Identifier: Apache-2.0
#include "io/read_xyz.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "base/from_chars.h"
#include "io/cloud_material.h"
#include "io/files/plain_text.h"
#include "io/model_readers.h"
#include "io/vertex_table.h"

namespace rakelight::io {
namespace {

constexpr std::size_t most_columns = 16;

/// Lines that hold something, with their numbers.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }
    bool next(std::string_view& line) {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
            line = text_.substr(at_, end - at_);
            at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
            ++number_;
            const std::size_t begin = line.find_first_not_of(" \t\0");
            if (begin == std::string_view::npos || line[begin] == '#' || line.substr(begin, 2) == "//") continue;
            return true;
        }
        return false;
    }
    std::string place() const { return "line " + std::to_string(number_); }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::uint64_t number_ = 0;
};

/// @return how many numbers a line contains; of more than most_columns that many; most_columns + 1: a word is none
std::size_t read_line(std::string_view line, double (&values)[most_columns], bool* has_more = nullptr) {
    const auto separates = [](char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\0'; };
    std::size_t count = 0;
    for (const char *at = line.data(), *const end = at + line.size();;) {
        while (at != end && separates(*at)) ++at;
        if (has_more) *has_more = at != end;
        if (at == end || count == most_columns) return count;
        const auto [after, problem] = from_chars(at + (*at == '+' ? 1 : 0), end, values[count]);
        if (problem == std::errc::invalid_argument || (after != end && !separates(*after))) return most_columns + 1;
        if (problem == std::errc::result_out_of_range && std::fabs(values[count]) < 1) values[count] = 0;
        ++count;
        at = after;
    }
}

/// What is known of the columns before memory is requested.
struct Survey {
    std::uint64_t points = 0;
    std::uint64_t longer = 0;  ///< lines that hold more numbers than `columns`
    std::size_t columns = 0;
    bool begins_with_count = false;
    /// Of the three columns that begin there: all are of length 1; all are whole numbers 0..255; all are 0..1.
    bool are_unit[most_columns], are_bytes[most_columns], are_shares[most_columns];
};

Survey survey(std::string_view text, Context& context) {
    Survey s;
    std::fill(std::begin(s.are_unit), std::end(s.are_unit), true);
    std::fill(std::begin(s.are_bytes), std::end(s.are_bytes), true);
    std::fill(std::begin(s.are_shares), std::end(s.are_shares), true);
    Lines lines(text);
    std::string_view line;
    double v[most_columns];
    for (std::uint64_t i = 0; lines.next(line); ++i) {
        if (i % 65536 == 0) context.throw_if_cancelled();
        bool has_more = false;
        const std::size_t count = read_line(line, v, &has_more);
        if (i == 0 && count == 1) {
            s.begins_with_count = true;
            continue;
        }
        if (s.points == 0) s.columns = count;
        if (count > most_columns || count < 3 || count < s.columns)
            throw Error(ErrorCode::bad_file,
                        count > most_columns ? "'" + one_line(std::string(line), 40) + "' is not a line of numbers"
                                             : format_text("a point has {} numbers instead of {}", count,
                                                           std::max<std::size_t>(s.columns, 3)),
                        lines.place());
        ++s.points;
        s.longer += has_more || count > s.columns;
        for (std::size_t c = 3; c + 3 <= s.columns; ++c) {
            const double length = v[c] * v[c] + v[c + 1] * v[c + 1] + v[c + 2] * v[c + 2];
            s.are_unit[c] = s.are_unit[c] && (std::fabs(length - 1) < 0.02 || length == 0);
            for (std::size_t k = c; k < c + 3; ++k) {
                s.are_bytes[c] = s.are_bytes[c] && v[k] >= 0 && v[k] <= 255 && v[k] == std::floor(v[k]);
                s.are_shares[c] = s.are_shares[c] && v[k] >= 0 && v[k] <= 1;
            }
        }
    }
    return s;
}

/// The names of the columns. A group of three has to be what it is called; what is left over is called by its number.
std::vector<std::string> names_of(const Survey& s) {
    std::vector<std::string> names = {"x", "y", "z"};
    bool has_normals = false, has_colors = false;
    while (names.size() < s.columns) {
        const std::size_t c = names.size(), left = s.columns - c;
        const bool is_color = left >= 3 && !has_colors && (s.are_bytes[c] || s.are_shares[c]);
        // Axis-aligned normals are bytes and shares too: three more behind them that can be a color tell.
        const bool is_normal =
            left >= 3 && !has_normals && s.are_unit[c] && (!s.are_bytes[c] || left >= 6 || has_colors);
        if (is_normal)
            names.insert(names.end(), {"nx", "ny", "nz"}), has_normals = true;
        else if (is_color && left != 4)
            names.insert(names.end(), {"red", "green", "blue"}), has_colors = true;
        else
            names.push_back(c == 3 && left != 3 ? "intensity" : "column " + std::to_string(c + 1));
    }
    return names;
}

void fill(std::string_view text, const Survey& s, VertexTable& table, Context& context) {
    std::vector<ColumnTarget> targets;
    for (const std::string& name : names_of(s)) {
        ColumnKind kind{.is_real = true, .needs_double = true, .color = ColorScale::by_value};
        if (name == "red" || name == "green" || name == "blue")
            kind.color = s.are_shares[targets.size() - (name == "green"  ? 1
                                                        : name == "blue" ? 2
                                                                         : 0)]
                             ? ColorScale::unit
                             : ColorScale::bytes;
        targets.push_back(table.column(name, kind));
    }
    Lines lines(text);
    std::string_view line;
    double v[most_columns];
    if (s.begins_with_count) lines.next(line);
    for (std::uint64_t row = 0; row < s.points && lines.next(line); ++row) {
        if (row % 65536 == 0) context.throw_if_cancelled();
        read_line(line, v);
        for (std::size_t c = 0; c < s.columns; ++c) targets[c].set(row, v[c]);
    }
}

}  // namespace

Scene read_xyz_text(std::string_view bytes, const std::string& path, Context& context) {
    const PlainText plain(bytes, path, context);
    const std::string_view text = plain.view();
    const Survey s = survey(text, context);
    if (s.points == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no point");
    if (s.points >= no_index) throw Error(ErrorCode::bad_file, "more than 4294967294 points are not supported");
    if (s.longer > 0)
        context.report().add(Remark::dropped, path, "",
                             format_text("{} more than {} numbers; further ones are left out",
                                         counted(s.longer, "line holds", "lines hold"), s.columns));
    VertexTable table(s.points, context);
    fill(text, s, table, context);
    Scene scene;
    scene.source = path;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = std::filesystem::path(path).stem().string();
    mesh.topology = Topology::points;
    table.move_to(mesh, path);
    MemoryCharge charge(context.memory(), s.points * sizeof(std::uint32_t), "the points");
    std::vector<std::uint32_t> indices(std::size_t(s.points));
    std::iota(indices.begin(), indices.end(), 0u);
    mesh.indices = {std::move(indices), std::move(charge)};
    mesh.material = 0;
    scene.materials.push_back(plain_material(!mesh.colors.empty()));
    scene.nodes.push_back({.name = mesh.name, .meshes = {0}});
    return scene;
}

namespace {

Scene read_bytes(const std::string& path, Bytes bytes, const ReadOptions&, Context& context) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return read_xyz_text(text, path, context);
}

}  // namespace

constinit const ModelReader xyz_reader = {.read_bytes = read_bytes};

}  // namespace rakelight::io
