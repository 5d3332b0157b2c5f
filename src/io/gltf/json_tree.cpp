// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/json_tree.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <vector>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint64_t value_bytes = 32;   // one value in an array that has grown by doubling
constexpr std::uint64_t member_bytes = 96;  // a red-black tree node with a short key and its value
constexpr std::uint64_t charge_step = 1u << 20;

/// Builds the tree from the parser's events. nlohmann's own builder has no limit on depth.
class TreeBuilder final : public nlohmann::json_sax<Json> {
public:
    TreeBuilder(Json& root, const std::string& file, MemoryCharge& charge, Context& context)
        : root_(root), file_(file), charge_(charge), context_(context) {}

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override {
        charge(value.size() + 32);
        return add(std::move(value));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        charge(member_bytes + name.size());
        const auto [member, is_new] = stack_.back()->get_ref<Json::object_t&>().try_emplace(name);
        if (!is_new)
            context_.report().add(
                Remark::warning, file_, {},
                "the JSON name '" + one_line(name, 60) + "' occurs twice in one object; the last one counts");
        member_ = &member->second;
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& problem) override {
        std::string text = problem.what();  // "[json.exception.parse_error.101] parse error at line 1, column 1: ..."
        if (const auto end = text.find("] "); end != std::string::npos) text.erase(0, end + 2);
        throw Error(ErrorCode::bad_file, "not valid JSON: " + text);
    }

    void finish() { charge_.grow(pending_, "the JSON tree"); }

private:
    template <class T>
    bool add(T&& value) {
        place(std::forward<T>(value));
        return true;
    }

    bool open(Json container) {
        if (stack_.size() >= max_json_depth)
            throw Error(ErrorCode::bad_file,
                        format_text("the JSON is nested more than {} levels deep", max_json_depth));
        stack_.push_back(place(std::move(container)));
        return true;
    }

    bool close() {
        stack_.pop_back();
        return true;
    }

    /// Puts a value where the parser is: the root, the end of an array, or the member that key() announced.
    template <class T>
    Json* place(T&& value) {
        if (stack_.empty()) return &(root_ = Json(std::forward<T>(value)));
        Json& parent = *stack_.back();
        if (parent.is_object()) return &(*member_ = Json(std::forward<T>(value)));
        charge(value_bytes);
        parent.push_back(Json(std::forward<T>(value)));
        return &parent.back();
    }

    void charge(std::uint64_t bytes) {
        pending_ += bytes;
        if (pending_ < charge_step) return;
        charge_.grow(pending_, "the JSON tree");
        pending_ = 0;
    }

    Json& root_;
    const std::string& file_;
    MemoryCharge& charge_;
    Context& context_;
    std::vector<Json*> stack_;  // stays right while arrays grow: only the last element of an array is ever open
    Json* member_ = nullptr;
    std::uint64_t pending_ = 0;
};

}  // namespace

Json parse_json(std::span<const std::byte> text, const std::string& file, MemoryCharge& charge, Context& context) {
    const char* begin = reinterpret_cast<const char*>(text.data());
    const char* end = begin + text.size();
    if (text.size() >= 3 && std::memcmp(begin, "\xEF\xBB\xBF", 3) == 0) {
        begin += 3;
        context.report().add(Remark::warning, file, {}, "the JSON begins with a byte order mark, which glTF forbids");
    }
    Json root;
    TreeBuilder builder(root, file, charge, context);
    Json::sax_parse(begin, end, &builder);
    builder.finish();
    return root;
}

}  // namespace rakelight::io::gltf
