// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_arrays.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>

#include "base/format_text.h"
#include "engines/shader_constants.h"

namespace rakelight {
namespace {

constexpr std::int64_t unknown_type_numbers = 256;  ///< the structs of the engine are smaller

constexpr std::string_view no_types[] = {
    "return",        "else",    "do",     "in",       "out",      "inout",     "const",     "uniform",
    "varying",       "flat",    "smooth", "centroid", "highp",    "case",      "mediump",   "lowp",
    "noperspective", "switch",  "while",  "for",      "if",       "invariant", "precision", "struct",
    "attribute",     "precise", "layout", "continue", "break",    "discard",   "buffer",    "shared",
    "coherent",      "sample",  "patch",  "volatile", "restrict", "readonly",  "writeonly"};

bool is_type_or_name(const ShaderToken& token) {
    return token.is_word() && std::ranges::find(no_types, token.text) == std::end(no_types);
}

int digit(std::string_view text, std::size_t at) { return at < text.size() ? text[at] - '0' : 0; }
bool is_size(int n) { return n >= 2 && n <= 4; }

/// Of float, int, vec3, dmat3x4, ...; 0: it is none of them.
std::int64_t builtin_numbers(std::string_view type) {
    for (const std::string_view scalar : {"float", "int", "uint", "bool", "double"})
        if (type == scalar) return scalar == "double" ? 2 : 1;
    const bool is_double = type.starts_with("d");
    if (is_double || type.starts_with("i") || type.starts_with("u") || type.starts_with("b")) type.remove_prefix(1);
    std::int64_t numbers = 0;
    if (const int n = digit(type, 3); type.starts_with("vec") && type.size() == 4 && is_size(n)) numbers = n;
    if (const int n = digit(type, 3); type.starts_with("mat") && is_size(n)) {
        if (type.size() == 4) numbers = n * n;
        if (const int m = digit(type, 5); type.size() == 6 && type[4] == 'x' && is_size(m)) numbers = n * m;
    }
    return is_double ? 2 * numbers : numbers;
}

/// Finds declarations: a type, a name, sizes. All else is passed over. What it cannot tell is taken as large, or refused.
class Arrays {
public:
    Arrays(const std::string& name, const std::vector<ShaderToken>& tokens) : name_(name), tokens_(tokens) {
        find_ends();
        while (at_ < tokens_.size()) take_next();
    }

private:
    struct Struct {
        std::string_view name;
        std::size_t depth;  ///< of brackets outside of it
        std::int64_t numbers = 0;
    };
    using Tokens = std::span<const ShaderToken>;

    static bool is_opening(const ShaderToken& t) { return t == "(" || t == "[" || t == "{"; }
    static bool is_closing(const ShaderToken& t) { return t == ")" || t == "]" || t == "}"; }
    /// In one pass from the end, so that no text makes it slow.
    void find_ends() {
        const std::size_t count = tokens_.size();
        value_ends_.assign(count + 1, count), brackets_.assign(count, count);
        struct Outside {
            std::size_t end, bracket;
        };
        std::vector<Outside> outside;
        std::size_t end = count;
        for (std::size_t i = count; i-- > 0;) {
            if (is_closing(tokens_[i])) {
                outside.push_back({end, i});
                end = i;
            } else if (is_opening(tokens_[i])) {
                end = count;
                if (!outside.empty()) {
                    end = outside.back().end, brackets_[i] = outside.back().bracket;
                    outside.pop_back();
                }
            } else if (tokens_[i] == "," || tokens_[i] == ";") {
                end = i;
            }
            value_ends_[i] = end;
        }
    }

    bool is(std::string_view text, std::size_t at) const { return at < tokens_.size() && tokens_[at] == text; }
    bool is_word(std::size_t at) const { return at < tokens_.size() && is_type_or_name(tokens_[at]); }
    int line() const { return tokens_[std::min(at_, tokens_.size() - 1)].line; }

    void take_next() {
        const ShaderToken& token = tokens_[at_];
        if (token == "struct") return begin_struct();
        if (token == "const")
            is_const_ = true;
        else if (token == ";" || token == "{" || token == "(" || token == ")")
            is_const_ = false;
        if (is_opening(token)) open();
        if (is_closing(token)) return close();
        const bool is_member = at_ > 0 && tokens_[at_ - 1] == ".";
        if (is_type_or_name(token) && !is_member) return take_type(numbers_of(token.text));
        ++at_;
    }
    void open() {
        if (++depth_ > std::size_t(max_shader_nesting))
            refuse_shader(name_, line(), format_text("brackets are nested more than {} deep", max_shader_nesting));
    }
    void close() {
        depth_ -= depth_ > 0 ? 1 : 0;
        const bool ends_struct = tokens_[at_++] == "}" && !structs_.empty() && structs_.back().depth == depth_;
        if (!ends_struct) return;
        const Struct done = structs_.back();
        structs_.pop_back();
        std::int64_t& known = types_[done.name];
        known = std::max(known, done.numbers);
        take_declarators(known, true);
    }
    void begin_struct() {
        ++at_;
        const bool has_name = is_word(at_);
        const std::string_view name = has_name ? tokens_[at_].text : std::string_view();
        if (is("{", at_ + (has_name ? 1 : 0))) {
            at_ += has_name ? 1 : 0;
            structs_.push_back({name, depth_});
        }
    }
    std::int64_t numbers_of(std::string_view type) const {
        if (const std::int64_t builtin = builtin_numbers(type)) return builtin;
        const auto own = types_.find(type);
        return own == types_.end() ? unknown_type_numbers : own->second;
    }

