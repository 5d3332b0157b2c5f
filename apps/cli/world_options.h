// SPDX-License-Identifier: Apache-2.0
// [render] of world files: options of the command line, which goes before them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/world.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

/// The world file whose options are to be taken, and what it says.
struct WorldOptions {
    std::string path;
    std::vector<WorldValue> render;
    bool allow_outside = false;
};

/// Gives the options of a verb the world's values, where the command line gave none.
/// @param verb    that was parsed
/// @param render  the verb that has all of them; what only that one has is left out
/// @return the options of the world whose place others of the command line take
/// @throws Error bad_file with line and column: no such option, or a value that it does not take
std::vector<std::string> add_world_options(CLI::App& verb, const CLI::App& render, const WorldOptions& world);

/// The error with the place of the option that it is about, if that is one of the world's. Where one of the command
/// line is the other half of it, both are named, and the mistake is one of usage.
/// @param arguments  of the command line
Error with_place(const Error& error, const WorldOptions& world, std::span<const std::string> arguments);

/// Likewise of what is found when the scene is there: errors about nothing of [render] stay as they are.
Error at_option(const Error& error, const WorldOptions& world, std::span<const std::string> arguments);

}  // namespace rakelight::cli
