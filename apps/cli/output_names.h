// SPDX-License-Identifier: Apache-2.0
// Names of outputs by the template behind -o: one for each input.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace rakelight::cli {

struct Run;

/// The values that replace the placeholders of a template.
struct OutputParts {
    std::string camera = "default";  ///< camera or side
    std::optional<int> frame =
        1;  ///< with --watch: how often it was drawn; absent: the name stays a template for frame_name()
};

class OutputNames {
public:
    /// A folder stands for a file in it for each model, of the kind that the command writes.
    /// @throws Error usage: an unknown word in braces; several inputs for one output
    OutputNames(const Run& run, std::size_t inputs);
    /// The same of another output than -o.
    OutputNames(const Run& run, std::size_t inputs, std::string output);
    /// The name for the next input. @throws Error usage: the same as another input's
    std::string of(const std::string& input, const OutputParts& parts = {});

private:
    std::string example_of_parts(const std::string& input) const;

    const Run& run_;
    std::string template_;
    bool is_folder_ = false;  ///< the template names a folder
    std::size_t count_ = 0;
    std::map<std::string, std::string> inputs_of_;  ///< output -> input
};

/// @throws Error usage: the name of a picture without an ending, which may be meant as a folder's
void check_picture_name(const Run& run);

/// The word of `--format` that is one of pictures (or of models); empty: none is.
/// @throws Error usage: a word that is neither, or two of a kind
std::string picture_format(const Run& run);
std::string model_format(const Run& run);

/// Whether the output is standard output: "-", or "png:-" with its format.
bool is_standard_output(const std::string& output);

}  // namespace rakelight::cli
