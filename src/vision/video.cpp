// SPDX-License-Identifier: MPL-2.0
#include "vision/video.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "vision/parallel.hpp"

namespace porefines::vision {
namespace {

bool is_image(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string> known{".png", ".tif", ".tiff", ".jpg", ".jpeg", ".bmp", ".pgm"};
  return std::find(known.begin(), known.end(), ending) != known.end();
}

std::vector<std::string> images_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && is_image(entry.path())) {
      names.push_back(entry.path().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

cv::Mat as_grey(const cv::Mat& picture) {
  cv::Mat grey;
  if (picture.channels() == 1) {
    return picture;
  }
  cv::cvtColor(picture, grey, picture.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace

cv::Mat to_float(const cv::Mat& grey) {
  cv::Mat out;
  constexpr Real sixteen_bits = 255.0 / 65535.0;
  grey.convertTo(out, CV_32F, grey.depth() == CV_16U ? sixteen_bits : 1.0);
  return out;
}

cv::Mat read_grey(const std::string& path) {
  try {
    return cv::imread(path, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH);
  } catch (const cv::Exception&) {
    return {};
  }
}

Video::Video(const std::string& path) : path_(path) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // messages are ours
  if (!std::filesystem::exists(path)) {
    throw InputError(path + ": no such video or folder");
  }
  if (std::filesystem::is_directory(path)) {
    images_ = images_in(path);
    if (images_.empty()) {
      throw InputError(path +
                       ": no images in this folder\n"
                       "it should hold one PNG, TIFF, JPEG, BMP or PGM file per frame");
    }
    frames_ = static_cast<int>(images_.size());
  } else {
    film_.emplace(path);
    if (!film_->is_open()) {
      throw InputError(path +
                       ": cannot be read as a video\n"
                       "try a folder with one image per frame, or convert it to AVI (MJPG)");
    }
    frame_rate_ = film_->frame_rate();
    frames_ = film_->frames();
  }
  const auto first = read(1);
  if (first.empty()) {
    throw InputError(fmt::format("{}: {}", path, problem_.empty() ? "no frames" : problem_));
  }
  seek(0);
}

std::string Video::name_of(int frame) const {
  return images_.empty()
             ? fmt::format("frame {}", frame)
             : fmt::format("frame {} ({})", frame,
                           std::filesystem::path(images_[static_cast<std::size_t>(frame)])
                               .filename()
                               .string());
}

std::vector<cv::Mat> Video::read_images(int count, int threads) {
  count = std::min(count, frames_ - next_);
  std::vector<cv::Mat> frames(static_cast<std::size_t>(std::max(count, 0)));
  for_each_index(count, threads, [&](int i) {
    frames[static_cast<std::size_t>(i)] =
        as_grey(read_grey(images_[static_cast<std::size_t>(next_ + i)]));
  });
  return frames;
}

std::vector<cv::Mat> Video::read_stream(int count) {
  std::vector<cv::Mat> frames;
  while (static_cast<int>(frames.size()) < count) {
    cv::Mat picture;
    if (!film_->next(picture)) {
      const int here = next_ + static_cast<int>(frames.size());
      if (here < frames_) {
        problem_ = fmt::format("frame {}: the video ends here, but its header announces {} frames",
                               here, frames_);
      }
      break;
    }
    frames.push_back(picture);
  }
  return frames;
}

void Video::drop_unusable(std::vector<cv::Mat>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const int frame = next_ + static_cast<int>(i);
    if (frames[i].empty()) {
      problem_ = name_of(frame) + ": cannot be read as an image; is it truncated?";
    } else if (size_.empty()) {
      size_ = frames[i].size();
    } else if (frames[i].size() != size_) {
      problem_ = fmt::format("{}: {} x {} pixels, not {} x {} as the first", name_of(frame),
                             frames[i].cols, frames[i].rows, size_.width, size_.height);
    }
    if (!problem_.empty()) {
      frames.resize(i);
      return;
    }
  }
}

std::vector<cv::Mat> Video::read(int count, int threads) {
  if (!problem_.empty()) {
    return {};
  }
  std::vector<cv::Mat> frames = images_.empty() ? read_stream(count) : read_images(count, threads);
  const std::string ending = std::exchange(problem_, "");
  drop_unusable(frames);
  problem_ = problem_.empty() ? ending : problem_;
  next_ += static_cast<int>(frames.size());
  return frames;
}

void Video::seek(int frame) {
  problem_.clear();
  if (images_.empty()) {
    // Frame-exact seeking is not to be had from every container: start again and skip.
    if (frame < next_) {
      film_.emplace(path_);
      next_ = 0;
    }
    while (next_ < frame && film_->is_open() && film_->skip()) {
      ++next_;
    }
    return;
  }
  next_ = std::min(frame, frames_);
}

}  // namespace porefines::vision
