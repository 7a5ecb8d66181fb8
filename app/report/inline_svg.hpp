#pragma once
// An SVG file made part of a page.

#include <string>
#include <string_view>

namespace steadyslide::app {

/// The <svg> element alone. Several drawings share one page, so that every id and every reference to one begins with
/// `prefix`. The drawing's own title, which a browser would show as a hint, gives way to `title`. Scripts are left out.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title);

}  // namespace steadyslide::app
