// SPDX-License-Identifier: MPL-2.0
#include "core/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"

namespace porefines {

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), part_(path_ + ".part") {
  constexpr int readable_by_all = 0666;  // less what the user's umask takes away
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_by_all);
  if (descriptor_ < 0) {
    fail(errno);
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(part_.c_str());
  }
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      fail(errno);
    }
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
}

void AtomicFile::commit() {
  // Some file systems report a full disk only when the data must really go there.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
    fail(errno);
  }
  if (::close(std::exchange(descriptor_, -1)) != 0 ||
      std::rename(part_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    ::unlink(part_.c_str());
    fail(error);
  }
}

void AtomicFile::fail(int error) const {
  const char* advice = "";
  if (error == ENOSPC || error == EDQUOT) {
    advice = "\nfree some space, or choose another folder with -o";
  } else if (error == ENOENT) {
    advice = "\nthe folder does not exist";
  }
  throw RunError(
      fmt::format("cannot write {}: {}{}", path_, std::generic_category().message(error), advice));
}

void write_file(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

void make_folder(const std::string& path) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (failure) {
    throw RunError(fmt::format("cannot create the folder {}: {}", path, failure.message()));
  }
}

}  // namespace porefines
