#include "preview/image_module/picture_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

using Bytes = std::vector<unsigned char>;

// Encodes the file in memory, since OpenImageIO does not report a full disk. Returns the error, or "".
std::string encode(const char* path, int width, int height, const void* pixels, bool is_float, Bytes& bytes) {
  OIIO::Filesystem::IOVecOutput into(bytes);
  auto out = OIIO::ImageOutput::create(path, &into);
  if (!out) return OIIO::geterror();
  OIIO::ImageSpec spec(width, height, 3, is_float ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", is_float ? "Linear" : "sRGB");
  spec.attribute("Copyright", "\u00a9 OpenStreetMap contributors");
  if (!out->open(path, spec)) return out->geterror();
  const bool written = out->write_image(is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8, pixels);
  const std::string message = out->geterror();
  return out->close() && written ? "" : message.empty() ? "could not be encoded" : message;
}

std::string save(const char* path, const Bytes& bytes) {
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr) return std::strerror(errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  // flushes, and may fail
  return std::fclose(file) == 0 && written ? "" : std::strerror(errno);
}

}  // namespace

extern "C" int citykiln_write_picture(const char* path, int width, int height, const void* pixels, int is_float,
                                      char* error, int error_size) {
  Bytes bytes;
  std::string message = encode(path, width, height, pixels, is_float != 0, bytes);
  if (message.empty()) message = save(path, bytes);
  if (message.empty()) return 0;
  std::snprintf(error, static_cast<std::size_t>(error_size), "%s", message.c_str());
  return 1;
}
