// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace porefines {

/// How far a long loop is, and how long it will still take.
///
/// On a terminal: one line that is redrawn, `solve [######....] 60 %, 12 s left`. Elsewhere (a log,
/// a batch job) plain lines, each time another tenth is done but at most one every few seconds.
/// The time left is  elapsed (1 - f) / (f - f0)  with f the fraction done, f0 of it before this began.
/// Only rank 0 constructs one.
class Progress {
 public:
  using Clock = std::function<double()>;  ///< [s] from any origin

  /// On stderr, as a bar when that is a terminal.
  explicit Progress(std::string name);
  Progress(std::string name, std::ostream& out, bool terminal, Clock now);
  /// Ends the redrawn line, so that what follows starts on its own.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What a former call has done of it, 0..1: it took no time of this one.
  void start_from(double fraction);
  /// @param fraction  0..1, done so far; clamped. Cheap enough for every step.
  void update(double fraction);

 private:
  void draw_bar(double fraction, const std::string& left);

  std::string name_;
  std::ostream& out_;
  bool terminal_;
  Clock now_;
  double started_;
  double from_ = 0;
  double shown_at_;
  int shown_tenths_ = 0;
  bool line_open_ = false;
};

/// "12 s", "3 min 20 s", "2 h 05 min", "4 d 03 h".
[[nodiscard]] std::string format_duration(double seconds);

}  // namespace porefines
