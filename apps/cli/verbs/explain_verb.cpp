// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/tools/text_file.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command explain_command() {
    const Option pixel = {.name = "pixel",
                          .group = "Output",
                          .type = "X,Y",
                          .help = "Pixel to explain; 0,0 is the top left one. May be repeated",
                          .form = apps::Form::list,
                          .is_required = true};
    const Option output = {.name = "output",
                           .group = "Output",
                           .type = "FILE",
                           .help = "Write to this file instead of standard output: .json as JSON, else as text",
                           .letter = 'o'};
    // Options about files and parts of pictures have no meaning here.
    std::vector<Option> options = apps::without(
        apps::picture_options(),
        {"window", "channels", "channel-files", "exr-colors", "engine", "line-width", "point-size", "line-color"});
    apps::hide_drawn_lines(options);
    return {"explain",
            "Explain the color of a pixel, with every number that leads to it",
            explain_footer,
            {{"MODEL", models_help}},
            apps::joined(
                {{pixel, output}, apps::input_options(), options, {apps::shader_option()}, apps::common_options()})};
}

std::vector<PixelPlace> pixels_of(const Run& run) {
    const RenderSettings& s = run.picture.settings;
    std::vector<PixelPlace> pixels;
    for (const std::string& word : run.given.words("pixel")) {
        const std::vector<int> pixel = values::integers("pixel", word, 2);
        pixels.push_back({pixel[0], pixel[1]});
        if (std::ranges::all_of(run.inputs, is_world_file)) continue;  // may say how large they are
        if (pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= s.width || pixel[1] >= s.height)
            throw values::wrong("pixel",
                                one_line(word, 20) + " is not in the picture: it has " + std::to_string(s.width) +
                                    " x " + std::to_string(s.height) + " pixels, counted from 0",
                                "--resolution sets how many");
    }
    return pixels;
}

/// The rows of one input: one for each pixel, all with the remarks about the input.
int explain_input(const Run& run, const InputRequest& input, const std::vector<PixelPlace>& pixels,
                  std::vector<ExplainRow>& rows) {
    ExplainRow common{.file = input.picture.input};
    std::vector<std::shared_ptr<const ExplainedPixel>> explained(pixels.size());
    int code = exit_code(ErrorCode::failed);
    if (CancelOnInterrupt::happened())
        common.error = Error(ErrorCode::failed, "cancelled").with_file(common.file);
    else
        code = run_input(run, input, common, [&](Context& c) { explained = explain(input.picture, pixels, c); });
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        ExplainRow& row = rows.emplace_back(common);
        row.x = pixels[i].x, row.y = pixels[i].y, row.pixel = explained[i];
    }
    return code;
}

std::string text_of(const std::vector<ExplainRow>& rows) {
    std::string text;
    for (const ExplainRow& row : rows)
        if (row.pixel) text += (text.empty() ? "" : "\n") + with_options(to_text(*row.pixel), {"look"});
    return text;
}

int run_explain(const Run& run) {
    const std::vector<PixelPlace> pixels = pixels_of(run);
    const std::string& output = run.picture.output;
    const bool has_file = !output.empty() && output != "-", is_json = run.is_json || file_ending(output) == "json";
    if (has_picture_ending(output))
        throw values::wrong("output", "an explanation is text or JSON",
                            "write for example -o pixel.txt or -o pixel.json");
    if (has_file) check_text_output(output);
    std::vector<ExplainRow> rows;
    int worst = 0;
    for (const std::string& file : run.inputs) {
        std::vector<ExplainRow> of_input;
        worst = std::max(worst, explain_input(run, request_for(run, file), pixels, of_input));
        if (!is_json && !has_file) print_text((rows.empty() ? "" : "\n") + text_of(of_input));
        rows.insert(rows.end(), of_input.begin(), of_input.end());
    }
    if (has_file)
        save_text(output, is_json ? to_json(rows) : text_of(rows));
    else if (is_json)
        print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb explain_verb = {explain_command, run_explain};

}  // namespace rakelight::cli
