// SPDX-License-Identifier: Apache-2.0
#include "world_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

#include <rakelight/words.h>

#include "switches.h"

namespace rakelight::cli {
namespace {

[[noreturn]] void fail(const WorldValue& value, std::string reason, std::string advice = {}) {
    throw Error(ErrorCode::bad_file, std::move(reason), to_text(value.place), std::move(advice));
}

/// About the run and not about the picture; a file that was sent by somebody does not say them.
bool is_for_the_command_line_alone(std::string_view key) {
    for (const char* name :
         {"output", "help", "json", "quiet", "verbose", "stats", "threads", "max-memory", "allow-outside", "material"})
        if (key == name) return true;
    return false;
}

/// Options that exclude each other: one of the command line takes the others of the world away.
bool is_excluded(const CLI::App& verb, std::string_view key) {
    constexpr std::string_view placements[] = {"view", "camera-index", "camera-position"};
    if (std::find(std::begin(placements), std::end(placements), key) == std::end(placements)) return false;
    return std::any_of(std::begin(placements), std::end(placements), [&](std::string_view name) {
        const CLI::Option* const option = verb.get_option_no_throw("--" + std::string(name));
        return option && option->count() > 0;
    });
}

void check_known(const CLI::App& render, const WorldValue& value) {
    if (is_for_the_command_line_alone(value.key)) fail(value, "'" + value.key + "' is for the command line alone");
    if (render.get_option_no_throw("--" + value.key)) return;
    std::vector<std::string> names;
    for (const CLI::Option* option : render.get_options())
        for (const std::string& name : option->get_lnames())
            if (!is_for_the_command_line_alone(name)) names.push_back(name);
    const std::string near = nearest_word(value.key, {names.begin(), names.end()});
    fail(value, "unknown key '" + one_line(value.key, 40) + "' in [render]",
         near.empty() ? "keys are options of rakelight render" : "did you mean '" + near + "'?");
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
    return text;
}

/// Names of pictures count from the world's folder.
std::string resolved(const CLI::Option& option, const std::string& word, const WorldValue& value,
                     const WorldOptions& world) {
    if (option.get_type_name() != "FILE") return word;
    try {
        std::string file = resolve_in_world(world.path, word, world.allow_outside);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored))
            throw Error(ErrorCode::not_found, "'" + one_line(word, 80) + "': there is no such file");
        return file;
    } catch (const Error& error) {
        throw Error(error.code(), error.reason(), to_text(value.place), error.advice());
    }
}

void give(CLI::Option& option, const WorldValue& value, const WorldOptions& world) {
    const bool is_flag = option.get_items_expected_max() == 0;
    if (is_flag) {
        const bool is_word = value.words.size() == 1 && (value.words[0] == "on" || value.words[0] == "off");
        if (!is_word) fail(value, "'" + value.key + "' must be true or false");
        if (is_switch(option) || value.words[0] == "on") option.add_result(is_switch(option) ? value.words[0] : "true");
    } else if (option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll) {
        for (const std::string& word : value.words) option.add_result(word);
    } else {
        option.add_result(resolved(option, joined(value.words), value, world));
    }
    if (option.count() > 0) option.run_callback();
}

}  // namespace

std::vector<std::string> add_world_options(CLI::App& verb, const CLI::App& render, const WorldOptions& world) {
    std::vector<std::string> given;  // several values of one option may stand apart in the world
    for (const CLI::Option* option : verb.get_options())
        if (option->count() > 0) given.push_back(option->get_name());
    std::vector<const WorldValue*> accepted;
    std::vector<std::string> overridden;
    for (const WorldValue& value : world.render) {
        check_known(render, value);
        if (is_excluded(verb, value.key))
            overridden.push_back(value.key);
        else
            accepted.push_back(&value);
    }
    for (const WorldValue* value : accepted) {
        CLI::Option* const option = verb.get_option_no_throw("--" + value->key);
        if (!option) continue;
        if (std::find(given.begin(), given.end(), option->get_name()) != given.end()) {
            overridden.push_back(value->key);
            continue;
        }
        if (option->get_group() == "Heat map" && verb.get_option("--heatmap")->count() == 0) continue;
        try {
            give(*option, *value, world);
        } catch (const CLI::Error& error) {
            fail(*value, "'" + value->key + "': " + one_line(error.what(), 200));
        }
    }
    return overridden;
}

/// The settings that an error is about: the first word of the one, then the others.
static std::vector<std::string> settings_of(const Error& error) {
    std::vector<std::string> all = error.related();
    if (!error.setting().empty()) all.insert(all.begin(), error.setting().substr(0, error.setting().find(' ')));
    return all;
}

static bool is_given(std::span<const std::string> arguments, const std::string& setting) {
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](const std::string& word) { return word.substr(0, word.find('=')) == "--" + setting; });
}

static const WorldValue* value_of(const WorldOptions& world, const std::string& setting) {
    const auto found = std::ranges::find(world.render, setting, &WorldValue::key);
    return found == world.render.end() ? nullptr : &*found;
}

/// An option of the command line that does not go with one of the world: names both.
static std::optional<Error> disagreement(const Error& error, const WorldOptions& world,
                                         std::span<const std::string> arguments) {
    std::string given, of_world;
    for (const std::string& setting : settings_of(error)) {
        const WorldValue* const value = value_of(world, setting);
        if (is_given(arguments, setting))
            given = "--" + setting;
        else if (value)
            of_world = "'" + setting + "' is of " + one_line(world.path, 80) + ", " + to_text(value->place);
    }
    if (given.empty() || of_world.empty()) return {};
    return Error(ErrorCode::usage, error.reason(), {}, of_world + ", " + given + " of the command line")
        .about(error.setting(), error.related());
}

/// The error at the option of the world that it is about; none where the command line gave that one.
static std::optional<Error> placed(const Error& error, const WorldOptions& world,
                                   std::span<const std::string> arguments) {
    for (const std::string& setting : settings_of(error)) {
        const WorldValue* const value = value_of(world, setting);
        if (!value || is_given(arguments, setting)) continue;
        return Error(ErrorCode::bad_file, error.reason(), to_text(value->place), error.advice())
            .about(error.setting(), error.related())
            .with_file(world.path);
    }
    return {};
}

Error at_option(const Error& error, const WorldOptions& world, std::span<const std::string> arguments) {
    return placed(error, world, arguments).value_or(error);
}

Error with_place(const Error& error, const WorldOptions& world, std::span<const std::string> arguments) {
    if (const auto both = disagreement(error, world, arguments)) return *both;
    if (const auto one = placed(error, world, arguments)) return *one;
    return error.file().empty() ? Error(error.code() == ErrorCode::usage ? ErrorCode::bad_file : error.code(),
                                        error.reason(), error.place(), error.advice())
                                      .about(error.setting())
                                      .with_file(world.path)
                                : error;
}

}  // namespace rakelight::cli
