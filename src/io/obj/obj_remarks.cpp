// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_remarks.h"

#include "base/format_text.h"

namespace rakelight::io::obj {
namespace {

struct Text {
    Issue issue;
    Remark remark;
    const char* message;
};

constexpr Text texts[] = {
    {Issue::lone_cr, Remark::warning, "lines end in CR alone (old Mac text)"},
    {Issue::nul_bytes, Remark::warning, "NUL bytes in the text were read as blanks"},
    {Issue::bad_number, Remark::warning, "a number cannot be read; it is treated as NaN"},
    {Issue::not_finite, Remark::warning, "a coordinate is not finite or too large for float; it is treated as NaN"},
    {Issue::missing_numbers, Remark::warning, "a vertex line has too few numbers; the missing ones are treated as NaN"},
    {Issue::weight, Remark::dropped, "the weight w of a vertex (rational curves) is left out"},
    {Issue::extra_numbers, Remark::warning, "a vertex line has too many numbers; the last ones are left out"},
    {Issue::bad_normal, Remark::warning, "a normal has zero length or is not finite; its corners have none"},
    {Issue::bad_texcoord, Remark::warning, "a texture coordinate is not finite; it is replaced by 0 0"},
    {Issue::bad_color, Remark::warning, "a vertex color is not finite; it is replaced by white"},
    {Issue::bytes_as_colors, Remark::guessed, "vertex colors over 1 were read as 0..255"},
    {Issue::face_syntax, Remark::warning, "a face with a corner that cannot be read was skipped"},
    {Issue::face_index, Remark::warning, "a face, line or point with a vertex index of 0 or out of range was skipped"},
    {Issue::face_short, Remark::warning, "a face with fewer than 3 corners was skipped"},
    {Issue::face_texcoord_index, Remark::warning,
     "a texture coordinate index is 0 or out of range; the corner has none"},
    {Issue::face_normal_index, Remark::warning, "a normal index is 0 or out of range; the corner has none"},
    {Issue::texcoords_missing, Remark::changed,
     "only a part of a mesh has texture coordinates; the rest is set to 0 0"},
    {Issue::normals_missing, Remark::changed,
     "only some faces of an object have normals; those without are put into a mesh of their own"},
    {Issue::polygon_crossed, Remark::guessed,
     "a polygon that crosses or touches itself was triangulated as well as possible"},
    {Issue::polygon_complex, Remark::guessed,
     "a polygon too complex to be triangulated in bounded time was triangulated partly as a fan"},
    {Issue::element_syntax, Remark::warning, "a line or point element that cannot be read was skipped"},
    {Issue::smoothing_syntax, Remark::warning, "a smoothing group that is not a number is treated as off"},
    {Issue::free_form, Remark::dropped, "free-form curves and surfaces are left out"},
    {Issue::display_attribute, Remark::note, "display and rendering attributes (lod, bevel, mg, ...) are left out"},
    {Issue::external_call, Remark::dropped, "commands and calls of other files (call, csh) are left out"},
    {Issue::unknown_keyword, Remark::dropped, "a line with an unknown keyword is left out"},
    {Issue::mtl_unknown, Remark::dropped, "a line with an unknown keyword is left out"},
    {Issue::mtl_outside, Remark::dropped, "a line before the first newmtl is left out"},
    {Issue::mtl_number, Remark::warning, "a number cannot be read or is not finite; the value keeps its default"},
    {Issue::mtl_spectral, Remark::dropped, "a spectral or XYZ color is left out"},
    {Issue::mtl_range, Remark::changed, "a value outside 0..1 was clamped"},
    {Issue::mtl_exponent, Remark::changed, "a specular exponent Ns below 1 was read as no highlight"},
    {Issue::mtl_redefined, Remark::warning, "a material is defined more than once; its first definition counts"},
    {Issue::mtl_option, Remark::dropped, "a texture option (-mm, -t, -imfchan, -cc) is left out"},
    {Issue::mtl_option_hint, Remark::note, "a texture filter option (-blendu, -blendv, -boost, -texres) is left out"},
    {Issue::mtl_empty_map, Remark::warning, "a texture line without a file name is left out"},
    {Issue::mtl_unsupported_map, Remark::dropped,
     "a texture of a kind that the material model does not have is left out"},
    {Issue::mtl_unsupported_value, Remark::note,
     "a value that the material model does not have (sharpness, Ps, ...) is left out"},
};
static_assert(std::size(texts) == std::size_t(Issue::count_));

}  // namespace

void Remarks::flush(Report& report) {
    for (const Text& text : texts) {
        Tally& t = tallies_[std::size_t(text.issue)];
        if (t.count == 0) continue;
        std::string message = text.message;
        if (t.count > 1) message += format_text(" ({} times)", t.count);
        std::string place = t.first_line ? "line " + std::to_string(t.first_line) : std::string();
        report.add(text.remark, file_, std::move(place), std::move(message));
        t = {};
    }
}

}  // namespace rakelight::io::obj
