// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_constants.h"

#include <charconv>
#include <string>

namespace rakelight {
namespace {

using Value = std::optional<std::int64_t>;
constexpr int deepest = 64;

Value in_range(std::int64_t value) { return value >= INT32_MIN && value <= INT32_MAX ? Value(value) : std::nullopt; }

Value literal(std::string_view text) {
    if (text.ends_with('u') || text.ends_with('U')) text.remove_suffix(1);
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X"))
        base = 16, text.remove_prefix(2);
    else if (text.size() > 1 && text[0] == '0')
        base = 8;
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return fault == std::errc() && end == text.data() + text.size() ? in_range(value) : std::nullopt;
}

struct Operator {
    std::string_view text;
    int rank;  ///< a higher one binds more
};
constexpr Operator operators[] = {{"||", 1}, {"&&", 2}, {"==", 6}, {"!=", 6}, {"<=", 7}, {">=", 7},
                                  {"<<", 8}, {">>", 8}, {"|", 3},  {"^", 4},  {"&", 5},  {"<", 7},
                                  {">", 7},  {"+", 9},  {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};

Value applied(std::string_view op, std::int64_t a, std::int64_t b) {
    if (op == "+") return in_range(a + b);
    if (op == "-") return in_range(a - b);
    if (op == "*") return in_range(a * b);
    if (op == "/") return b != 0 ? in_range(a / b) : std::nullopt;
    if (op == "%") return b > 0 && a >= 0 ? in_range(a % b) : std::nullopt;
    if (op == "<<") return a >= 0 && b >= 0 && b < 32 ? in_range(a << b) : std::nullopt;
    if (op == ">>") return a >= 0 && b >= 0 && b < 32 ? in_range(a >> b) : std::nullopt;
    if (op == "&") return in_range(a & b);
    if (op == "|") return in_range(a | b);
    if (op == "^") return in_range(a ^ b);
    return {};  // of booleans: no size is one
}

class Reader {
public:
    Reader(std::span<const ShaderToken> tokens, const ShaderConstants& constants)
        : tokens_(tokens), constants_(constants) {}
    Value whole() {
        const Value value = binary(0);
        return at_ == tokens_.size() ? value : std::nullopt;
    }

private:
    bool is(std::string_view text, std::size_t ahead = 0) const {
        return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].text == text;
    }
    const Operator* next_operator() const {
        for (const Operator& op : operators)
            if (is(op.text.substr(0, 1)) && (op.text.size() == 1 || is(op.text.substr(1), 1))) return &op;
        return nullptr;
    }
    Value binary(int least) {
        Value left = unary();
        while (left) {
            const Operator* const op = next_operator();
            if (!op || op->rank <= least) break;
            at_ += op->text.size();
            const Value right = binary(op->rank);
            left = right ? applied(op->text, *left, *right) : std::nullopt;
        }
        return left;
    }
    Value unary() {
        bool is_negative = false;
        for (; is("-") || is("+"); ++at_) is_negative ^= is("-");
        const Value value = primary();
        return value && is_negative ? in_range(-*value) : value;
    }
    Value primary() {
        if ((is("int") || is("uint")) && is("(", 1)) ++at_;
        if (is("(")) {
            if (++depth_ > deepest) return {};
            ++at_;
            const Value value = binary(0);
            if (!is(")")) return {};
            ++at_, --depth_;
            return value;
        }
        if (at_ == tokens_.size()) return {};
        const ShaderToken& token = tokens_[at_++];
        if (!token.is_word()) return literal(token.text);
        const auto constant = constants_.find(token.text);
        return constant == constants_.end() ? std::nullopt : constant->second;
    }

    std::span<const ShaderToken> tokens_;
    const ShaderConstants& constants_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

std::optional<std::int64_t> constant_value(std::span<const ShaderToken> expression, const ShaderConstants& constants) {
    return Reader(expression, constants).whole();
}

}  // namespace rakelight
