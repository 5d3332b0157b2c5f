// SPDX-License-Identifier: Apache-2.0
#include "own_keys.h"

#include <algorithm>
#include <cctype>

namespace rakelight::viewer {
namespace {

struct Named {
    const char* name;
    Key key;
};
constexpr Named named[] = {{"Space", 32},   {"Esc", 256},     {"Enter", 257},     {"Tab", 258},  {"Backspace", 259},
                           {"Insert", 260}, {"Del", 261},     {"Right", 262},     {"Left", 263}, {"Down", 264},
                           {"Up", 265},     {"Page up", 266}, {"Page down", 267}, {"Home", 268}, {"End", 269}};
constexpr Named prefixes[] = {{"Ctrl+", mod_control}, {"Shift+", mod_shift}, {"Alt+", mod_alt}};
constexpr Key f1 = 290;

std::optional<Key> plain_key(const std::string& name) {
    constexpr std::string_view signs =
        "'+,-./;=[\\]`";  // keys have the names of their signs without Shift; + of some keyboards
    if (name.size() == 1 && (std::isalnum(static_cast<unsigned char>(name[0])) || signs.find(name[0]) != signs.npos))
        return std::toupper(static_cast<unsigned char>(name[0]));
    for (const Named& n : named)
        if (name == n.name) return n.key;
    for (int i = 1; i <= 12; ++i)
        if (name == "F" + std::to_string(i)) return f1 + i - 1;
    return {};
}

}  // namespace

std::optional<std::pair<Key, int>> key_named(const std::string& name) {
    std::string rest = name;
    int modifiers = 0;
    for (bool is_found = true; is_found;) {
        is_found = false;
        for (const Named& prefix : prefixes)
            if (const std::string text = prefix.name; rest.size() > text.size() && rest.starts_with(text))
                rest.erase(0, text.size()), modifiers |= prefix.key, is_found = true;
    }
    const std::optional<Key> key = plain_key(rest);
    return key ? std::optional(std::pair(*key, modifiers)) : std::nullopt;
}

std::optional<OwnKey> own_key(const std::string& keys, const std::string& usual) {
    const auto own = key_named(keys), from = key_named(usual);
    const Command command = from ? command_of(from->first, from->second) : Command::none;
    if (!own || (command == Command::none && usual != "none")) return {};
    return OwnKey{keys, usual, own->first, own->second, command};
}

Command command_of(Key key, int modifiers, std::span<const OwnKey> own) {
    const auto found = std::ranges::find_if(
        own, [=](const OwnKey& k) { return k.key == without_keypad(key) && k.modifiers == modifiers; });
    return found != own.end() ? found->command : command_of(key, modifiers);
}

}  // namespace rakelight::viewer
