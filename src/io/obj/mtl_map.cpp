// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl_map.h"

#include <cmath>
#include <initializer_list>

#include <rakelight_internal/base/text.h>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"

namespace rakelight::io::obj {
namespace {

class OptionReader {
public:
    OptionReader(std::string_view file, std::size_t begin, std::size_t end, std::uint64_t line, Remarks& remarks)
        : file_(file), at_(begin), end_(end), line_(line), remarks_(remarks) {}

    std::optional<MtlMap> read() {
        map_.line = line_;
        for (Token word; peek(word) && word.text[0] == '-' && option(word);)
            ;
        map_.file = name_text(file_, at_, end_);
        trailing_multiplier();
        if (map_.file.size() >= 2 && map_.file.front() == '"' && map_.file.back() == '"')
            map_.file = map_.file.substr(1, map_.file.size() - 2);
        if (map_.file.empty()) return std::nullopt;
        return std::move(map_);
    }

private:
    bool peek(Token& word) const {
        Tokens words(file_, at_, end_);
        return words.next(word);
    }
    bool take(Token& word) {
        if (!peek(word)) return false;
        at_ = word.end();
        return true;
    }
    std::optional<double> take_number() {
        Token word;
        const auto value = peek(word) ? parse_number(word.text) : std::nullopt;
        if (value) at_ = word.end();
        return value;
    }
    /// A value that is not finite keeps the default.
    void set(float& target, double value) {
        if (std::isfinite(float(value)))
            target = float(value);
        else
            remarks_.add(Issue::mtl_number, line_);
    }

    /// @return false when the word is no option (a file name that begins with '-')
    bool option(const Token& word) {
        const std::string name = lower_case(word.text);
        const std::size_t before = at_;
        at_ = word.end();
        if (name == "-bm")
            multiplier();
        else if (name == "-o")
            pair(map_.offset, {0, 0});
        else if (name == "-s")
            pair(map_.scale, {1, 1});
        else if (name == "-t")
            turbulence();
        else if (name == "-mm")
            range();
        else if (name == "-clamp")
            map_.is_clamped = is_on();
        else if (name == "-cc") {
            if (is_on()) remarks_.add(Issue::mtl_option, line_);
        } else if (name == "-blendu" || name == "-blendv") {
            if (!is_on()) remarks_.add(Issue::mtl_option_hint, line_);
        } else if (name == "-boost" || name == "-texres") {
            take_number();
            remarks_.add(Issue::mtl_option_hint, line_);
        } else if (name == "-imfchan")
            channel();
        else if (name == "-type") {
            Token value;
            take(value);
        } else {
            at_ = before;
            return false;
        }
        return true;
    }

    void multiplier() {
        const auto value = take_number();
        if (value && std::isfinite(*value))
            map_.bump_multiplier = value;
        else
            remarks_.add(Issue::mtl_number, line_);
    }

    // u [v [w]]; missing ones keep the default of the option.
    void pair(vec2& target, vec2 initial) {
        target = initial;
        if (const auto u = take_number())
            set(target.x, *u);
        else
            return remarks_.add(Issue::mtl_number, line_);
        if (const auto v = take_number())
            set(target.y, *v);
        else
            return;
        take_number();
    }

    void turbulence() {
        bool is_some = false;
        for (int i = 0; i < 3; ++i)
            if (const auto value = take_number())
                is_some = is_some || *value != 0;
            else
                break;
        if (is_some) remarks_.add(Issue::mtl_option, line_);
    }

    void range() {
        const auto base = take_number(), gain = take_number();
        if (base.value_or(0) != 0) remarks_.add(Issue::mtl_option, line_);
        if (gain && std::isfinite(*gain)) map_.gain = gain;
    }

    void channel() {
        Token value;
        if (take(value) && value.text != "l" && value.text != "m" && value.text != "r")
            remarks_.add(Issue::mtl_option, line_);
    }

    bool is_on() {
        Token value;
        return take(value) && lower_case(value.text) == "on";
    }

    void trailing_multiplier() {
        const std::size_t at = map_.file.rfind(" -bm ");
        if (at == std::string::npos) return;
        const auto value = parse_number(name_text(map_.file, at + 5, map_.file.size()));
        if (!value || !std::isfinite(*value)) return;
        map_.bump_multiplier = value;
        map_.file = name_text(map_.file, 0, at);
    }

    std::string_view file_;
    std::size_t at_, end_;
    std::uint64_t line_;
    Remarks& remarks_;
    MtlMap map_;
};

}  // namespace

std::optional<MtlMap> parse_map(std::string_view file, std::size_t begin, std::size_t end, std::uint64_t line,
                                Remarks& remarks) {
    return OptionReader(file, begin, end, line, remarks).read();
}

}  // namespace rakelight::io::obj
