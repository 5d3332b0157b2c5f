// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_tree.h"

#include <algorithm>
#include <cstring>

#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>

#include "io/gltf/json_tree.h"

namespace rakelight::io::gltf {
namespace {

using Members = OrderedJson::object_t;

/// Keeps the last of members with one name. nlohmann's own ordered object compares each new name with all before it:
/// quadratic time, which a hostile file could ask for.
void drop_repeated(Members& object) {
    auto& members = static_cast<Members::Container&>(object);
    if (members.size() < 2) return;
    std::vector<std::size_t> order(members.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto less = [&](std::size_t a, std::size_t b) {
        const int c = members[a].first.compare(members[b].first);
        return c != 0 ? c < 0 : a < b;
    };
    std::sort(order.begin(), order.end(), less);
    std::vector<bool> is_repeated(members.size(), false);
    bool any = false;
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        if (members[order[i]].first == members[order[i + 1]].first) any = is_repeated[order[i]] = true;
    if (!any) return;
    Members::Container kept;
    for (std::size_t i = 0; i < members.size(); ++i)
        if (!is_repeated[i]) kept.push_back(std::move(members[i]));
    members = std::move(kept);
}

class Builder final : public nlohmann::json_sax<OrderedJson> {
public:
    explicit Builder(OrderedJson& root) : root_(root) {}
    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(OrderedJson::object()); }
    bool start_array(std::size_t) override { return open(OrderedJson::array()); }
    bool end_array() override { return stack_.pop_back(), true; }

    bool end_object() override {
        drop_repeated(stack_.back()->get_ref<Members&>());
        stack_.pop_back();
        return true;
    }

    bool key(string_t& name) override {
        auto& members = static_cast<Members::Container&>(stack_.back()->get_ref<Members&>());
        members.emplace_back(name, OrderedJson());
        member_ = &members.back().second;  // holds until the object's next name, when its value is whole
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        throw Error(ErrorCode::bad_file, "not valid JSON");
    }

private:
    template <class T>
    bool add(T&& value) {
        place(OrderedJson(std::forward<T>(value)));
        return true;
    }

    bool open(OrderedJson container) {
        if (stack_.size() >= max_json_depth) throw Error(ErrorCode::bad_file, "the JSON is nested too deep");
        stack_.push_back(place(std::move(container)));
        return true;
    }

    OrderedJson* place(OrderedJson value) {
        if (stack_.empty()) return &(root_ = std::move(value));
        OrderedJson& parent = *stack_.back();
        if (parent.is_object()) return &(*member_ = std::move(value));
        parent.push_back(std::move(value));
        return &parent.back();
    }

    OrderedJson& root_;
    std::vector<OrderedJson*> stack_;
    OrderedJson* member_ = nullptr;
};

}  // namespace

OrderedJson parse_ordered(std::span<const std::byte> text) {
    const char* begin = reinterpret_cast<const char*>(text.data());
    const char* end = begin + text.size();
    if (text.size() >= 3 && std::memcmp(begin, "\xEF\xBB\xBF", 3) == 0) begin += 3;
    OrderedJson root;
    Builder builder(root);
    OrderedJson::sax_parse(begin, end, &builder);
    return root;
}

std::string to_text(const OrderedJson& tree, std::span<const std::byte> model) {
    const std::string_view text(reinterpret_cast<const char*>(model.data()), std::min<std::size_t>(model.size(), 4096));
    const std::size_t line = text.find('\n');
    if (line == std::string_view::npos) return tree.dump();
    std::size_t end = line + 1;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t')) ++end;
    const std::size_t width = end - line - 1;
    const bool is_tab = width > 0 && text[line + 1] == '\t';
    return tree.dump(width == 0 ? 2 : int(std::min<std::size_t>(width, 8)), is_tab ? '\t' : ' ') + "\n";
}

void for_each_member(OrderedJson& root, const std::function<void(const std::string&, OrderedJson&)>& visit) {
    std::vector<OrderedJson*> waiting{&root};
    while (!waiting.empty()) {
        OrderedJson& at = *waiting.back();
        waiting.pop_back();
        if (at.is_object()) {
            for (auto& [name, value] : at.get_ref<OrderedJson::object_t&>()) {
                visit(name, value);
                waiting.push_back(&value);
            }
        } else if (at.is_array()) {
            for (OrderedJson& value : at) waiting.push_back(&value);
        }
    }
}

std::string meshopt_extension(const OrderedJson& view) {
    if (!view.contains("extensions")) return {};
    const OrderedJson& extensions = view["extensions"];
    for (const char* name : meshopt_names)
        if (extensions.contains(name)) return name;
    return {};
}

}  // namespace rakelight::io::gltf
