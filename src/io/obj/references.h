// SPDX-License-Identifier: Apache-2.0
// Finds the files that a model names: as written, else ignoring case, else by the bare file name in the model's own
// folder (exporters write paths of the machine they ran on).
#pragma once
#include <map>
#include <optional>
#include <string>

namespace rakelight::io::obj {

struct FoundFile {
    std::string path;
    bool is_guessed = false;  ///< not as written
};

class ReferenceFinder {
public:
    ReferenceFinder(std::string model_path, bool allow_outside)
        : model_path_(std::move(model_path)), allow_outside_(allow_outside) {}

    /// @param reference  as written; relative to `folder`
    /// @param folder     relative to the model's folder ("" or "materials"); the model's folder itself is tried after
    /// it
    /// @return nothing when there is no such regular file inside the model's folder tree; never throws for that. After
    /// 2000
    ///         searches in vain no more are made: each costs several looks at the disk, and a file may hold millions
    std::optional<FoundFile> find(const std::string& reference, const std::string& folder = {});
    /// Folder of a found file, as seen from the model's folder.
    std::string folder_of(const std::string& path) const;
    /// Last component, for messages.
    static std::string bare_name(const std::string& reference);

private:
    std::optional<FoundFile> search(const std::string& reference, const std::string& folder);
    std::optional<std::string> exact(const std::string& reference) const;
    std::optional<std::string> other_case(const std::string& reference);
    const std::map<std::string, std::string>& listing(const std::string& folder);
    std::string model_path_;
    bool allow_outside_;
    int searches_in_vain_ = 0;
    std::map<std::string, std::map<std::string, std::string>> listings_;  ///< folder -> lower case -> name on disk
};

}  // namespace rakelight::io::obj
