// SPDX-License-Identifier: Apache-2.0
// The contents of world files: sections and their keys, as tables that the reader and the JSON schema share.
#pragma once
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/io/world.h>
#include <rakelight/scene/words.h>

namespace rakelight::io::world {

enum class Kind {
    text,
    file,  ///< a text that names one
    word,  ///< out of WorldKey::words
    flag,
    number,
    integer,
    pair,      ///< two numbers
    integers,  ///< two whole numbers
    vector,    ///< three numbers
    scale,     ///< one number or three
    tables,    ///< a list of tables of WorldKey::parts
    color,     ///< three numbers >= 0 of linear light, or "#rrggbb", "#rgb" or a name of CSS, as seen on a display
};

/// Of each number of a value.
struct Range {
    double low = -1e30, high = 1e30;
    bool is_open = false;  ///< low and high themselves are not allowed
};
inline constexpr Range any_number{}, from_0{0, 1e30}, above_0{0, 1e30, true}, from_0_to_1{0, 1};

struct WorldKey {
    const char* name;
    Kind kind;
    const char* help;  ///< for people, in the schema
    Range range = any_number;
    std::vector<const char*> words = {};
    bool is_required = false;
    std::vector<WorldKey> parts = {};
};

struct WorldSection {
    const char* name;
    bool is_array;  ///< [[name]] as often as wanted; else [name] once
    const char* help;
    std::vector<WorldKey> keys;
};

/// All but [render], whose keys are options of the command line.
const std::vector<WorldSection>& sections();
const WorldSection& section(std::string_view name);

std::vector<WorldKey> light_keys();

template <class T>
std::vector<const char*> names_of(std::span<const Word<T>> words) {
    std::vector<const char*> names;
    for (const Word<T>& word : words) names.push_back(word.name);
    return names;
}
/// @throws Error bad_file: `name` is none of the words; a key's own words (WorldKey::words) were checked before
template <class T, std::size_t n>
T value_of(const Word<T> (&words)[n], std::string_view name) {
    for (const Word<T>& word : words)
        if (name == word.name) return word.value;
    throw Error(ErrorCode::bad_file, "'" + one_line(std::string(name), 40) + "' is not one of the words allowed here");
}

}  // namespace rakelight::io::world
