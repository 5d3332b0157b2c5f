// SPDX-License-Identifier: Apache-2.0
#include "io/stl/text_stl.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/scene.h>
#include <rakelight_internal/base/text.h>

#include "base/cancel_check.h"
#include "base/format_text.h"
#include "io/obj/obj_numbers.h"

namespace rakelight::io::stl {
namespace {

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// @param keyword  in lower case
bool is(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) { return lower_case(a) == b; });
}

bool begins_number(char c) {
    return (c >= '0' && c <= '9') || std::string_view("+-.nNiI").find(c) != std::string_view::npos;
}

/// The words of a text, one after another.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }
    /// Empty: the text ends.
    std::string_view next() {
        skip_blanks();
        begin_ = at_;
        while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
        return text_.substr(begin_, at_ - begin_);
    }
    /// Empty: the line ends.
    std::string_view next_on_line() {
        while (at_ < text_.size() && is_blank(text_[at_]) && !is_line_end(text_[at_])) ++at_;
        return at_ < text_.size() && !is_line_end(text_[at_]) ? next() : std::string_view();
    }
    /// The first letter of the next word; 0: the text ends.
    char peek() {
        skip_blanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    void skip_line() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }
    std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }
    std::size_t begin() const { return begin_; }  ///< of the last word
    std::string line_of(std::size_t at) const {
        return "line " + std::to_string(1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at), '\n'));
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    }
    std::string_view text_;
    std::size_t at_ = 0, begin_ = 0;
};

class TextReader {
public:
    TextReader(std::string_view text, Context& context) : words_(text), context_(context) {
        out_.charge = MemoryCharge(context.memory());
    }

    TextStl read() {
        CancelCheck check(context_);
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            check();
            if (is(word, "vertex"))
                add_vertex();
            else if (is(word, "facet"))
                begin_facet();
            else if (is(word, "endfacet"))
                close_facet();
            else if (is(word, "solid"))
                begin_solid();
            else if (is(word, "endsolid"))
                end_solid();
            else if (!is(word, "outer") && !is(word, "loop") && !is(word, "endloop"))
                ++strange_;
        }
        close_facet("; the file is cut short or damaged");
        if (out_.corners.empty()) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no facet");
        return std::move(out_);
    }

    void say(const std::string& path, Report& report) const {
        if (!has_end_) report.add(Remark::warning, path, {}, "the solid has no end; the file is probably cut short");
        if (strange_ > 0)
            report.add(Remark::warning, path, {}, std::to_string(strange_) + " words are none of STL and are left out");
        if (has_commas_) report.add(Remark::guessed, path, {}, "commas in numbers were read as decimal points");
    }

private:
    void begin_solid() {
        close_facet();
        const std::string name(words_.next_on_line());
        out_.charge.grow(2 * sizeof(TextSolid) + sizeof(Mesh) + sizeof(Node) + 3 * name.size(),
                         "the solids of an STL file");
        out_.solids.push_back({name, out_.corners.size()});
        has_end_ = false;
        // What else stands in the line is part of the name, unless the whole file is one line.
        for (std::size_t before = words_.at();; before = words_.at()) {
            const std::string_view word = words_.next_on_line();
            if (word.empty()) return;
            if (is(word, "facet") && is(words_.next_on_line(), "normal")) return words_.go_to(before);
        }
    }

    void end_solid() {
        close_facet();
        words_.skip_line();
        has_end_ = true;
    }

    /// The normal is left out.
    void begin_facet() {
        close_facet();
        is_open_ = true;
        facet_ = words_.begin();
        vertices_ = 0;
        if (lower_case(words_.peek()) != 'n') return;
        strange_ += !is(words_.next(), "normal");
        for (int i = 0; i < 3 && begins_number(words_.peek()); ++i) words_.next();
    }

    void close_facet(const char* why = "") {
        if (is_open_ && vertices_ != 3)
            throw Error(ErrorCode::bad_file,
                        "a facet has " + counted(vertices_, "vertex", "vertices") + " instead of three" + why,
                        words_.line_of(facet_));
        is_open_ = false;
    }

    void add_vertex() {
        if (!is_open_ || vertices_ == 3)
            throw Error(ErrorCode::bad_file,
                        is_open_ ? "a facet has more than three vertices" : "a vertex stands outside of a facet",
                        words_.line_of(words_.begin()));
        dvec3 place;
        for (std::size_t k = 0; k < 3; ++k) place[k] = coordinate();
        make_room();
        out_.corners.push_back(place);
        ++vertices_;
    }

    double coordinate() {
        const double value = number(words_.next());
        return std::fabs(value) <= double(std::numeric_limits<float>::max()) ? value
                                                                             : std::numeric_limits<double>::quiet_NaN();
    }

    double number(std::string_view word) {
        double value = 0;
        const char* const end = word.data() + word.size();
        if (obj::take_plain_number(word.data(), end, value) == end) return value;
        if (const auto parsed = obj::parse_number(word)) return *parsed;
        std::string with_point(word);  // some programs write as their country does
        std::ranges::replace(with_point, ',', '.');
        const auto parsed = obj::parse_number(with_point);
        if (!parsed || word.empty())
            throw Error(ErrorCode::bad_file,
                        word.empty()
                            ? "the text ends inside a vertex"
                            : "a vertex has '" + one_line(std::string(word), 40) + "' where a number should stand",
                        words_.line_of(words_.begin()));
        has_commas_ = true;
        return *parsed;
    }

    /// For one more corner: its growth is charged before it happens.
    void make_room() {
        const std::size_t before = out_.corners.capacity(), capacity = std::max<std::size_t>(96, 2 * before);
        if (out_.corners.size() < before) return;
        out_.charge.grow(std::uint64_t(capacity) * sizeof(dvec3), "the facets of an STL file");
        out_.corners.reserve(capacity);
        out_.charge.shrink(std::uint64_t(before) * sizeof(dvec3));
    }

    Words words_;
    Context& context_;
    TextStl out_;
    std::size_t facet_ = 0;  ///< where the last one begins
    std::uint64_t vertices_ = 0, strange_ = 0;
    bool is_open_ = false, has_end_ = false, has_commas_ = false;
};

}  // namespace

bool begins_as_text(std::string_view text) {
    return is(Words(text).next(), "solid") && text.substr(0, 512).find('\0') == std::string_view::npos;
}

TextStl read_text_stl(std::string_view text, const std::string& path, Context& context) {
    TextReader reader(text, context);
    TextStl out = reader.read();
    reader.say(path, context.report());
    return out;
}

}  // namespace rakelight::io::stl
