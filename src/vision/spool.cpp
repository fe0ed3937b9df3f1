// SPDX-License-Identifier: MPL-2.0
#include "vision/spool.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::vision {
namespace {

constexpr std::size_t header_bytes = 64;
static_assert(sizeof(Spot) == 4 * sizeof(double));

[[noreturn]] void fail(const std::string& path) {
  throw RunError(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

std::array<char, header_bytes> header_of(const std::string& fingerprint) {
  std::array<char, header_bytes> header{};
  const std::string text =
      fmt::format("porefines spots 1 {:016x}", std::hash<std::string>{}(fingerprint));
  std::copy(text.begin(), text.end(), header.begin());
  return header;
}

/// One frame; false where the file does not hold it whole.
bool read_frame(std::FILE* file, Spots& spots) {
  Index count = 0;
  Index again = -1;
  if (std::fread(&count, sizeof count, 1, file) != 1 || count < 0) {
    return false;
  }
  spots.resize(static_cast<std::size_t>(count));
  return std::fread(spots.data(), sizeof(Spot), spots.size(), file) == spots.size() &&
         std::fread(&again, sizeof again, 1, file) == 1 && again == count;
}

}  // namespace

SpotWriter::SpotWriter(const std::string& path, const std::string& fingerprint, bool resume)
    : path_(path) {
  const auto header = header_of(fingerprint);
  if (resume) {
    file_.reset(std::fopen(path.c_str(), "r+b"));
    std::array<char, header_bytes> there{};
    if (file_ && std::fread(there.data(), 1, header_bytes, file_.get()) == header_bytes &&
        there == header) {
      Spots spots;
      long end = header_bytes;
      while (read_frame(file_.get(), spots)) {
        ++frames_;
        end = std::ftell(file_.get());
      }
      std::fseek(file_.get(), end, SEEK_SET);
      std::filesystem::resize_file(path, static_cast<std::uintmax_t>(end));
      return;
    }
  }
  file_.reset(std::fopen(path.c_str(), "wb"));
  if (!file_ || std::fwrite(header.data(), 1, header_bytes, file_.get()) != header_bytes) {
    fail(path);
  }
}

void SpotWriter::append(const Spots& spots) {
  const auto count = static_cast<Index>(spots.size());
  if (std::fwrite(&count, sizeof count, 1, file_.get()) != 1 ||
      std::fwrite(spots.data(), sizeof(Spot), spots.size(), file_.get()) != spots.size() ||
      std::fwrite(&count, sizeof count, 1, file_.get()) != 1) {
    fail(path_);
  }
  ++frames_;
}

void SpotWriter::flush() {
  if (std::fflush(file_.get()) != 0) {
    fail(path_);
  }
}

SpotReader::SpotReader(const std::string& path) : file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) {
    throw RunError("cannot read " + path);
  }
  std::fseek(file_.get(), header_bytes, SEEK_SET);
}

bool SpotReader::next(Spots& spots) {
  return read_frame(file_.get(), spots);
}

void SpotReader::skip(int count) {
  Spots spots;
  for (int k = 0; k < count && next(spots); ++k) {
  }
}

}  // namespace porefines::vision
