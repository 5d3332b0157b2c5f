// SPDX-License-Identifier: Apache-2.0
// Keys of the user's own: each does what one of the usual keys does.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "keys.h"

namespace rakelight::viewer {

struct OwnKey {
    std::string keys, usual;  ///< as in the settings: "Ctrl+K", and the usual keys of what it does, or "none"
    Key key = 0;
    int modifiers = 0;
    Command command = Command::none;
    bool operator==(const OwnKey&) const = default;
};

/// "Ctrl+Shift+S", "F9", "Page down", ".": the key and its Modifier bits; none: there is no such key.
std::optional<std::pair<Key, int>> key_named(const std::string& name);
/// None: one of the names is wrong, or the usual key does nothing.
std::optional<OwnKey> own_key(const std::string& keys, const std::string& usual);
/// The user's own keys go before the usual ones.
Command command_of(Key key, int modifiers, std::span<const OwnKey> own);

}  // namespace rakelight::viewer
