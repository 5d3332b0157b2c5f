// SPDX-License-Identifier: Apache-2.0
#include "fbx_geometry.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace rakelight::import_helper {
namespace {

constexpr std::size_t most_depth = 64;

[[noreturn]] void broken() { throw std::runtime_error("the FBX file is broken"); }

/// Takes the nodes of the file one after another, and keeps what belongs to geometries.
class Collector {
public:
    void begin(std::string_view name) {
        if (path_.size() == most_depth) broken();
        path_.emplace_back(name);
        if (is_geometry(path_.size())) now_ = {};
        if (is_at("LayerElementNormal", 1)) now_.has_normals = true;
    }
    void end() {
        if (path_.empty()) broken();
        if (is_geometry(path_.size()) && !now_.has_normals && now_.kind != FbxGeometry::Kind::none &&
            !now_.corners.empty())
            found.push_back(std::move(now_));
        path_.pop_back();
    }
    /// Whether the numbers of the node that was begun last are of use.
    bool wants_numbers() { return points() || integers(); }
    void numbers(const std::vector<double>& values) {
        if (points()) now_.points = values;
        if (std::vector<std::int32_t>* const into = integers()) {
            into->clear();
            for (const double v : values)
                into->push_back(v >= -2147483648.0 && v <= 2147483647.0 ? std::int32_t(v) : -1);
        }
    }
    void text(std::string_view value) {
        if (!is_at("MappingInformationType", 2) || path_[path_.size() - 2] != "LayerElementSmoothing") return;
        now_.kind = value == "ByPolygon" ? FbxGeometry::Kind::by_polygon
                    : value == "ByEdge"  ? FbxGeometry::Kind::by_edge
                                         : FbxGeometry::Kind::other;
    }
    std::vector<FbxGeometry> found;

private:
    bool is_geometry(std::size_t depth) const { return depth == 2 && path_[0] == "Objects" && path_[1] == "Geometry"; }
    /// Whether the last node has this name, so many levels inside of a geometry. In text, numbers are in a node "a" of their own.
    bool is_at(std::string_view name, std::size_t inside) const {
        return path_.size() == 2 + inside && is_geometry(2) && path_.back() == name;
    }
    bool holds(std::string_view name, std::size_t inside, std::string_view layer = {}) const {
        const std::size_t depth = 2 + inside + (path_.size() == 3 + inside && path_.back() == "a" ? 1 : 0);
        return path_.size() == depth && depth > 2 && path_[0] == "Objects" && path_[1] == "Geometry" &&
               path_[1 + inside] == name && (layer.empty() || path_[inside] == layer);
    }
    bool points() const { return holds("Vertices", 1); }
    std::vector<std::int32_t>* integers() {
        if (holds("PolygonVertexIndex", 1)) return &now_.corners;
        if (holds("Edges", 1)) return &now_.edges;
        if (holds("Smoothing", 2, "LayerElementSmoothing")) return &now_.smoothing;
        if (holds("Materials", 2, "LayerElementMaterial")) return &now_.materials;
        return nullptr;
    }

    std::vector<std::string> path_;
    FbxGeometry now_;
};

// --- binary ----------------------------------------------------------------------------------------------------------------

class BinaryReader {
public:
    BinaryReader(std::span<const std::byte> file, Collector& out) : file_(file), out_(out) {}

    void read() {
        at_ = 23;
        is_wide_ = value<std::uint32_t>() >= 7500;
        while (node(file_.size())) {
        }
    }

private:
    template <class T>
    T value() {
        T v;
        if (sizeof v > file_.size() - at_) broken();
        std::memcpy(&v, file_.data() + at_, sizeof v);
        at_ += sizeof v;
        return v;
    }
    std::uint64_t offset() { return is_wide_ ? value<std::uint64_t>() : value<std::uint32_t>(); }
    std::string_view bytes(std::uint64_t count) {
        if (count > file_.size() - at_) broken();
        const std::string_view out(reinterpret_cast<const char*>(file_.data() + at_), std::size_t(count));
        at_ += std::size_t(count);
        return out;
    }

    /// @return false: it was the record of zeros that ends a list
    bool node(std::uint64_t limit) {
        const std::uint64_t end = offset(), properties = offset();
        offset();
        const std::string_view name = bytes(value<std::uint8_t>());
        if (end == 0) return false;
        if (end > limit || end < at_) broken();
        out_.begin(name);
        for (std::uint64_t p = 0; p < properties; ++p) property(end);
        while (at_ < end && node(end)) {
        }
        out_.end();
        at_ = std::size_t(end);
        return true;
    }

