// SPDX-License-Identifier: Apache-2.0
// The import helper as a child process.
#pragma once
#include <string>

#include <rakelight/base/context.h>

#include "base/child_process.h"
#include "io/import/stream_reader.h"

namespace rakelight::io {

/// `asked`, else RAKELIGHT_IMPORT, else `rakelight-import` beside the running program or this library, or where it is installed
/// as counted from either.
/// @param asked  Context::import_helper()
/// @throws Error failed with advice when there is none.
std::string find_import_helper(const std::string& asked);

struct HelperLimits {
    double seconds = 8;              ///< wall clock and processor time, > 0
    std::uint64_t memory_bytes = 0;  ///< address space
    bool allow_outside = false;
};

/// Starts the helper on `model`; read() returns its output. Destruction kills what still runs and leaves no zombie.
class HelperProcess final : public import_stream::Source {
public:
    HelperProcess(const std::string& helper, const std::string& model, const HelperLimits& limits, Context& context);
    /// @throws Error bad_file: crashed, out of time, ended too early; failed: cancelled.
    void read(std::span<std::byte> to) override;

private:
    [[noreturn]] void ended_early();
    Context& context_;
    HelperLimits limits_;
    ChildProcess child_;
};

}  // namespace rakelight::io
