// SPDX-License-Identifier: MPL-2.0
#include "vision/film.hpp"

#include <cmath>

#include <opencv2/core.hpp>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace porefines::vision {
namespace {

struct Free {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};
template <typename Thing>
using Owned = std::unique_ptr<Thing, Free>;

/// 16..235, as films for television have it, to 0..255.
const cv::Mat& full_range() {
  static const cv::Mat table = [] {
    cv::Mat levels(1, 256, CV_8U);
    for (int v = 0; v < levels.cols; ++v) {
      levels.at<std::uint8_t>(v) = cv::saturate_cast<std::uint8_t>((v - 16) * 255.0 / 219.0);
    }
    return levels;
  }();
  return table;
}

/// Is the first plane the grey picture, a byte per pixel?
bool has_luma_plane(const AVFrame& frame, const AVPixFmtDescriptor& format) {
  constexpr auto other = AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_BITSTREAM |
                         AV_PIX_FMT_FLAG_HWACCEL;
  const AVComponentDescriptor& luma = format.comp[0];
  return (format.flags & other) == 0 && luma.plane == 0 && luma.depth == 8 && luma.step == 1 &&
         luma.offset == 0 && frame.linesize[0] > 0;
}

/// Clockwise quarter turns.
int turns_of(const AVStream& stream) {
  const auto* const matrix = reinterpret_cast<const std::int32_t*>(
      av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr));
  const Real angle = matrix == nullptr ? 0 : av_display_rotation_get(matrix);
  return std::isfinite(angle) ? (static_cast<int>(std::lround(-angle / 90)) % 4 + 4) % 4 : 0;
}

}  // namespace

struct Film::Parts {
  Owned<AVFormatContext> file;
  Owned<AVCodecContext> decoder;
  Owned<AVFrame> frame{av_frame_alloc()};
  Owned<AVPacket> packet{av_packet_alloc()};
  Owned<SwsContext> converter;
  const AVStream* stream = nullptr;
  bool intra_only = false;
  bool begun = false;  ///< a frame has been decoded
  int turns = 0;

  bool open(const std::string& path);
  bool read_packet();
  bool decode();
  cv::Mat grey();
  cv::Mat converted();
};

bool Film::Parts::open(const std::string& path) {
  av_log_set_level(AV_LOG_QUIET);  // messages are ours
  AVFormatContext* opened = nullptr;
  if (avformat_open_input(&opened, path.c_str(), nullptr, nullptr) < 0) {
    return false;
  }
  file.reset(opened);
  if (avformat_find_stream_info(opened, nullptr) < 0) {
    return false;
  }
  const AVCodec* codec = nullptr;
  const int number = av_find_best_stream(opened, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
  if (number < 0 || codec == nullptr) {
    return false;
  }
  stream = opened->streams[number];
  turns = turns_of(*stream);
  const AVCodecDescriptor* const about = avcodec_descriptor_get(codec->id);
  intra_only = about != nullptr && (about->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
  decoder.reset(avcodec_alloc_context3(codec));
  decoder->thread_count = 1;  // frames share the threads
  return avcodec_parameters_to_context(decoder.get(), stream->codecpar) >= 0 &&
         avcodec_open2(decoder.get(), codec, nullptr) >= 0;
}

/// The next packet of the stream that is whole.
bool Film::Parts::read_packet() {
  while (true) {
    av_packet_unref(packet.get());
    if (av_read_frame(file.get(), packet.get()) < 0) {
      return false;
    }
    if (packet->stream_index == stream->index) {
      return (packet->flags & AV_PKT_FLAG_CORRUPT) == 0;
    }
  }
}

bool Film::Parts::decode() {
  while (true) {
    const int got = avcodec_receive_frame(decoder.get(), frame.get());
    if (got == 0) {
      begun = true;
      return (frame->flags & AV_FRAME_FLAG_CORRUPT) == 0 && frame->decode_error_flags == 0;
    }
    if (got != AVERROR(EAGAIN)) {
      return false;
    }
    const bool more = read_packet();
    const int sent = avcodec_send_packet(decoder.get(), more ? packet.get() : nullptr);
    if (sent < 0 && (begun || !more)) {  // a film may begin in the middle of a group of pictures
      return false;
    }
  }
}

cv::Mat Film::Parts::converted() {
  converter.reset(sws_getCachedContext(
      converter.release(), frame->width, frame->height, static_cast<AVPixelFormat>(frame->format),
      frame->width, frame->height, AV_PIX_FMT_GRAY8, SWS_BILINEAR, nullptr, nullptr, nullptr));
  if (!converter) {
    return {};
  }
  cv::Mat out(frame->height, frame->width, CV_8U);
  std::uint8_t* const data[] = {out.data};          // NOLINT: what sws_scale wants
  const int step[] = {static_cast<int>(out.step)};  // NOLINT
  sws_scale(converter.get(), frame->data, frame->linesize, 0, frame->height, data, step);
  return out;
}

cv::Mat Film::Parts::grey() {
  const AVPixFmtDescriptor* const format =
      av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame->format));
  cv::Mat out;
  if (format == nullptr || !has_luma_plane(*frame, *format)) {
    out = converted();
  } else {
    const cv::Mat luma(frame->height, frame->width, CV_8U, frame->data[0],
                       static_cast<std::size_t>(frame->linesize[0]));
    const std::string name = format->name;
    const bool full = frame->color_range == AVCOL_RANGE_JPEG || name.rfind("yuvj", 0) == 0 ||
                      (format->nb_components < 3 && frame->color_range != AVCOL_RANGE_MPEG);
    if (full) {
      luma.copyTo(out);
    } else {
      cv::LUT(luma, full_range(), out);
    }
  }
  if (turns > 0 && !out.empty()) {
    cv::rotate(out, out, turns - 1);
  }
  return out;
}

Film::Film(const std::string& path) : parts_(std::make_unique<Parts>()) {
  if (!parts_->open(path)) {
    parts_.reset();
  }
}

Film::~Film() = default;
Film::Film(Film&&) noexcept = default;
Film& Film::operator=(Film&&) noexcept = default;

bool Film::is_open() const {
  return parts_ != nullptr;
}

Real Film::frame_rate() const {
  constexpr Real fastest = 1e7;  // [frames/s]; beyond it the container knows nothing
  auto* const stream = parts_->file->streams[parts_->stream->index];
  const Real rate = av_q2d(av_guess_frame_rate(parts_->file.get(), stream, nullptr));
  return std::isfinite(rate) && rate > 0 && rate < fastest ? rate : 0;
}

int Film::frames() const {
  const AVStream& stream = *parts_->stream;
  const AVFormatContext& file = *parts_->file;
  Real seconds = 0;
  if (file.duration_estimation_method != AVFMT_DURATION_FROM_BITRATE) {  // a guess
    seconds = stream.duration > 0 ? static_cast<Real>(stream.duration) * av_q2d(stream.time_base)
                                  : static_cast<Real>(file.duration) / AV_TIME_BASE;
  }
  const auto said = static_cast<Real>(stream.nb_frames);
  const Real count = said > 0 ? said : std::round(seconds * frame_rate());
  return count > 0 && count < 1e9 ? static_cast<int>(count) : 0;
}

bool Film::next(cv::Mat& grey) {
  if (!parts_->decode()) {
    return false;
  }
  grey = parts_->grey();
  return !grey.empty();
}

bool Film::skip() {
  return parts_->intra_only ? parts_->read_packet() : parts_->decode();
}

}  // namespace porefines::vision
