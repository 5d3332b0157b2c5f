// SPDX-License-Identifier: Apache-2.0
#include "io/ply/read_off.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "base/format_text.h"
#include "base/from_chars.h"
#include "io/cloud_material.h"
#include "io/files/file.h"
#include "io/files/plain_text.h"
#include "io/model_readers.h"
#include "io/ply/ply_meshes.h"

namespace rakelight::io {
namespace ply {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view blanks = " \t\v\f\0"sv;

/// The lines that hold something, without their comments.
class OffLines {
public:
    explicit OffLines(std::string_view text) : text_(text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0)) {}

    /// @throws Error bad_file: there is none
    std::string_view next(const char* wanted) {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
            std::string_view line = text_.substr(at_, end - at_);
            at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
            ++number_;
            line = line.substr(0, line.find('#'));
            const std::size_t begin = line.find_first_not_of(blanks);
            if (begin != line.npos) return line.substr(begin);
        }
        throw Error(ErrorCode::bad_file, std::string("the file ends before ") + wanted + "; it is cut short", place());
    }
    std::string place() const { return "line " + std::to_string(number_); }
    std::size_t bytes_left() const { return text_.size() - std::min(at_, text_.size()); }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::uint64_t number_ = 0;
};

std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// The next number; nullopt at the end of the line. @throws Error bad_file: a word that is none
std::optional<double> next_number(std::string_view& line, const OffLines& lines) {
    const std::string_view word = next_word(line);
    if (word.empty()) return {};
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [after, problem] = from_chars(word.data() + (word[0] == '+' ? 1 : 0), end, value);
    if (problem == std::errc::invalid_argument || after != end)
        throw Error(ErrorCode::bad_file, "'" + one_line(std::string(word), 40) + "' is not a number", lines.place());
    return problem == std::errc::result_out_of_range && std::fabs(value) < 1 ? 0 : value;
}

std::uint64_t next_count(std::string_view& line, const char* what, const OffLines& lines) {
    const std::string_view word = next_word(line);
    std::uint64_t n = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (word.empty() || problem != std::errc() || end != word.data() + word.size())
        throw Error(ErrorCode::bad_file,
                    "the number of " + std::string(what) + " is '" + one_line(std::string(word), 40) + "'",
                    lines.place());
    return n;
}

struct OffHeader {
    std::uint64_t vertices = 0, faces = 0;
    std::vector<const char*> columns{"x", "y", "z"};
};

