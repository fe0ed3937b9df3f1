// SPDX-License-Identifier: MPL-2.0
#include "io/series.hpp"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"
#include "io/replace_file.hpp"

namespace porefines::io {
namespace {

std::string header_of(const std::vector<std::string>& names) {
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string reason() {
  return std::generic_category().message(errno);
}

/// The header and the complete rows up to `time`.
std::string rows_until(const std::string& content, Real time) {
  std::string kept;
  std::string_view rest = content;
  for (auto end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const std::string row(rest.substr(0, end + 1));
    rest.remove_prefix(end + 1);
    if (!kept.empty() && !(std::strtod(row.c_str(), nullptr) <= time)) {
      break;
    }
    kept += row;
  }
  return kept;
}

}  // namespace

SeriesWriter::SeriesWriter(std::string path, const std::vector<std::string>& names)
    : SeriesWriter(std::move(path), names.size(), header_of(names)) {}

SeriesWriter::SeriesWriter(std::string path, std::size_t columns, const std::string& content)
    : path_(std::move(path)), columns_(columns) {
  replace_file(path_, content);
  file_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file_ < 0) {
    throw RunError(fmt::format("{}: cannot open for writing: {}", path_, reason()));
  }
}

SeriesWriter SeriesWriter::resume(std::string path, const std::vector<std::string>& names,
                                  Real time) {
  const std::string header = header_of(names);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return {std::move(path), names};
  }
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!content.starts_with(header)) {
    throw RunError(fmt::format(
        "{}: its columns are not those of this run, cannot continue it\n  found: {}\n  wanted: {}",
        path, content.substr(0, content.find('\n')), header.substr(0, header.size() - 1)));
  }
  return {std::move(path), names.size(), rows_until(content, time)};
}

void SeriesWriter::append(std::span<const Real> values) {
  if (values.size() != columns_) {
    throw RunError(
        fmt::format("{}: a row of {} values for {} columns", path_, values.size(), columns_));
  }
  append_lines(fmt::format("{}\n", fmt::join(values, ",")));
}

void SeriesWriter::append_lines(std::string_view lines) {
  const auto written = ::write(file_, lines.data(), lines.size());
  if (written != static_cast<ssize_t>(lines.size())) {
    throw RunError(fmt::format("{}: cannot append a row: {}", path_,
                               written < 0 ? reason() : std::string("the disk is full")));
  }
}

SeriesWriter::SeriesWriter(SeriesWriter&& other) noexcept
    : path_(std::move(other.path_)),
      columns_(other.columns_),
      file_(std::exchange(other.file_, -1)) {}

SeriesWriter::~SeriesWriter() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

}  // namespace porefines::io
