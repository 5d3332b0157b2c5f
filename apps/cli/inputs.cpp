// SPDX-License-Identifier: Apache-2.0
#include "inputs.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <rakelight/base/error.h>
#include <rakelight/io/movie.h>
#include <rakelight/tools/compare.h>

namespace rakelight::cli {
namespace {

namespace fs = std::filesystem;

template <class Iterator>
std::vector<std::string> models_in(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    Iterator at(folder, error), end;
    for (; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        const fs::path& path = at->path();
        const bool is_hidden = path.filename().string().starts_with('.');
        if constexpr (std::is_same_v<Iterator, fs::recursive_directory_iterator>)
            if (is_hidden) at.disable_recursion_pending();
        if (!is_hidden && is_scene(path.string()) && at->is_regular_file(ignored)) paths.push_back(path.string());
    }
    if (error) throw Error(ErrorCode::not_found, "cannot be read: " + error.message()).with_file(folder);
    std::ranges::sort(paths);
    return paths;
}

/// "." where nothing is left.
std::string or_here(const fs::path& path) { return path.empty() ? "." : path.string(); }

}  // namespace

bool is_folder(const std::string& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

bool means_folder(const std::string& path) {
    return path.ends_with('/') || (is_folder(path) && !has_picture_ending(path) && !is_movie(path) && !is_scene(path));
}

std::vector<Input> expanded(std::span<const std::string> words, bool is_recursive) {
    std::vector<Input> inputs;
    for (const std::string& word : words) {
        if (!is_folder(word)) {
            const bool is_file = word != "-" && !word.starts_with("builtin:");
            inputs.push_back({word, {is_file ? or_here(fs::path(word).parent_path()) : ".", "."}});
            continue;
        }
        const std::vector<std::string> paths =
            is_recursive ? models_in<fs::recursive_directory_iterator>(word) : models_in<fs::directory_iterator>(word);
        if (paths.empty())
            throw Error(ErrorCode::not_found, "the folder contains no model", {},
                        is_recursive ? "" : "--recursive looks into its subfolders too")
                .with_file(word);
        for (const std::string& path : paths) {
            const std::string below = or_here(fs::path(path).parent_path().lexically_relative(fs::path(word) / ""));
            inputs.push_back({path, {below, below}});
        }
    }
    return inputs;
}

MemoryFile standard_input(const std::string& format, std::uint64_t most) {
    if (isatty(STDIN_FILENO))
        throw Error(ErrorCode::usage, "standard input (-) is a terminal", {}, "pipe a model into it, or name a file");
    MemoryFile file{"standard input" + (format.empty() ? "" : "." + format), {}};
    std::vector<std::byte> bytes;
    constexpr std::size_t step = 1 << 20;
    for (;;) {
        const std::size_t had = bytes.size();
        bytes.resize(had + step);
        const ssize_t got = read(STDIN_FILENO, bytes.data() + had, step);
        bytes.resize(had + std::size_t(std::max<ssize_t>(got, 0)));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            throw Error(ErrorCode::not_found, std::string("cannot be read: ") + std::strerror(errno))
                .with_file(file.name);
        if (most != 0 && bytes.size() > most)
            throw Error(ErrorCode::bad_file, "more than the " + std::to_string(most) + " bytes of --max-memory")
                .with_file(file.name);
        if (got == 0) break;
    }
    file.bytes = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
    return file;
}

}  // namespace rakelight::cli
