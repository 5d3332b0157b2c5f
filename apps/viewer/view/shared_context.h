// SPDX-License-Identifier: Apache-2.0
// An OpenGL context for another thread than the window's.
#pragma once

namespace rakelight::viewer {

/// Shares textures and fences with the window's context. Made and ended in the window's thread, where it must be current in no
/// thread any more.
class SharedContext {
public:
    SharedContext() = default;
    virtual ~SharedContext() = default;
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

    virtual void make_current() = 0;  ///< in the thread that calls @throws Error failed
    virtual void release() = 0;       ///< in the same thread
};

}  // namespace rakelight::viewer
