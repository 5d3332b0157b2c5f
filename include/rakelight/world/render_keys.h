// SPDX-License-Identifier: Apache-2.0
// The keys of [render] in world files: each sets one setting of a picture.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// A key of [render] and the setting that it controls.
struct RenderKey {
    /// The form of the value.
    enum class Kind : std::uint8_t {
        value,
        file,    ///< a file name
        flag,    ///< true or false
        on_off,  ///< a flag with a default that may be on
        list,    ///< any number of values, in order
    };
    const char* name;  ///< "crease-angle"
    Kind kind{};
    /// Sets the setting.
    /// @param words  one word, or at least one element of a list; flags are "on" or "off"
    /// @throws Error usage about the key
    void (*read)(PictureRequest& to, std::span<const std::string> words);
    /// Words from which read() restores the setting. Empty: the setting has its default.
    std::vector<std::string> (*write)(const PictureRequest& of);
};

/// All keys in the order in which they are read.
RL_API std::span<const RenderKey> render_keys();
/// The key of that name, or null.
RL_API const RenderKey* find_render_key(std::string_view name);
/// The key of that name.
/// @throws Error usage: no such key; the message has the nearest name
RL_API const RenderKey& require_render_key(const std::string& name);
/// Whether a key of [render] places the camera: a side, a camera of the file, a position, a direction. Such keys
/// override each other.
RL_API bool places_camera(std::string_view key);

/// Whether the words of a value of [render] are file names. Such names are relative to the folder of the world file.
RL_API bool names_files(const WorldValue& value);

/// Applies values, each key once, and checks their combination. File names are used unchanged.
/// @throws Error usage about the key: unknown key, invalid value, or conflicting keys
RL_API void read_render_keys(std::span<const WorldValue> values, PictureRequest& to);

/// The inverse of read_render_keys(): the keys of settings that differ from their defaults. Colors are exact up to 1e-6
/// in display values, light directions are normalized, and light names are lost. Input, output and LoadOptions have no
/// keys.
/// @throws Error usage: keys cannot express a setting, such as an empty list of lights or a light on a node
RL_API std::vector<WorldValue> written_render_keys(const PictureRequest& of);

}  // namespace rakelight