/// "STCNOFF", and the letters that are left out; the counts on the same line or the next.
OffHeader read_off_header(OffLines& lines) {
    OffHeader header;
    std::string_view line = lines.next("its first word"), key = next_word(line);
    if (!key.ends_with("OFF")) throw Error(ErrorCode::bad_file, "not an OFF file (it does not begin with 'OFF')");
    std::string_view letters = key.substr(0, key.size() - 3);
    const auto takes = [&](std::string_view letter) {
        if (!letters.starts_with(letter)) return false;
        letters.remove_prefix(letter.size());
        return true;
    };
    const bool has_texcoords = takes("ST"), has_colors = takes("C"), has_normals = takes("N");
    if (!letters.empty())
        throw Error(ErrorCode::bad_file, "'" + one_line(std::string(key), 40) + "' is a kind that is not supported", {},
                    "points have three coordinates: OFF, COFF, NOFF, STOFF and their like");
    if (has_normals) header.columns.insert(header.columns.end(), {"nx", "ny", "nz"});
    if (has_colors) header.columns.insert(header.columns.end(), {"red", "green", "blue", "alpha"});
    if (has_texcoords) header.columns.insert(header.columns.end(), {"s", "t"});
    if (std::string_view rest = line; next_word(rest).empty()) line = lines.next("the numbers of vertices and faces");
    if (line.starts_with("BINARY") || line.starts_with(" BINARY"))
        throw Error(ErrorCode::bad_file, "binary OFF files are not supported", {}, "export text OFF or PLY");
    header.vertices = next_count(line, "vertices", lines), header.faces = next_count(line, "faces", lines);
    const auto check = [&](std::uint64_t count, std::uint64_t least, const char* what) {
        if (count > (lines.bytes_left() + 1) / least)
            throw Error(ErrorCode::bad_file,
                        format_text("it promises {} {} (at least {} bytes each), but {} bytes follow", count, what,
                                    least, lines.bytes_left()));
    };
    check(header.vertices, 6, "vertices"), check(header.faces, 2, "faces");
    if (header.vertices == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no vertex");
    if (header.vertices >= no_index)
        throw Error(ErrorCode::bad_file, "more than 4294967294 vertices are not supported");
    return header;
}

void read_off_vertices(OffLines& lines, OffHeader& header, VertexTable& table, const std::string& path,
                       Context& context) {
    std::vector<ColumnTarget> targets;
    const auto open = [&](const char* name) {
        targets.push_back(table.column(name, {.is_real = true, .needs_double = true, .color = ColorScale::by_value}));
    };
    for (const char* const name : header.columns) open(name);
    std::uint64_t longer = 0;
    std::vector<double> row;
    for (std::uint64_t v = 0; v < header.vertices; ++v) {
        if (v % 65536 == 0) context.throw_if_cancelled();
        std::string_view line = lines.next("its last vertex");
        row.clear();
        while (const auto number = next_number(line, lines)) row.push_back(*number);
        const std::size_t more = row.size() - std::min(row.size(), header.columns.size());
        if (v == 0 && header.columns.size() == 3 && (more == 3 || more == 4)) {
            for (const char* const name : {"red", "green", "blue", "alpha"})
                if (header.columns.size() < row.size()) header.columns.push_back(name), open(name);
            context.report().add(Remark::guessed, path, {},
                                 "numbers behind the positions of vertices were read as colors");
        }
        const bool lacks_alpha =
            row.size() + 1 == targets.size() && header.columns.back() == "alpha"sv;  // as some writers leave it out
        if (row.size() < targets.size() && !lacks_alpha)
            throw Error(ErrorCode::bad_file,
                        format_text("a vertex has {} numbers instead of {}", row.size(), targets.size()),
                        lines.place());
        longer += row.size() > targets.size();
        for (std::size_t c = 0; c < targets.size(); ++c)
            targets[c].set(v, c < row.size() ? row[c] : std::numeric_limits<double>::quiet_NaN());  // alpha 1
    }
    if (longer > 0)
        context.report().add(Remark::dropped, path, {},
                             format_text("{} vertices have further numbers, which are left out", longer));
}

class OffFaces {
public:
    OffFaces(OffLines& lines, const VertexTable& vertices, Faces& out)
        : lines_(lines), vertices_(vertices), out_(out), takes_colors_(!vertices.has_colors()) {}

    void read() {
        std::string_view line = lines_.next("its last face");
        const std::uint64_t count = next_count(line, "corners", lines_);
        if (count > line.size() / 2 + 1)
            throw Error(ErrorCode::bad_file,
                        format_text("a face has fewer than the {} corners that it promises", count), lines_.place());
        corners_.clear();
        bool is_fine = true;
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto v = next_number(line, lines_);
            if (!v)
                throw Error(ErrorCode::bad_file, format_text("a face has {} corners instead of {}", i, count),
                            lines_.place());
            const bool is_in = *v >= 0 && *v < double(vertices_.count());
            corners_.push_back(is_in ? std::uint32_t(*v) : 0);
            is_fine = is_fine && is_in;
        }
        const CornerValue value = read_color(line);
        bad_ += !is_fine, short_ += is_fine && count < 3;
        if (is_fine && count >= 3) add(value);
    }

    /// The numbers of the file become linear: what range they are in is known now.
    void finish(const std::string& path, Report& report) {
        const auto say = [&](std::uint64_t n, Remark kind, const char* what) {
            if (n > 0) report.add(kind, path, {}, std::to_string(n) + what);
        };
        say(bad_, Remark::warning, " faces have vertex numbers out of range and are left out");
        say(short_, Remark::warning, " faces have fewer than 3 corners and are left out");
        say(unread_, Remark::dropped, " faces have a color that is no color of 3 or 4 numbers; it is left out");
        say(unused_, Remark::dropped, " colors of faces are left out: the vertices have colors");
        if (!out_.have_colors) return;
        for (std::size_t k = 0; k < 4; ++k) columns_.take(k, ColorScale::by_value);
        for (const CornerValue& v : out_.values) columns_.look_at(v.color);
        columns_.settle("face", path, report);
        out_.values.resize(out_.triangles.size(), no_color);
        for (CornerValue& v : out_.values) v.color = std::isnan(v.color.x) ? gray : columns_.linear(v.color);
    }

private:
    static constexpr float none = std::numeric_limits<float>::quiet_NaN();
    static constexpr CornerValue no_color{{}, {none, none, none, none}};
    static constexpr vec4 gray{0.3185468f, 0.3185468f, 0.3185468f,
                               1};  ///< as plain_material() of a model without colors

    CornerValue read_color(std::string_view line) {
        CornerValue value = no_color;
        std::size_t count = 0;
        for (; count < 5; ++count) {
            const auto number = next_number(line, lines_);
            if (!number) break;
            if (count < 4) value.color[count] = float(*number);
        }
        if (count == 0) return no_color;
        const bool is_color = count == 3 || count == 4;
        unread_ += !is_color, unused_ += is_color && !takes_colors_;
        if (!is_color || !takes_colors_) return no_color;
        out_.have_colors = true;
        return value;
    }

    void add(const CornerValue& value) {
        triangles_.clear(), values_.clear();
        for (const std::uint32_t k : cutter_.cut(corners_, vertices_, out_.charge)) {
            triangles_.push_back(corners_[k]);
            if (out_.have_colors) values_.push_back(value);
        }
        if (out_.have_colors && out_.values.empty()) fill_before();
        out_.add(triangles_, values_);
    }

    /// The faces before the first colored one have no color.
    void fill_before() {
        out_.charge.grow(out_.triangles.size() * sizeof(CornerValue), "the faces of a file");
        out_.values.assign(out_.triangles.size(), no_color);
    }

    OffLines& lines_;
    const VertexTable& vertices_;
    Faces& out_;
    bool takes_colors_;
    PolygonCutter cutter_;
    ColorColumns columns_;
    std::vector<std::uint32_t> corners_, triangles_;
    std::vector<CornerValue> values_;
    std::uint64_t bad_ = 0, short_ = 0, unread_ = 0, unused_ = 0;
};

}  // namespace

