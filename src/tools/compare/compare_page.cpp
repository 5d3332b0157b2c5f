// SPDX-License-Identifier: Apache-2.0
// One file, no script from elsewhere. Without scripts the slider's middle is shown.
#include <rakelight_internal/tools/compare_page.h>

#include <cstring>

#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "io/files/output_file.h"
#include "io/pictures/image_io.h"
#include "render/check_request.h"
#include "tools/compare/compare.h"
#include "tools/compare/compare_numbers.h"
#include "tools/html.h"

namespace rakelight {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem; background: Canvas; color: CanvasText; }
h1 { font-size: 1.5rem; overflow-wrap: anywhere; } h2 { font-size: 1.2rem; margin-top: 2.5rem; overflow-wrap: anywhere; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; } .scroll { overflow: auto; max-height: 90vh; }
th, td { text-align: right; font-weight: normal; padding: .1rem 1.5rem .1rem 0; white-space: nowrap; } th { color: GrayText; font-size: .85rem; }
.tools { display: flex; flex-wrap: wrap; gap: .3rem; margin: .6rem 0; } .tools span { width: 1rem; }
button { font: inherit; font-size: .9rem; padding: .1rem .7rem; border: 1px solid GrayText; border-radius: .3rem; background: none; color: inherit; cursor: pointer; }
button[aria-pressed=true] { background: Highlight; color: HighlightText; }
.stage { --at: 50%; position: relative; width: max-content; max-width: 100%; } .stage img { display: block; width: 100%; }
.stage img ~ img { position: absolute; inset: 0; visibility: hidden; } .stage.large { max-width: none; } .stage.large img { image-rendering: pixelated; }
.stage[data-show=wipe] .b { visibility: visible; clip-path: inset(0 0 0 var(--at)); }
.stage[data-show=b] .b, .stage[data-show=flip] .flip, .stage[data-show=absolute] .absolute { visibility: visible; }
.stage i { position: absolute; top: 0; bottom: 0; left: var(--at); width: 2px; margin-left: -1px; background: #fff; box-shadow: 0 0 0 1px #000; pointer-events: none; }
.stage input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize; }
.stage input::-webkit-slider-thumb { width: 1px; } .stage input::-moz-range-thumb { width: 1px; border: 0; }
.stage:not([data-show=wipe]) :is(i, input) { display: none; }
p { max-width: 60rem; } section p { color: GrayText; font-size: .9rem; }
)";

/// Every button says what it shows; "alternate" shows A and B in turn, as FLIP is about.
constexpr const char* script = R"(
for (const section of document.querySelectorAll('section')) {
  const stage = section.querySelector('.stage'), first = stage.querySelector('img');
  let timer = 0;
  const press = (group, button) => { for (const b of section.querySelectorAll('button[' + group + ']')) b.setAttribute('aria-pressed', b === button); };
  for (const b of section.querySelectorAll('button[data-show]')) b.onclick = () => {
    clearInterval(timer);
    stage.dataset.show = b.dataset.show === 'alternate' ? 'a' : b.dataset.show;
    if (b.dataset.show === 'alternate') timer = setInterval(() => { stage.dataset.show = stage.dataset.show === 'a' ? 'b' : 'a'; }, 500);
    press('data-show', b);
  };
  for (const b of section.querySelectorAll('button[data-zoom]')) b.onclick = () => {
    const zoom = Number(b.dataset.zoom);
    stage.classList.toggle('large', zoom > 0);
    stage.style.width = zoom > 0 ? first.naturalWidth * zoom + 'px' : '';
    const view = stage.parentElement;
    view.scrollTo((view.scrollWidth - view.clientWidth) / 2, (view.scrollHeight - view.clientHeight) / 2);
    press('data-zoom', b);
  };
  const slider = stage.querySelector('input');
  slider.oninput = () => stage.style.setProperty('--at', slider.value + '%');
}
)";

Pixels displayed(const DisplayPicture& picture) {
    Pixels out{picture.width, picture.height, 3, Component::u8, false, {}};
    out.bytes.resize(out.row_bytes() * std::size_t(out.height));
    std::byte* to = out.bytes.data();
    for (const std::uint32_t code : picture.codes)
        for (int shift = 0; shift < 24; shift += 8) *to++ = std::byte(code >> shift & 255);
    return out;
}

