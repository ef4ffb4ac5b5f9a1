#include "preview/image_module/picture_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <zlib.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

namespace {

using Bytes = std::vector<unsigned char>;

OIIO::TypeDesc type_of(CitykilnSample type) {
  switch (type) {
    case kCitykilnByte:
      return OIIO::TypeDesc::UINT8;
    case kCitykilnHalf:
      return OIIO::TypeDesc::HALF;
    case kCitykilnFloat:
      return OIIO::TypeDesc::FLOAT;
    default:
      return OIIO::TypeDesc::UINT32;
  }
}

// The type in which samples are given: halves as floats.
OIIO::TypeDesc given_type_of(CitykilnSample type) {
  return type == kCitykilnHalf ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : type_of(type);
}

OIIO::ImageSpec spec_of(const CitykilnPicture& picture) {
  OIIO::ImageSpec spec(picture.width, picture.height, picture.channel_count, type_of(picture.channels[0].type));
  spec.channelnames.clear();
  for (int c = 0; c < picture.channel_count; ++c) {
    spec.channelnames.emplace_back(picture.channels[c].name);
    spec.channelformats.push_back(type_of(picture.channels[c].type));
  }
  spec.attribute("oiio:ColorSpace", picture.channels[0].type == kCitykilnByte ? "sRGB" : "Linear");
  // PNG's own texts are Latin-1: add_texts() writes them
  const bool is_png = picture.channels[0].type == kCitykilnByte;
  for (int i = 0; i < picture.text_count && !is_png; ++i)
    spec.attribute(picture.texts[2 * i], picture.texts[2 * i + 1]);
  // else the time of writing is added, and equal pictures would differ
  if (!is_png && spec.find_attribute("DateTime") == nullptr) spec.attribute("DateTime", "1970:01:01 00:00:00");
  return spec;
}

void add_number(std::string& bytes, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(number >> shift & 0xff));
}

// A chunk "iTXt" (PNG 1.2, 4.2.3.3): a name and a text in UTF-8, not compressed, of no language.
std::string text_chunk(const std::string& name, const std::string& text) {
  const std::string body = "iTXt" + name + std::string(5, '\0') + text;
  std::string chunk;
  add_number(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  add_number(chunk, static_cast<std::uint32_t>(
                        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
  return chunk;
}

// Inserts the texts behind the header of a PNG file: 8 bytes of signature and 25 of IHDR.
void add_texts(const CitykilnPicture& picture, Bytes& png) {
  constexpr std::ptrdiff_t kHeader = 33;
  std::string chunks;
  for (int i = 0; i < picture.text_count; ++i) chunks += text_chunk(picture.texts[2 * i], picture.texts[2 * i + 1]);
  png.insert(png.begin() + kHeader, chunks.begin(), chunks.end());
}

// The samples of all channels, pixel by pixel, in the types of the file.
Bytes interleaved(const CitykilnPicture& picture, const OIIO::ImageSpec& spec) {
  const std::size_t pixels = spec.image_pixels(), pixel_bytes = spec.pixel_bytes(true);
  Bytes bytes(pixels * pixel_bytes);
  std::size_t offset = 0;
  for (int c = 0; c < picture.channel_count; ++c) {
    const CitykilnChannel& channel = picture.channels[c];
    const OIIO::TypeDesc given = given_type_of(channel.type), stored = type_of(channel.type);
    const OIIO::stride_t step = static_cast<OIIO::stride_t>(given.size()) * channel.stride;
    OIIO::convert_image(1, static_cast<int>(pixels), 1, 1, channel.samples, given, step, step, OIIO::AutoStride,
                        bytes.data() + offset, stored, static_cast<OIIO::stride_t>(pixel_bytes),
                        static_cast<OIIO::stride_t>(pixel_bytes), OIIO::AutoStride);
    offset += stored.size();
  }
  return bytes;
}

// Encodes the file in memory, since OpenImageIO does not report a full disk. Returns the error, or "".
std::string encode(const char* path, const CitykilnPicture& picture, Bytes& bytes) {
  OIIO::Filesystem::IOVecOutput into(bytes);
  auto out = OIIO::ImageOutput::create(path, &into);
  if (!out) return OIIO::geterror();
  const OIIO::ImageSpec spec = spec_of(picture);
  if (!out->open(path, spec)) return out->geterror();
  const bool written = out->write_image(OIIO::TypeDesc::UNKNOWN, interleaved(picture, spec).data());
  const std::string message = out->geterror();
  const bool is_whole = out->close() && written;
  if (is_whole && picture.channels[0].type == kCitykilnByte) add_texts(picture, bytes);
  return is_whole ? "" : message.empty() ? "could not be encoded" : message;
}

std::string save(const char* path, const Bytes& bytes) {
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr) return std::strerror(errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  // flushes, and may fail
  return std::fclose(file) == 0 && written ? "" : std::strerror(errno);
}

std::string read(const char* path, CitykilnAllocate allocate, void* owner) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in) return OIIO::geterror();
  const OIIO::ImageSpec& spec = in->spec();
  if (spec.deep || spec.depth > 1) return "has deep or volume pixels; expected a flat picture";
  if (spec.nchannels < 1) return "has no channels";
  float* rgb = allocate(owner, spec.width, spec.height);
  if (rgb == nullptr) return "is too large";
  const int channels = spec.nchannels < 3 ? 1 : 3;
  constexpr OIIO::stride_t kPixel = 3 * sizeof(float);
  if (!in->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, rgb, kPixel)) return in->geterror();
  const std::size_t pixels = spec.image_pixels();
  for (std::size_t i = 0; channels == 1 && i < pixels; ++i) rgb[3 * i + 1] = rgb[3 * i + 2] = rgb[3 * i];
  return "";
}

int answer(const std::string& message, char* error, int error_size) {
  if (message.empty()) return 0;
  std::snprintf(error, static_cast<std::size_t>(error_size), "%s", message.c_str());
  return 1;
}

}  // namespace

extern "C" int citykiln_write_picture(const char* path, const CitykilnPicture* picture, char* error, int error_size) {
  Bytes bytes;
  std::string message = encode(path, *picture, bytes);
  if (message.empty()) message = save(path, bytes);
  return answer(message, error, error_size);
}

extern "C" int citykiln_read_picture(const char* path, CitykilnAllocate allocate, void* owner, char* error,
                                     int error_size) {
  try {
    return answer(read(path, allocate, owner), error, error_size);
  } catch (const std::exception& problem) {
    return answer(problem.what(), error, error_size);
  }
}
