// SPDX-License-Identifier: MPL-2.0
#include "core/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

namespace porefines {
namespace {

constexpr double redraw_interval = 0.1;  // [s]
constexpr double line_interval = 3;      // [s]
constexpr int bar_width = 30;
constexpr int tenths = 10;

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::string name)
    : Progress(std::move(name), std::cerr, isatty(STDERR_FILENO) == 1, steady_seconds) {}

Progress::Progress(std::string name, std::ostream& out, bool terminal, Clock now)
    : name_(std::move(name)),
      out_(out),
      terminal_(terminal),
      now_(std::move(now)),
      started_(now_()),
      shown_at_(started_) {}

Progress::~Progress() {
  if (line_open_) {
    out_ << std::endl;
  }
}

void Progress::start_from(double fraction) {
  from_ = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0;
  shown_tenths_ = static_cast<int>(tenths * from_);
}

void Progress::update(double fraction) {
  fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0;
  const double now = now_();
  const double elapsed = now - started_;
  const bool finished = fraction >= 1;
  const std::string left =
      finished ? fmt::format("{} in all", format_duration(elapsed))
      : fraction > from_
          ? fmt::format("{} left", format_duration(elapsed * (1 - fraction) / (fraction - from_)))
          : "time left unknown";
  if (terminal_) {
    if (finished || !line_open_ || now - shown_at_ >= redraw_interval) {
      shown_at_ = now;
      draw_bar(fraction, left);
    }
    return;
  }
  const int done = static_cast<int>(tenths * fraction);
  if (done > shown_tenths_ && (finished || now - shown_at_ >= line_interval)) {
    shown_tenths_ = done;
    shown_at_ = now;
    out_ << fmt::format("{}: {:.0f} %, {}", name_, 100 * fraction, left) << std::endl;
  }
}

void Progress::draw_bar(double fraction, const std::string& left) {
  const int full = static_cast<int>(bar_width * fraction);
  // "\r" returns to the start of the line, "\033[K" clears the rest of the previous drawing.
  out_ << fmt::format("\r{} [{:#<{}}{:.<{}}] {:3.0f} %, {}\033[K", name_, "", full, "",
                      bar_width - full, 100 * fraction, left)
       << std::flush;
  line_open_ = true;
}

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds)) {
    return "unknown";
  }
  constexpr long long minute = 60;
  constexpr long long hour = 60 * minute;
  constexpr long long day = 24 * hour;
  constexpr double longest = 1e12;
  const auto whole = std::llround(std::clamp(seconds, 0.0, longest));
  if (whole >= day) {
    return fmt::format("{} d {:02} h", whole / day, whole % day / hour);
  }
  if (whole >= hour) {
    return fmt::format("{} h {:02} min", whole / hour, whole % hour / minute);
  }
  if (whole >= minute) {
    return fmt::format("{} min {:02} s", whole / minute, whole % minute);
  }
  return fmt::format("{} s", whole);
}

}  // namespace porefines
