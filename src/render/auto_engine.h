// SPDX-License-Identifier: Apache-2.0
// The engine `auto`: gl where there is a GPU that can draw what is requested, soft otherwise.
#pragma once
#include <memory>
#include <string>

#include <rakelight/engines/engine.h>

namespace rakelight {

/// Never fails because OpenGL does. Whatever the engine gl cannot do, or no longer (a lost context, no memory on the
/// GPU, a driver that refuses a shader), engine soft does, with a remark in the report.
std::unique_ptr<Engine> make_auto_engine();
/// The same with a given engine on the GPU. @param gpu  null: there is none. @param why  then the reason
std::unique_ptr<Engine> make_auto_engine(std::unique_ptr<Engine> gpu, std::string why);

}  // namespace rakelight
