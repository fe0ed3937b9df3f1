// SPDX-License-Identifier: MPL-2.0
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/error.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace porefines::io {

/// What a movie needs of libav, under libav's own names.
struct Libav {  // NOLINTBEGIN(readability-identifier-naming)
  decltype(&::av_dict_free) av_dict_free;
  decltype(&::av_dict_set) av_dict_set;
  decltype(&::av_frame_alloc) av_frame_alloc;
  decltype(&::av_frame_free) av_frame_free;
  decltype(&::av_frame_get_buffer) av_frame_get_buffer;
  decltype(&::av_frame_make_writable) av_frame_make_writable;
  decltype(&::av_log_set_level) av_log_set_level;
  decltype(&::av_opt_set) av_opt_set;
  decltype(&::av_strerror) av_strerror;
  decltype(&::av_packet_alloc) av_packet_alloc;
  decltype(&::av_packet_free) av_packet_free;
  decltype(&::av_packet_rescale_ts) av_packet_rescale_ts;
  decltype(&::avcodec_alloc_context3) avcodec_alloc_context3;
  decltype(&::avcodec_find_encoder) avcodec_find_encoder;
  decltype(&::avcodec_free_context) avcodec_free_context;
  decltype(&::avcodec_open2) avcodec_open2;
  decltype(&::avcodec_parameters_from_context) avcodec_parameters_from_context;
  decltype(&::avcodec_receive_packet) avcodec_receive_packet;
  decltype(&::avcodec_send_frame) avcodec_send_frame;
  decltype(&::av_interleaved_write_frame) av_interleaved_write_frame;
  decltype(&::av_write_trailer) av_write_trailer;
  decltype(&::avformat_alloc_output_context2) avformat_alloc_output_context2;
  decltype(&::avformat_free_context) avformat_free_context;
  decltype(&::avformat_new_stream) avformat_new_stream;
  decltype(&::avformat_write_header) avformat_write_header;
  decltype(&::avio_closep) avio_closep;
  decltype(&::avio_open) avio_open;
  decltype(&::sws_freeContext) sws_freeContext;
  decltype(&::sws_getCoefficients) sws_getCoefficients;
  decltype(&::sws_getContext) sws_getContext;
  decltype(&::sws_scale) sws_scale;
  decltype(&::sws_setColorspaceDetails) sws_setColorspaceDetails;
};  // NOLINTEND(readability-identifier-naming)

/// Opened at the first call, of the version that porefines was built with: its 140 libraries would
/// cost every run 0.1 s and 20 MB. RunError that names the Debian package where one is missing.
const Libav& libav();

}  // namespace porefines::io
