#include "app/svg.hpp"

#include <algorithm>

namespace steadyslide::testing {
namespace {

bool is_reference(const std::string& xml, std::size_t at) {
  const std::size_t end = xml.find(';', at);
  return end != std::string::npos && end - at < 8 && xml.find_first_of(" <&", at + 1) > end;
}

}  // namespace

bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = xml.find('<', at)) != std::string::npos) {
    const bool comment = xml.compare(at, 4, "<!--") == 0;
    const std::size_t end = xml.find(comment ? "-->" : ">", at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (comment || tag.front() == '?' || tag.front() == '!' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \t\n"));
    if (name.front() != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  for (at = 0; (at = xml.find('&', at)) != std::string::npos; ++at) {
    if (!is_reference(xml, at)) return false;
  }
  return open.empty();
}

std::string shown_text(const std::string& svg) {
  std::string result;
  bool in_text = false;
  for (std::size_t at = 0; at < svg.size(); ++at) {
    if (svg[at] == '<') {
      const std::size_t end = std::min(svg.find('>', at), svg.size() - 1);
      const std::string tag = svg.substr(at + 1, end - at - 1);
      if (tag.rfind("text", 0) == 0) in_text = true;
      if (tag == "/text") {
        in_text = false;
        result += '\n';
      }
      at = end;
    } else if (in_text) {
      result += svg[at];
    }
  }
  return result;
}

std::vector<std::string> ids(const std::string& svg) {
  std::vector<std::string> result;
  for (std::size_t at = 0; (at = svg.find(" id=", at)) != std::string::npos; ++at) {
    const std::size_t begin = at + 5;
    result.push_back(svg.substr(begin, svg.find(svg[at + 4], begin) - begin));
  }
  return result;
}

}  // namespace steadyslide::testing
