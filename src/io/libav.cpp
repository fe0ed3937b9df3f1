// SPDX-License-Identifier: MPL-2.0
#include "io/libav.hpp"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::io {
namespace {

/// dlerror() has one text for all threads of some systems; here one thread opens libraries.
const char* why() {
  return ::dlerror();  // NOLINT(concurrency-mt-unsafe)
}

class Library {
 public:
  Library(const std::string& name, int version)
      : file_(fmt::format("lib{}.so.{}", name, version)),
        handle_(::dlopen(file_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) {
      throw RunError(
          fmt::format("a movie needs {}, which cannot be opened: {}\n"
                      "install it (Debian: apt install lib{}{}) or write no movie",
                      file_, why(), name, version));
    }
  }
  template <typename Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(::dlsym(handle_, name));
    if (function == nullptr) {
      throw RunError(fmt::format("{} knows no {}: {}", file_, name, why()));
    }
  }

 private:
  std::string file_;
  void* handle_;  ///< stays open until the program ends
};

void open_avutil(Libav& av) {
  const Library avutil("avutil", LIBAVUTIL_VERSION_MAJOR);
  avutil.find("av_dict_free", av.av_dict_free);
  avutil.find("av_dict_set", av.av_dict_set);
  avutil.find("av_frame_alloc", av.av_frame_alloc);
  avutil.find("av_frame_free", av.av_frame_free);
  avutil.find("av_frame_get_buffer", av.av_frame_get_buffer);
  avutil.find("av_frame_make_writable", av.av_frame_make_writable);
  avutil.find("av_log_set_level", av.av_log_set_level);
  avutil.find("av_opt_set", av.av_opt_set);
  avutil.find("av_strerror", av.av_strerror);
}

void open_avcodec(Libav& av) {
  const Library avcodec("avcodec", LIBAVCODEC_VERSION_MAJOR);
  avcodec.find("av_packet_alloc", av.av_packet_alloc);
  avcodec.find("av_packet_free", av.av_packet_free);
  avcodec.find("av_packet_rescale_ts", av.av_packet_rescale_ts);
  avcodec.find("avcodec_alloc_context3", av.avcodec_alloc_context3);
  avcodec.find("avcodec_find_encoder", av.avcodec_find_encoder);
  avcodec.find("avcodec_free_context", av.avcodec_free_context);
  avcodec.find("avcodec_open2", av.avcodec_open2);
  avcodec.find("avcodec_parameters_from_context", av.avcodec_parameters_from_context);
  avcodec.find("avcodec_receive_packet", av.avcodec_receive_packet);
  avcodec.find("avcodec_send_frame", av.avcodec_send_frame);
}

void open_avformat(Libav& av) {
  const Library avformat("avformat", LIBAVFORMAT_VERSION_MAJOR);
  avformat.find("av_interleaved_write_frame", av.av_interleaved_write_frame);
  avformat.find("av_write_trailer", av.av_write_trailer);
  avformat.find("avformat_alloc_output_context2", av.avformat_alloc_output_context2);
  avformat.find("avformat_free_context", av.avformat_free_context);
  avformat.find("avformat_new_stream", av.avformat_new_stream);
  avformat.find("avformat_write_header", av.avformat_write_header);
  avformat.find("avio_closep", av.avio_closep);
  avformat.find("avio_open", av.avio_open);
}

void open_swscale(Libav& av) {
  const Library swscale("swscale", LIBSWSCALE_VERSION_MAJOR);
  swscale.find("sws_freeContext", av.sws_freeContext);
  swscale.find("sws_getCoefficients", av.sws_getCoefficients);
  swscale.find("sws_getContext", av.sws_getContext);
  swscale.find("sws_scale", av.sws_scale);
  swscale.find("sws_setColorspaceDetails", av.sws_setColorspaceDetails);
}

}  // namespace

const Libav& libav() {
  static const Libav opened = [] {
    Libav av{};
    open_avutil(av);
    open_avcodec(av);
    open_avformat(av);
    open_swscale(av);
    return av;
  }();
  return opened;
}

}  // namespace porefines::io
