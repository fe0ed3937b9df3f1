// SPDX-License-Identifier: MPL-2.0
#include "io/movie.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"
#include "io/libav.hpp"

namespace porefines::io {
namespace {

struct Free {
  void operator()(AVCodecContext* p) const { libav().avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { libav().av_frame_free(&p); }
  void operator()(AVPacket* p) const { libav().av_packet_free(&p); }
  void operator()(SwsContext* p) const { libav().sws_freeContext(p); }
  void operator()(AVFormatContext* p) const {
    if (p->pb != nullptr) {
      libav().avio_closep(&p->pb);
    }
    libav().avformat_free_context(p);
  }
};
template <class T>
using Held = std::unique_ptr<T, Free>;

}  // namespace

struct MovieWriter::Encoder {
  std::string path;
  std::string part;
  int width = 0;
  int height = 0;
  Held<AVFormatContext> file;
  Held<AVCodecContext> codec;
  Held<SwsContext> scale;
  Held<AVFrame> frame;
  Held<AVPacket> packet;
  AVStream* stream = nullptr;

  ~Encoder() {
    file.reset();
    if (!part.empty()) {
      ::unlink(part.c_str());
    }
  }
  Encoder() = default;
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void require(int result, std::string_view what) const {
    if (result < 0) {
      std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
      libav().av_strerror(result, text.data(), text.size());
      throw RunError(fmt::format("{}: cannot {}: {}", path, what, text.data()));
    }
  }
  template <class T>
  [[nodiscard]] T* made(T* pointer, std::string_view what) const {
    if (pointer == nullptr) {
      throw RunError(fmt::format("{}: cannot {}", path, what));
    }
    return pointer;
  }
  void open_codec(int frame_rate);
  void open_file(const Provenance& provenance, const std::string& title);
  void encode(const AVFrame* picture);
};

/// H.264 at constant quality; one thread and a short look ahead: the same bytes every time, few
/// frames in memory.
void MovieWriter::Encoder::open_codec(int frame_rate) {
  const AVCodec* const h264 = made(libav().avcodec_find_encoder(AV_CODEC_ID_H264),
                                   "find an H.264 encoder (Debian: libavcodec59 with libx264)");
  codec.reset(made(libav().avcodec_alloc_context3(h264), "start the encoder"));
  codec->width = width;
  codec->height = height;
  codec->time_base = {1, frame_rate};
  codec->framerate = {frame_rate, 1};
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  codec->color_range = AVCOL_RANGE_MPEG;
  codec->colorspace = AVCOL_SPC_BT709;
  codec->color_primaries = AVCOL_PRI_BT709;
  codec->color_trc = AVCOL_TRC_BT709;
  codec->gop_size = frame_rate;
  codec->thread_count = 1;
  codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  libav().av_opt_set(codec->priv_data, "preset", "veryfast", 0);
  libav().av_opt_set(codec->priv_data, "crf", "20", 0);
  libav().av_opt_set(codec->priv_data, "x264-params", "rc-lookahead=4:sync-lookahead=0:bframes=0",
                     0);
  require(libav().avcodec_open2(codec.get(), h264, nullptr), "start the encoder");

  frame.reset(made(libav().av_frame_alloc(), "allocate a frame"));
  frame->format = codec->pix_fmt;
  frame->width = width;
  frame->height = height;
  require(libav().av_frame_get_buffer(frame.get(), 0), "allocate a frame");
  packet.reset(made(libav().av_packet_alloc(), "allocate a packet"));
  scale.reset(
      made(libav().sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, codec->pix_fmt,
                                  SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr),
           "convert colours"));
  const int* const bt709 = libav().sws_getCoefficients(SWS_CS_ITU709);
  libav().sws_setColorspaceDetails(scale.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
}

void MovieWriter::Encoder::open_file(const Provenance& provenance, const std::string& title) {
  AVFormatContext* context = nullptr;
  require(libav().avformat_alloc_output_context2(&context, nullptr, "mp4", part.c_str()),
          "write MP4");
  file.reset(context);
  stream = made(libav().avformat_new_stream(context, nullptr), "write MP4");
  require(libav().avcodec_parameters_from_context(stream->codecpar, codec.get()), "write MP4");
  stream->time_base = codec->time_base;
  stream->avg_frame_rate = codec->framerate;
  libav().av_dict_set(&context->metadata, "comment", describe(provenance).c_str(), 0);
  libav().av_dict_set(&context->metadata, "title", title.c_str(), 0);
  require(libav().avio_open(&context->pb, part.c_str(), AVIO_FLAG_WRITE), "open the file");
  AVDictionary* options = nullptr;
  libav().av_dict_set(&options, "movflags", "+faststart", 0);  // starts before it is loaded whole
  const int result = libav().avformat_write_header(context, &options);
  libav().av_dict_free(&options);
  require(result, "write the header");
}

/// @param picture  null: the last ones that the encoder still holds
void MovieWriter::Encoder::encode(const AVFrame* picture) {
  require(libav().avcodec_send_frame(codec.get(), picture), "encode a frame");
  for (;;) {
    const int result = libav().avcodec_receive_packet(codec.get(), packet.get());
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) {
      return;
    }
    require(result, "encode a frame");
    packet->duration = 1;
    libav().av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
    packet->stream_index = stream->index;
    require(libav().av_interleaved_write_frame(file.get(), packet.get()), "write a frame");
  }
}

MovieWriter::MovieWriter(const std::string& path, int width, int height, int frame_rate,
                         const Provenance& provenance, const std::string& title)
    : encoder_(std::make_unique<Encoder>()) {
  encoder_->path = path;
  if (width < 2 || height < 2 || frame_rate < 1) {
    throw RunError(fmt::format("{}: no movie of {} x {} pixels at {} frames a second", path, width,
                               height, frame_rate));
  }
  libav().av_log_set_level(AV_LOG_ERROR);
  encoder_->part = path + ".part";
  encoder_->width = width & ~1;
  encoder_->height = height & ~1;
  encoder_->open_codec(frame_rate);
  encoder_->open_file(provenance, title);
}

MovieWriter::~MovieWriter() = default;
MovieWriter::MovieWriter(MovieWriter&&) noexcept = default;

void MovieWriter::add(const PixelView& frame) {
  Encoder& e = *encoder_;
  const bool fits = (frame.width & ~1) == e.width && (frame.height & ~1) == e.height &&
                    frame.channels == 3 &&
                    frame.pixels.size() == static_cast<std::size_t>(frame.width) * frame.height * 3;
  if (!fits) {
    throw RunError(fmt::format("{}: a frame of {} x {} pixels for a movie of {} x {}", e.path,
                               frame.width, frame.height, e.width, e.height));
  }
  e.require(libav().av_frame_make_writable(e.frame.get()), "allocate a frame");
  const std::uint8_t* const rows[] = {frame.pixels.data()};
  const int stride[] = {3 * frame.width};
  libav().sws_scale(e.scale.get(), rows, stride, 0, e.height, e.frame->data, e.frame->linesize);
  e.frame->pts = e.frame->pts == AV_NOPTS_VALUE ? 0 : e.frame->pts + 1;
  e.encode(e.frame.get());
}

void MovieWriter::finish() {
  Encoder& e = *encoder_;
  e.encode(nullptr);
  e.require(libav().av_write_trailer(e.file.get()), "complete the file");
  e.require(libav().avio_closep(&e.file->pb), "complete the file");
  if (std::rename(e.part.c_str(), e.path.c_str()) != 0) {
    throw RunError(fmt::format("{}: cannot rename {}: {}", e.path, e.part,
                               std::generic_category().message(errno)));
  }
  e.part.clear();
}

}  // namespace porefines::io
