// SPDX-License-Identifier: Apache-2.0
// What reading and writing of files share: a descriptor that closes itself, and the system's words for errno.
#pragma once
#include <unistd.h>

#include <string>
#include <system_error>

namespace rakelight::io {

struct Descriptor {
    int fd = -1;
    explicit Descriptor(int opened) : fd(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

/// strerror is not thread-safe; this is.
inline std::string system_message(int code) { return std::generic_category().message(code); }

}  // namespace rakelight::io
