// SPDX-License-Identifier: MPL-2.0
// The output folder of a study: one folder per member, and a lock.
#pragma once

#include <string>

#include "study/study.hpp"

namespace porefines::study {

/// DIR/members/NAME
[[nodiscard]] std::string member_folder(const std::string& output, const Member& member);

/// Keeps other studies out of a folder, and waits for the runs of one that was killed.
///
/// The lock is held by the open file, which the members inherit: it is free when the study and all its
/// runs have ended.
class FolderLock {
 public:
  /// @throws InputError  another study is at work there
  explicit FolderLock(const std::string& output);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

/// Why a member failed and how often; stays in its folder beside what it has written.
struct Failure {
  int attempts = 0;
  int exit_code = 0;
  std::string reason;
};
[[nodiscard]] Failure read_failure(const std::string& folder);
void write_failure(const std::string& folder, const Failure& failure);

/// A member whose checkpoint a new run can go on from.
[[nodiscard]] bool is_resumable(const std::string& folder);

}  // namespace porefines::study
