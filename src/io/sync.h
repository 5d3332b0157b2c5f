// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace rakelight::io {

/// When a file that was written reaches the disk: before it is renamed; or later, by a caller that has many files in a
/// folder which has not got its name yet (sync_file(), sync_folder()): a sync of the folder for each of them costs 10
/// times as much.
enum class Sync { now, later };

}  // namespace rakelight::io
