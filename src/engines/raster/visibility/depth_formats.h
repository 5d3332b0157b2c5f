// SPDX-License-Identifier: Apache-2.0
// Numbers that a z-buffer keeps of a distance: whole numbers of 16, 24 and 32 bits, a float of the textbook's depth, and the float of
// the reversed depth that this engine draws with.
#pragma once
#include <rakelight/engines/engine.h>

namespace rakelight::raster {

/// The depth range of a view, distances along the view axis.
struct DepthRange {
    double z_near = 0.1, z_far = 1000;  ///< [m] far may be infinity in perspective
    bool orthographic = false;
};

/// Whether a method keeps depth numbers at all: z16, z24, z32, z_float, z_reversed.
bool has_depth(Visibility method);

/// 1 on the near plane: near / distance in perspective, 1 - standard_depth in parallel views. Affine on the screen.
double reversed_depth(double distance, const DepthRange& range);

/// The textbook's depth, 0 on the near plane to 1 on the far one, affine on the screen. In perspective
/// z' = far (z - near) / (z (far - near)).
double standard_depth(double distance, const DepthRange& range);
/// The same, of a reversed depth: in perspective far / (far - near) (1 - near / z).
double standard_of_reversed(double reversed, const DepthRange& range);

/// What a format keeps of a reversed depth (of standard_of_reversed(), clamped to 0..1, in all but z_reversed), less is nearer: whole
/// numbers 0 to 2^bits - 1, rounded; the float of the standard depth; minus the float of the reversed one.
double stored_depth(Visibility format, double reversed, const DepthRange& range);

/// [m] How far apart two surfaces at this distance must be to differ by one step of the stored number. It is one whole
/// number, or the last bit of a float, over the derivative of the depth. Rounding in the arithmetic is not included.
double depth_step(Visibility format, double distance, const DepthRange& range);

}  // namespace rakelight::raster