std::string image_html(const char* name, const std::string& alt, const Pixels& pixels) {
    return format_text("<img class=\"{}\" alt=\"{}\" width=\"{}\" src=\"{}\">\n", name, html_text(alt), pixels.width,
                       png_uri(pixels));
}

std::string numbers_html(const PictureComparison& c) {
    std::string head, body;
    for (const auto& [name, value] : numbers_of(c)) head += "<th>" + name + "</th>", body += "<td>" + value + "</td>";
    return "<div class=\"scroll\"><table>\n<tr>" + head + "</tr>\n<tr>" + body + "</tr>\n</table></div>\n";
}

std::string button(const char* group, const std::string& value, const std::string& text, bool is_pressed) {
    return std::string("<button data-") + group + "=\"" + value + "\" aria-pressed=\"" +
           (is_pressed ? "true" : "false") + "\">" + html_text(text) + "</button>\n";
}

std::string buttons_html(const PageTitles& titles, double gain) {
    return "<div class=\"tools\">\n" + button("show", "wipe", "Wipe", true) +
           button("show", "a", "A: " + titles.a, false) + button("show", "b", "B: " + titles.b, false) +
           button("show", "alternate", "Alternate", false) + button("show", "flip", "FLIP", false) +
           button("show", "absolute", "|A - B| x " + short_digits(gain), false) + "<span></span>\n" +
           button("zoom", "0", "Fit", true) + button("zoom", "1", "1:1", false) + button("zoom", "4", "4:1", false) +
           "</div>\n";
}

/// What the numbers and colors mean.
std::string legend(const CompareOptions& options, double gain) {
    return "<p>Max error, RMSE and PSNR are of components as 0 to 1; differing pixels have a component that is off by "
           "more than " +
           short_digits(options.tolerance) + ". SSIM (1: equal) and FLIP (0: equal, at " +
           short_digits(options.pixels_per_degree) +
           " pixels per degree) are of the colors as displayed. The FLIP picture goes from dark blue, 0, over green "
           "and yellow to "
           "white, 1; the difference |A - B| is shown " +
           short_digits(gain) + " times as strong as it is.</p>\n";
}

}  // namespace

void ComparisonPage::add(const PageTitles& titles, const ComparedPictures& pictures, const CompareOptions& options,
                         double gain) {
    const ComparedPictures::State& s = pictures.state();
    if (titles_.empty()) legend_ = legend(options, gain);
    titles_.push_back(titles.title);
    sections_ += "<section>\n<h2>" + html_text(titles.title) + "</h2>\n" + numbers_html(s.comparison) +
                 buttons_html(titles, gain) + "<div class=\"scroll\"><div class=\"stage\" data-show=\"wipe\">\n" +
                 image_html("a", titles.a, displayed(s.display_a)) + image_html("b", titles.b, displayed(s.display_b)) +
                 image_html("flip", "FLIP", pictures.difference(DifferenceKind::flip, gain)) +
                 image_html("absolute", "|A - B|", pictures.difference(DifferenceKind::absolute, gain)) +
                 "<i></i><input type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" "
                 "aria-label=\"where A ends and B begins\">\n</div></div>\n<p>Left of the line A, " +
                 html_text(titles.a) + "; right of it B, " + html_text(titles.b) + ".</p>\n</section>\n";
}

void ComparisonPage::save(const std::string& path) const {
    const std::string title = titles_.size() == 1 ? titles_[0] : std::to_string(titles_.size()) + " pairs of pictures";
    const std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>" +
        html_text(title) + ": compared</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
        "Pictures compared</h1>\n" + legend_ + "<main>\n" + sections_ + "</main>\n<script>" + script +
        "</script>\n</body>\n</html>\n";
    io::OutputFile file(path);
    file.write(std::as_bytes(std::span(page)));
    file.commit();
}

bool is_page(const std::string& path) {
    const std::string ending = file_ending(path);
    return ending == "html" || ending == "htm";
}

void check_comparison_output(const std::string& path) {
    try {
        if (!is_page(path)) (void)io::component_for(path);
        check_output_place(path);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace rakelight
