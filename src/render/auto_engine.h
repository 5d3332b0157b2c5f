// SPDX-License-Identifier: Apache-2.0
// The engine `auto`: gl where there is a GPU that can draw what is asked for, soft otherwise.
#pragma once
#include <memory>

#include <rakelight/engine.h>

namespace rakelight {

/// Never fails for want of OpenGL: what the engine gl cannot do, or cannot do any more (a lost context, no memory on the GPU, a
/// driver that refuses a shader), soft does; the report says so.
std::unique_ptr<Engine> make_auto_engine();

}  // namespace rakelight
