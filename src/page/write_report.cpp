// SPDX-License-Identifier: MPL-2.0
#include "page/write_report.hpp"

#include <string_view>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "page/island.hpp"

// The page that web/build.mjs made, put in by src/page/bundle.S.
extern "C" {
extern const char porefines_page_begin[];
extern const char porefines_page_end[];
}

namespace porefines::page {
namespace {

constexpr std::string_view place_of_title = "PF_TITLE";
constexpr std::string_view place_of_data = "PF_DATA";

/// "</script>" in a text of the run must not end the island.
std::string without_tags(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  }
  return out;
}

std::string for_html(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return out;
}

}  // namespace

std::string whole_page(const std::string& title, const std::string& island) {
  const std::string_view page(porefines_page_begin, porefines_page_end);
  const std::size_t head = page.find(place_of_title);
  const std::size_t body = page.find(place_of_data, head);
  if (body == std::string_view::npos) {
    throw RunError("the page inside the program is damaged: build porefines again");
  }
  std::string out(page.substr(0, head));
  out += for_html(title);
  out += page.substr(head + place_of_title.size(), body - head - place_of_title.size());
  out += without_tags(island);
  out += page.substr(body + place_of_data.size());
  return out;
}

std::string write_report(const std::string& folder) {
  const std::string island = run_island(folder);
  const std::string path = folder + "/report.html";
  write_file(path, whole_page("porefines: " + folder, island));
  return path;
}

}  // namespace porefines::page