    /// At a type, or a name that is none.
    void take_type(std::int64_t numbers) {
        const bool is_own = types_.contains(tokens_[at_++].text);
        if (is("[", at_)) {
            const std::size_t behind = behind_sizes(at_);
            const bool is_constructor = is("(", behind);
            if (!is_constructor && !is_word(behind)) return;  // an element: what is in its brackets is read next
            const std::int64_t count = is_constructor && is("]", at_ + 1) ? arguments_at(behind) : 1;
            const std::int64_t many = take_sizes(checked(numbers * count));
            if (is_constructor) return add(many);
            return take_declarators(many, true);
        }
        if (is_word(at_)) take_declarators(numbers, is_own);
    }

    /// Names with sizes and values, divided by commas.
    /// @param counts  whether variables without sizes do: vectors and the engine's structs are small
    void take_declarators(std::int64_t numbers, bool counts) {
        const bool is_const = is_const_;
        while (is_word(at_) && !is_word(behind_sizes(at_ + 1))) {  // else it is a type, behind a qualifier
            const std::string_view name = tokens_[at_++].text;
            const bool has_sizes = is("[", at_);
            if (has_sizes)
                add_array(numbers);
            else if ((counts || !structs_.empty()) && !is("(", at_))
                add(numbers);
            const bool has_value = is("=", at_);
            const std::size_t end = has_value ? value_ends_[at_ + 1] : at_;
            if (is_const && !has_sizes) define(name, Tokens(tokens_).subspan(at_, end - at_));
            const bool goes_on =
                is(",", end) && is_word(end + 1) && !is_word(end + 2);  // else a parameter of a function
            if (!goes_on) return;                                       // its value is read next
            while (at_ < end) take_next();
            at_ = end + 1;
        }
    }
    /// Where its value says its size, that is counted there, and a copy has the size of another.
    void add_array(std::int64_t numbers) {
        if (!is("]", at_ + 1)) return add(take_sizes(numbers));
        add(std::max(largest_, numbers));
        at_ = behind_sizes(at_);
    }
    /// @param value  "=" and what follows; empty: none
    void define(std::string_view name, Tokens value) {
        const std::optional<std::int64_t> number =
            value.empty() ? std::nullopt : constant_value(value.subspan(1), constants_);
        const auto [at, is_new] = constants_.try_emplace(name, number);
        if (!is_new) at->second = std::max(at->second, number);  // of several scopes or branches, the largest
    }

    /// Behind all of [2][3].
    std::size_t behind_sizes(std::size_t from) const {
        while (is("[", from)) from = brackets_[from] + 1;
        return from;
    }
    std::int64_t arguments_at(std::size_t bracket) const {
        std::int64_t count = 1;
        for (std::size_t i = value_ends_[bracket + 1]; is(",", i); i = value_ends_[i + 1]) ++count;
        return count;
    }

    /// The product of [2][3] and what each has.
    std::int64_t take_sizes(std::int64_t numbers) {
        while (is("[", at_)) {
            const std::size_t end = std::min(brackets_[at_], tokens_.size());
            const Tokens size = Tokens(tokens_).subspan(at_ + 1, end - at_ - 1);
            if (!size.empty()) {
                // What cannot be told here is left to the process that compiles the text first, within limits.
                const std::int64_t count = constant_value(size, constants_).value_or(1);
                numbers = checked(numbers * std::max<std::int64_t>(count, 1));
            }
            at_ = end + 1;
        }
        return checked(numbers);
    }
    std::int64_t checked(std::int64_t numbers) const {
        if (numbers > max_array_numbers)
            refuse_shader(name_, line(),
                          format_text("the arrays of the text hold more than {} numbers", max_array_numbers));
        return numbers;
    }
    void add(std::int64_t numbers) {
        std::int64_t& to = structs_.empty() ? total_ : structs_.back().numbers;
        to = checked(to + numbers);
        largest_ = std::max(largest_, numbers);
    }

    const std::string& name_;
    const std::vector<ShaderToken>& tokens_;
    std::size_t at_ = 0, depth_ = 0;
    bool is_const_ = false;
    std::vector<std::size_t> value_ends_;  ///< [tokens + 1] the next "," or ";" or closing bracket that is in no others
    std::vector<std::size_t> brackets_;    ///< [tokens] of an opening bracket: the closing one
    std::vector<Struct> structs_;          ///< whose members are being read
    std::map<std::string_view, std::int64_t> types_;
    ShaderConstants constants_;
    std::int64_t total_ = 0, largest_ = 0;
};

}  // namespace

void check_shader_arrays(const std::string& name, const std::vector<ShaderToken>& tokens) { Arrays(name, tokens); }

}  // namespace rakelight
