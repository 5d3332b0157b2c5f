// SPDX-License-Identifier: Apache-2.0
// Waiting for files to change.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rakelight::cli {

/// The files that pictures are made of.
class WatchedInputs {
public:
    /// More files; those that are known keep what they were. What was written after `began`, when reading began, has changed.
    void add(const std::vector<std::string>& files, std::filesystem::file_time_type began);
    /// Returns when one has changed, or come, and then been left alone for a moment. It polls.
    void wait();

private:
    using Time = std::filesystem::file_time_type;
    std::map<std::string, Time> known_;
};

}  // namespace rakelight::cli
