// SPDX-License-Identifier: Apache-2.0
// The files that a model is made of, looked at now and then: whether one has changed and then been left alone.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rakelight::viewer {

class WatchedFiles {
public:
    static constexpr std::size_t most = 1000;  ///< that are watched: each costs a look at the disk
    static constexpr std::size_t at_once = 100;

    /// Before a model is read, maybe again: what changes from now on is news. @param file  its own; empty: none
    void begin(const std::string& file);
    /// When it was read. @param files  those that it is made of, beside its own
    void take(const std::vector<std::string>& files);
    /// More of them, as they are now; those that are known stay.
    void add(const std::vector<std::string>& files);
    /// To be called now and then; looks at `at_once` of them. True once one has changed and stayed the same from one look
    /// to the next. What is missing may be on its way: editors write a new file in place of the old one.
    bool has_changed();

private:
    using Time = std::filesystem::file_time_type;
    struct File {
        std::string path;
        Time read{}, seen{};
    };
    std::vector<File> files_;  ///< the model's own is the first
    Time began_{};
    std::size_t next_ = 0;
};

}  // namespace rakelight::viewer
