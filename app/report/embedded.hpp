#pragma once
// Files of the source tree that the page is made of, put into the executable by the build (cmake/embed.cmake).

#include <string_view>

namespace steadyslide::app::embedded {

extern const std::string_view report_css;
extern const std::string_view report_print_css;
extern const std::string_view report_js;
extern const std::string_view references_md;
extern const std::string_view mutants_csv;

}  // namespace steadyslide::app::embedded