Scene read_off_text(std::string_view bytes, const std::string& path, Context& context) {
    const PlainText text(bytes, path, context);
    OffLines lines(text.view());
    OffHeader header = read_off_header(lines);
    VertexTable vertices(header.vertices, context);
    read_off_vertices(lines, header, vertices, path, context);
    Faces faces(context.memory());
    OffFaces reader(lines, vertices, faces);
    for (std::uint64_t f = 0; f < header.faces; ++f) {
        if (f % 65536 == 0) context.throw_if_cancelled();
        reader.read();
    }
    reader.finish(path, context.report());
    if (header.faces > 0 && faces.triangles.empty())
        throw Error(ErrorCode::bad_file, "nothing to draw: no face has three valid corners");
    Scene scene;
    scene.source = path;
    Mesh mesh;
    mesh.name = std::filesystem::path(path).stem().string();
    vertices.move_to(mesh, path);
    mesh.material = 0;
    scene.nodes.emplace_back().name = mesh.name;
    add_meshes(scene, std::move(mesh), faces, context);
    scene.materials.push_back(plain_material(!scene.meshes.back().colors.empty()));
    return scene;
}

}  // namespace ply

namespace {

Scene read_bytes(const std::string& path, Bytes bytes, const ReadOptions&, Context& context) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return ply::read_off_text(text, path, context);
}

}  // namespace

constinit const ModelReader off_reader = {.read_bytes = read_bytes};

}  // namespace rakelight::io
