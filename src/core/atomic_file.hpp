// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <string_view>

namespace porefines {

/// A file that appears under its name only when it is complete.
///
/// Writes to `path`.part and renames in commit(), so that a crash or a full disk leaves the old
/// file as it was. Without commit() the destructor deletes the part.
/// @throws RunError  from every function: "cannot write out/log.txt: No space left on device"
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  std::string path_;
  std::string part_;
  int descriptor_ = -1;
};

/// Writes a whole file at once, all or nothing.
/// @throws RunError  as AtomicFile
void write_file(const std::string& path, std::string_view content);

/// Creates a folder and its parents where they are missing.
/// @throws RunError  "cannot create the folder out: Permission denied"
void make_folder(const std::string& path);

}  // namespace porefines
