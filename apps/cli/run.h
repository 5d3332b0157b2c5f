// SPDX-License-Identifier: Apache-2.0
// What the command line asks for, and the requests that come of it.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/render/picture.h>
#include <rakelight/world/world_request.h>

#include "../common/command_line.h"
#include "../common/interrupt.h"
#include "console.h"
#include "inputs.h"
#include "progress_line.h"

namespace rakelight::cli {

using apps::CancelOnInterrupt;
using apps::Command;
using apps::Given;
using apps::Option;

/// One run of the program.
struct Run {
    const Command& command;
    Given given;
    std::vector<std::string> inputs;  ///< models by path; folders are gone through, standard input has a name
    std::map<std::string, InputFolder> folders;  ///< of the inputs
    int threads = 0;
    std::uint64_t max_memory = 0;
    bool is_json = false;
    Loudness loudness = Loudness::normal;
    std::optional<WorldRequest> config;  ///< of --config: its settings are among those that were given
    /// For progress lines: counted up by each file that is begun. A command that has another number of them than inputs says so.
    std::shared_ptr<FileCount> files = std::make_shared<FileCount>();
    PictureRequest picture;  ///< by the settings that were given; its output holds the name template
};

/// @throws Error usage, one line
Run run_of(const Command& command, apps::CommandLine line);

/// The work to do for one input, or why nothing can be done.
struct InputRequest {
    PictureRequest picture;
    std::optional<Error> error;
    std::optional<WorldRequest> world;  ///< of a world file, else of --config: where settings stand
};

/// The request for an input: as the command line says, and for a world file by its [render], too.
InputRequest request_for(const Run& run, const std::string& input);

/// The value of {camera} in the outputs of a request.
std::string camera_of(const PictureRequest& picture);

/// A request for each input, each with an output of its own (output_names.h).
/// @param frame  how often the pictures are drawn, with this time; absent: {frame} stays in the outputs
/// @throws Error usage: several inputs for one output, or two inputs for the same
std::vector<InputRequest> picture_requests(const Run& run, std::optional<int> frame = 1);

/// How a world is drawn by its [render] and the settings that were given.
/// @throws Error bad_file with line and column, usage
WorldRequest world_request(const Run& run, const std::string& path, std::vector<WorldValue> given);

/// check_request() of all. @throws Error usage, failed; what is wrong with a world's settings becomes its error
void check_requests(std::vector<InputRequest>& requests);

}  // namespace rakelight::cli
