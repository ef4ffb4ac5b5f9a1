#include "exporters/gltf/pictures/jpeg.h"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>

// needs <cstdio>
#include <jpeglib.h>

namespace citykiln::exporters {
namespace {

using materials::TextureImage;

// libjpeg's errors leave its functions by a jump.
struct ErrorManager {
  jpeg_error_mgr base;
  std::jmp_buf out;
};

[[noreturn]] void jump_out(j_common_ptr info) { std::longjmp(reinterpret_cast<ErrorManager*>(info->err)->out, 1); }

jpeg_error_mgr* use(ErrorManager& errors) {
  jpeg_std_error(&errors.base);
  errors.base.error_exit = jump_out;
  // counts warnings without printing them
  errors.base.emit_message = [](j_common_ptr info, int level) { info->err->num_warnings += level < 0; };
  return &errors.base;
}

// An upper bound: the least blocks take 6 bits for each of 6 blocks of 64 samples, which are 256 texels.
bool may_hold(std::size_t bytes, std::uint64_t texels) {
  constexpr std::uint64_t kTexelsPerByte = 512;
  return texels > 0 && texels <= std::min<std::uint64_t>(kTexelsPerByte * bytes, materials::kMaxImageTexels);
}

bool is_acceptable(const jpeg_decompress_struct& info, std::size_t bytes) {
  return info.progressive_mode == FALSE && info.arith_code == FALSE &&
         std::max(info.image_width, info.image_height) <= materials::kMaxImageSide_px &&
         may_hold(bytes, std::uint64_t{info.image_width} * info.image_height);
}

// Reads the image into `image`. Nothing here has a destructor that a jump would skip.
bool read(jpeg_decompress_struct& info, ErrorManager& errors, std::span<const std::byte> bytes, TextureImage& image) {
  if (setjmp(errors.out) != 0) return false;
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  if (!is_acceptable(info, bytes.size())) return false;
  info.out_color_space = JCS_RGB, info.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&info);
  image.columns = info.output_width, image.rows = info.output_height;
  image.texels.resize(std::size_t{image.columns} * image.rows);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = image.texels[std::size_t{info.output_scanline} * image.columns].data();
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  return errors.base.num_warnings == 0;
}

}  // namespace

std::vector<std::byte> encode_jpeg(const TextureImage& image, int quality, JpegChroma chroma) {
  assert(image.texels.size() == std::size_t{image.columns} * image.rows && !image.texels.empty());
  assert(1 <= quality && quality <= 100);
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &data, &size);
  info.image_width = image.columns, info.image_height = image.rows;
  info.input_components = 3, info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  const int luma_per_chroma = chroma == JpegChroma::kHalf ? 2 : 1;
  info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = luma_per_chroma;
  info.optimize_coding = TRUE, info.dct_method = JDCT_ISLOW;
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    auto row = const_cast<JSAMPROW>(image.texels[std::size_t{info.next_scanline} * image.columns].data());
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const auto* first = reinterpret_cast<const std::byte*>(data);
  std::vector<std::byte> bytes(first, first + size);
  std::free(data);
  return bytes;
}

Result<TextureImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& name) {
  jpeg_decompress_struct info{};
  ErrorManager errors{};
  info.err = use(errors);
  jpeg_create_decompress(&info);
  TextureImage image;
  const bool is_read = read(info, errors, bytes, image);
  jpeg_destroy_decompress(&info);
  if (!is_read) return Error{name, "expected a whole baseline JPEG picture of no more texels than an image may have"};
  return image;
}

}  // namespace citykiln::exporters
