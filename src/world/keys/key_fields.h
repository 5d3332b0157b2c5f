// SPDX-License-Identifier: Apache-2.0
// Macros and helpers for the tables of [render] keys in keys_*.cpp.
#pragma once
#include <rakelight/world/render_keys.h>
#include <rakelight/world/request.h>
#include <rakelight/world/values.h>

namespace rakelight::keys {

using Words = std::span<const std::string>;
using Written = std::vector<std::string>;
using Kind = RenderKey::Kind;

/// The default of every field.
const PictureRequest& defaults();
/// The defaults under the preset of a request; only differences are written.
const PictureRequest& defaults_beside(const PictureRequest& of);

/// The shortest text that parses to the same number.
std::string text_of(double number);
/// The same for a float parsed from a double.
std::string text_of_float(float number);
/// [deg] The shortest text whose value in radians is the same number.
std::string degrees_of(double radians);
/// The same for a float parsed from a double.
std::string degrees_of_float(float radians);
/// "1,2,3"
std::string text_of(dvec3 v);
/// A display color: "#rrggbb" if exact, else "r,g,b".
std::string color_of(vec3 linear);
/// "photometric-spot"
const char* name_of(const Light& light);
/// "point:0,2,3:color=1,0.9,0.8": the format of values::light(); and for fog.
std::string text_of(const Light& light);
std::string text_of(const Fog& fog);

/// The word of a value in a table.
template <class T, std::size_t n>
Written name_in(const Word<T> (&words)[n], const T& value) {
    for (const Word<T>& w : words)
        if (w.value == value) return {w.name};
    return {};
}

inline Written on_or_off(bool value) { return {value ? "on" : "off"}; }

// One key and its field. `field` is an expression of the request r, as in r.settings.samples.
#define RL_WRITE(field, writing)                                                         \
    [](const PictureRequest& of) -> Written {                                            \
        const auto is_of = [](const PictureRequest& r) -> const auto& { return field; }; \
        if (is_of(of) == is_of(defaults_beside(of))) return {};                          \
        [[maybe_unused]] const PictureRequest& r = of;                                   \
        return Written writing;                                                          \
    }
#define RL_KEY(name, kind, field, reading, writing)                                                       \
    {                                                                                                     \
        name, Kind::kind, [](PictureRequest& r, Words w) { (field) = reading; }, RL_WRITE(field, writing) \
    }
/// A key with a table of words.
#define RL_WORD_KEY(name, field, words) \
    RL_KEY(name, value, field, values::word(name, w[0], words), (name_in(words, field)))
#define RL_SWITCH_KEY(name, field) RL_KEY(name, on_off, field, values::on_off(name, w[0]), (on_or_off(field)))
#define RL_FLOAT_KEY(name, field, low, high) \
    RL_KEY(name, value, field, float(values::number(name, w[0], low, high)), {text_of_float(field)})
#define RL_NUMBER_KEY(name, field, low, high) \
    RL_KEY(name, value, field, values::number(name, w[0], low, high), {text_of(field)})
#define RL_INTEGER_KEY(name, field, low, high) \
    RL_KEY(name, value, field, values::integer(name, w[0], low, high), {std::to_string(field)})

/// The tables of keys_*.cpp.
using KeyTable = std::span<const RenderKey>;
extern const KeyTable picture_keys;
extern const KeyTable surface_keys;
extern const KeyTable normal_keys;
extern const KeyTable view_keys;
extern const KeyTable scene_keys;
extern const KeyTable coloring_keys;
extern const KeyTable motion_keys;

}  // namespace rakelight::keys
