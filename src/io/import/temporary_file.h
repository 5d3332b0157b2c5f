// SPDX-License-Identifier: Apache-2.0
// Bytes in memory as a file, for those who can read nothing else.
#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace rakelight::io {

/// A file in a folder of its own, in the system's folder for temporary files; both go with this.
class TemporaryFile {
public:
    /// @param name  of the file @throws Error failed: it cannot be written
    TemporaryFile(const std::string& name, std::span<const std::byte> bytes);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string folder_, path_;
};

}  // namespace rakelight::io
