// SPDX-License-Identifier: Apache-2.0
// The files that models are made of, looked at now and then: whether one has changed and then been left alone.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rakelight::apps {

class WatchedFiles {
public:
    using Time = std::filesystem::file_time_type;
    static constexpr std::size_t usual_most = 1000, at_once = 100;

    /// @param most  that are watched: each costs a look at the disk
    explicit WatchedFiles(std::size_t most = usual_most) : most_(most) {}

    /// Before a model is read, maybe again: what changes from now on is news. @param file  its own; empty: none
    void begin(const std::string& file);
    /// When it was read. @param files  those that it is made of, beside its own
    void take(const std::vector<std::string>& files);
    /// More of them behind begin(), as they are now; those that are known stay. What was written after `began`, when reading began, has changed.
    void add(const std::vector<std::string>& files, std::optional<Time> began = {});
    /// To be called now and then; checks `at_once` of them. True once one has changed and stayed the same from one
    /// look to the next. What is missing may be on its way: editors write a new file instead of the old one.
    bool has_changed();
    /// Waits until has_changed(); all is known then as it was last seen. @return one that has changed
    std::string wait();
    std::size_t count() const { return files_.size(); }

private:
    struct File {
        std::string path;
        Time read{}, seen{};
    };
    std::size_t most_;
    std::vector<File> files_;  ///< the model's own is the first
    Time began_{};
    std::size_t next_ = 0;
};

}  // namespace rakelight::apps
