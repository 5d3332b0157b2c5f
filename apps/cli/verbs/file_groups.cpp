// SPDX-License-Identifier: Apache-2.0
#include "file_groups.h"

#include <algorithm>
#include <numeric>

#include "../../common/interrupt.h"
#include "../console.h"

namespace rakelight::cli {
namespace {

/// @param first  [files] the first one of the same group
std::vector<FileGroup> grouped(std::span<const std::string> files, std::span<const std::uint32_t> first) {
    std::vector<FileGroup> groups(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        FileGroup& group = groups[first[i]];
        group.members.push_back(i);
        group.title += (group.title.empty() ? "" : " + ") + files[i];
    }
    std::erase_if(groups, [](const FileGroup& group) { return group.members.empty(); });
    return groups;
}

}  // namespace

std::vector<FileGroup> each_alone(std::span<const std::string> files) {
    std::vector<std::uint32_t> first(files.size());
    std::iota(first.begin(), first.end(), 0u);
    return grouped(files, first);
}

std::vector<FileGroup> all_as_one(std::span<const std::string> files) {
    return grouped(files, std::vector<std::uint32_t>(files.size(), 0));
}

std::vector<FileGroup> groups_by_borders(const Run& run, std::span<const std::string> files,
                                         const SmoothFileOptions& options) {
    if (files.size() < 2) return each_alone(files);
    Context context({.threads = run.threads, .max_memory = run.max_memory});
    const CancelOnInterrupt guard(context, cancelled_line(files.front()));
    try {
        const FilesCutApart cut = files_cut_apart(files, options, context);
        std::string unclear;
        for (const std::uint32_t i : cut.unclear) unclear += (unclear.empty() ? "" : ", ") + files[i];
        if (!unclear.empty())
            print_message(
                unclear +
                    ": open borders fit together in several ways, so they are not joined (--as-one joins all files)",
                run.loudness);
        return grouped(files, cut.first);
    } catch (const Error& error) {
        context.throw_if_cancelled();
        print_message("open borders of the files are not compared: " + std::string(error.what()), run.loudness);
        return each_alone(files);
    }
}

}  // namespace rakelight::cli