    void property(std::uint64_t end) {
        const char type = char(value<std::uint8_t>());
        if (at_ > end) broken();
        constexpr std::string_view plain = "YCIFDL";
        constexpr std::uint8_t sizes[] = {2, 1, 4, 4, 8, 8};
        if (const std::size_t k = plain.find(type); k != plain.npos)
            bytes(sizes[k]);
        else if (type == 'S')
            out_.text(bytes(value<std::uint32_t>()));
        else if (type == 'R')
            bytes(value<std::uint32_t>());
        else
            array(type);
    }

    void array(char type) {
        const std::size_t size = type == 'd' || type == 'l' ? 8 : type == 'f' || type == 'i' ? 4 : type == 'b' ? 1 : 0;
        if (size == 0) broken();
        const auto count = value<std::uint32_t>(), encoding = value<std::uint32_t>(), stored = value<std::uint32_t>();
        const std::string_view data = bytes(stored);
        if (!out_.wants_numbers()) return;
        const std::uint64_t whole = std::uint64_t(count) * size;
        constexpr std::uint64_t most_ratio = 1032;  // of deflate
        if (encoding > 1 || (encoding == 0 ? whole != stored : whole > stored * most_ratio)) broken();
        std::string unpacked;
        if (encoding == 1) {
            unpacked.resize(std::size_t(whole));
            uLongf length = uLongf(whole);
            const auto* const from = reinterpret_cast<const Bytef*>(data.data());
            if (uncompress(reinterpret_cast<Bytef*>(unpacked.data()), &length, from, uLong(stored)) != Z_OK ||
                length != whole)
                broken();
        }
        const char* const numbers = encoding == 1 ? unpacked.data() : data.data();
        std::vector<double> values(count);
        for (std::size_t i = 0; i < count; ++i) values[i] = number(type, numbers + i * size);
        out_.numbers(values);
    }

    template <class T>
    static double as(const char* at) {
        T v;
        std::memcpy(&v, at, sizeof v);
        return double(v);
    }
    static double number(char type, const char* at) {
        return type == 'd'   ? as<double>(at)
               : type == 'f' ? as<float>(at)
               : type == 'l' ? as<std::int64_t>(at)
               : type == 'i' ? as<std::int32_t>(at)
                             : as<std::int8_t>(at);
    }

    std::span<const std::byte> file_;
    Collector& out_;
    std::size_t at_ = 0;
    bool is_wide_ = false;
};

// --- text ------------------------------------------------------------------------------------------------------------------

class TextReader {
public:
    TextReader(std::string_view text, Collector& out) : text_(text), out_(out) {}

    void read() {
        std::size_t open = 0;
        while (skip(" \t\r\n,"), at_ < text_.size()) {
            if (text_[at_] == '}') {
                ++at_;
                if (open-- == 0) broken();
                out_.end();
                continue;
            }
            const std::size_t colon = text_.find_first_of(":{}\"\n", at_);
            if (colon == text_.npos || text_[colon] != ':') broken();
            out_.begin(text_.substr(at_, colon - at_));
            at_ = colon + 1;
            if (values())
                ++open;
            else
                out_.end();
        }
    }

private:
    /// And comments, which go to the end of their line.
    void skip(std::string_view blanks) {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
            if (at_ == text_.size() || text_[at_] != ';') return;
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
    }

    /// Of one node, to the end of the line; a list goes on behind a comma. @return whether a block follows
    bool values() {
        std::vector<double> numbers;
        const bool wants_numbers = out_.wants_numbers();
        for (bool goes_on = false;;) {
            skip(goes_on ? " \t\r\n" : " \t\r");
            if (at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '}') break;
            if (text_[at_] == '{') {
                ++at_;
                return true;
            }
            goes_on = text_[at_] == ',';
            if (goes_on)
                ++at_;
            else if (text_[at_] == '"')
                quoted();
            else
                word(wants_numbers, numbers);
        }
        if (wants_numbers && !numbers.empty()) out_.numbers(numbers);
        return false;
    }
    void quoted() {
        const std::size_t end = text_.find('"', at_ + 1);
        if (end == text_.npos) broken();
        out_.text(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
    }
    void word(bool is_wanted, std::vector<double>& numbers) {
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n,{}\"", at_), text_.size());
        double value = std::numeric_limits<double>::quiet_NaN();
        if (is_wanted && text_[at_] != '*') {  // "*12": how many follow
            std::from_chars(text_.data() + at_, text_.data() + end, value);
            numbers.push_back(value);
        }
        at_ = end;
    }

    std::string_view text_;
    Collector& out_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<FbxGeometry> read_fbx_geometries(std::span<const std::byte> file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    if (text.find("LayerElementSmoothing") == text.npos) return {};
    Collector out;
    if (text.starts_with("Kaydara FBX Binary") && file.size() > 27)
        BinaryReader(file, out).read();
    else
        TextReader(text, out).read();
    return std::move(out.found);
}

}  // namespace rakelight::import_helper
