// SPDX-License-Identifier: Apache-2.0
// What a program takes on its command line, as tables, and what it was given.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/io/world.h>

namespace rakelight::apps {

/// How an option takes its value.
enum class Form : std::uint8_t {
    value,
    list,    ///< a value, and it may be repeated
    flag,    ///< stands alone
    on_off,  ///< stands alone, or with on or off behind it
};

/// An option: "--crease-angle DEG".
struct Option {
    const char* name;   ///< without dashes; of a setting its key
    const char* group;  ///< title above it in the help
    const char* type;   ///< of its value, in the help
    const char* help;
    Form form = Form::value;
    bool is_setting = false;  ///< a key of [render] in world files
    bool is_required = false;
    bool is_hidden = false;      ///< known, but not in the help
    char letter = 0;             ///< "-o"; 0: none
    const char* also = nullptr;  ///< another name of it, in the help too; null: none
    /// The words that its value can be: those that it is read by. Null: other values, or a setting, whose key has them.
    std::vector<std::string> (*words)() = nullptr;
    bool takes_several_words = false;  ///< with commas between
};

/// Option::words of the table that the value is read by.
template <const auto& table>
std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (const auto& word : table) names.emplace_back(word.name);
    return names;
}

/// Words without dashes.
struct Positional {
    const char *name, *help;
    bool is_required = true;
    bool is_list = true;
    std::vector<std::string> (*words)() = nullptr;  ///< as Option::words
};

/// A command of a program: `rakelight render`.
struct Command {
    const char *name, *help;
    const char* footer;  ///< below its options in the help; may be null
    std::vector<Positional> positionals;
    std::vector<Option> options;
    std::vector<Option> of_worlds{};  ///< settings that it takes of a world file, but not of the command line
};

/// The option of that name. @throws nothing: it has to be there
Option& find(std::vector<Option>& options, std::string_view name);
const Option* find_or_null(const std::vector<Option>& options, std::string_view name);
/// All but some.
std::vector<Option> without(std::vector<Option> options, std::initializer_list<std::string_view> names);

/// What was given, by the options' names.
class Given {
public:
    Given() = default;
    explicit Given(std::vector<WorldValue> values, std::vector<WorldValue> settings = {})
        : values_(std::move(values)), settings_(std::move(settings)) {}
    bool has(std::string_view name) const;
    /// Empty: not given.
    std::string word(std::string_view name) const;
    std::vector<std::string> words(std::string_view name) const;
    /// The first of some options that was; empty: none.
    std::string_view first_of(std::initializer_list<std::string_view> names) const;
    /// Those that are settings.
    const std::vector<WorldValue>& settings() const { return settings_; }
    void set_settings(std::vector<WorldValue> settings) { settings_ = std::move(settings); }

private:
    const WorldValue* find(std::string_view name) const;
    std::vector<WorldValue> values_, settings_;
};

}  // namespace rakelight::apps
