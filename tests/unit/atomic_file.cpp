// SPDX-License-Identifier: MPL-2.0
#include "core/atomic_file.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/error.hpp"
#include "support/scratch.hpp"

namespace porefines {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// While it lives, no file of this process may grow beyond `bytes`: a full disk for the test.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(AtomicFile, appears_only_when_committed) {
  const test::Scratch folder;
  const std::string path = folder / "a.txt";
  AtomicFile file(path);
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(content_of(path), "one two");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(AtomicFile, leaves_the_old_file_when_not_committed) {
  const test::Scratch folder;
  const std::string path = folder / "a.txt";
  write_file(path, "old");
  { AtomicFile(path).write("new"); }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(AtomicFile, a_short_write_is_an_error_and_keeps_the_old_file) {
  const test::Scratch folder;
  const std::string path = folder / "a.txt";
  write_file(path, "old");
  std::string message = "no error";
  {
    const FileSizeLimit full_disk(4096);
    try {
      write_file(path, std::string(10000, 'x'));
    } catch (const RunError& error) {
      message = error.what();
    }
  }
  EXPECT_EQ(message, "cannot write " + path + ": File too large");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(AtomicFile, names_the_file_it_cannot_open) {
  try {
    AtomicFile file("/no/such/folder/a.txt");
    FAIL() << "opened";
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(),
                 "cannot write /no/such/folder/a.txt: No such file or directory\n"
                 "the folder does not exist");
  }
}

TEST(MakeFolder, creates_parents_and_accepts_an_existing_one) {
  const test::Scratch folder;
  make_folder(folder / "a/b");
  make_folder(folder / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  write_file(folder / "file", "");
  EXPECT_THROW(make_folder(folder / "file/c"), RunError);
}

}  // namespace
}  // namespace porefines
