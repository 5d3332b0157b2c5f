// SPDX-License-Identifier: Apache-2.0
// Embree 3, loaded when it is first asked for: the program starts without its 40 MB, and runs where it is not installed. The only
// module that names it is this engine.
#pragma once
#include <embree3/rtcore.h>

namespace rakelight::raytrace {

/// The functions that are used, by their names behind "rtc".
#define RL_EMBREE_FUNCTIONS(X)         \
    X(NewDevice)                       \
    X(ReleaseDevice)                   \
    X(GetDeviceError)                  \
    X(NewScene)                        \
    X(ReleaseScene)                    \
    X(AttachGeometry)                  \
    X(AttachGeometryByID)              \
    X(SetSceneFlags)                   \
    X(SetSceneProgressMonitorFunction) \
    X(CommitScene)                     \
    X(NewGeometry)                     \
    X(ReleaseGeometry)                 \
    X(SetSharedGeometryBuffer)         \
    X(CommitGeometry)                  \
    X(SetGeometryInstancedScene)       \
    X(SetGeometryTransform)            \
    X(SetGeometryUserPrimitiveCount)   \
    X(SetGeometryUserData)             \
    X(SetGeometryBoundsFunction)       \
    X(SetGeometryIntersectFunction)    \
    X(SetGeometryOccludedFunction)     \
    X(SetDeviceMemoryMonitorFunction)  \
    X(Intersect1)                      \
    X(Occluded1)

struct EmbreeLibrary {
#define RL_MEMBER(name) decltype(&::rtc##name) name;  // NOLINT(bugprone-macro-parentheses): a declaration
    RL_EMBREE_FUNCTIONS(RL_MEMBER)
#undef RL_MEMBER
};

/// @throws Error failed: it is not installed, or another version
const EmbreeLibrary& embree();

}  // namespace rakelight::raytrace
