// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <filesystem>

#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/tools/join_windows.h>

#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command join_windows_command() {
    const Option picture = {.name = "output",
                            .group = "Output",
                            .type = "FILE",
                            .help = "Picture to write, in the format of the windows",
                            .is_required = true,
                            .letter = 'o'};
    const Option size = {"resolution", "Input", "W,H",
                         "Size of the whole picture in pixels, also WxH (default: as recorded in the windows)"};
    return {"join-windows",
            "Join the windows of one picture",
            join_windows_footer,
            {{"PART",
              "Pictures written by render --window: .png, .exr or .hdr; FILE@X,Y gives the top left pixel of one that "
              "does not record it"}},
            apps::joined({{picture, size}, apps::without(apps::common_options(), {"config", "allow-outside"})})};
}

/// "FILE", or "FILE@X,Y"; files whose names end so are taken as they are.
WindowPart part_of(const std::string& word) {
    const std::size_t at = word.rfind('@');
    std::error_code ignored;
    if (at == std::string::npos || std::filesystem::exists(word, ignored)) return {word};
    WindowPart part{word.substr(0, at)};
    const char* const end = word.data() + word.size();
    const auto x = std::from_chars(word.data() + at + 1, end, part.x);
    if (x.ec != std::errc() || x.ptr == end || *x.ptr != ',') return {word};
    const auto y = std::from_chars(x.ptr + 1, end, part.y);
    return y.ec != std::errc() || y.ptr != end || part.x < 0 || part.y < 0 ? WindowPart{word} : part;
}

JoinRequest join_request(const Run& run) {
    JoinRequest request{.output = run.picture.output};
    for (const std::string& word : run.inputs) request.parts.push_back(part_of(word));
    if (!run.given.has("resolution")) return request;
    const std::vector<int> size = values::integers("resolution", run.given.word("resolution"), 2);
    request.width = size[0], request.height = size[1];
    if (request.width < 1 || request.height < 1)
        throw values::wrong("resolution", "must be 1 to 65536 pixels per side");
    return request;
}

int run_join_windows(const Run& run) {
    const JoinRequest request = join_request(run);
    JoinRow row{.result = {.output = request.output}};
    const int code = run_file(run, request.output, row, [&](Context& c) { row.result = join_windows(request, c); });
    const JoinResult& whole = row.result;
    if (code == 0)
        print_note(whole.output + ": " + std::to_string(whole.width) + " x " + std::to_string(whole.height) +
                       " pixels of " + std::to_string(whole.parts) + " windows",
                   run.loudness);
    if (run.is_json) print_data(to_json(std::span(&row, 1)));
    return code;
}

}  // namespace

const Verb join_windows_verb = {join_windows_command, run_join_windows};

}  // namespace rakelight::cli
