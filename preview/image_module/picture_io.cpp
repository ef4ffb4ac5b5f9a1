#include "preview/image_module/picture_io.h"

#include <OpenImageIO/imageio.h>

#include <cstdio>

extern "C" int citykiln_write_picture(const char* path, int width, int height, const void* pixels, int is_float,
                                      char* error, int error_size) {
  const auto fail = [&](const std::string& message) {
    std::snprintf(error, static_cast<std::size_t>(error_size), "%s", message.c_str());
    return 1;
  };
  const OIIO::TypeDesc type = is_float != 0 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  auto out = OIIO::ImageOutput::create(path);
  if (!out) return fail(OIIO::geterror());
  OIIO::ImageSpec spec(width, height, 3, is_float != 0 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", is_float != 0 ? "Linear" : "sRGB");
  spec.attribute("Copyright", "\u00a9 OpenStreetMap contributors");
  if (!out->open(path, spec)) return fail(out->geterror());
  const bool written = out->write_image(type, pixels);
  const std::string message = out->geterror();
  return out->close() && written ? 0 : fail(message.empty() ? "could not be written" : message);
}
