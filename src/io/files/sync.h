// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace rakelight::io {

/// When a written file reaches the disk: before it is renamed, or later by the caller (sync_file(), sync_folder()).
/// The latter is for many files in a folder that is not renamed yet: a sync of the folder for each of them costs 10
/// times as much.
enum class Sync { now, later };

}  // namespace rakelight::io
