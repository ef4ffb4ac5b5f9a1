#include <array>
#include <cstdio>
#include <limits>

#include "compiler/contract/system/load_module.h"
#include "preview/image_module/picture_io.h"
#include "preview/picture/image.h"
#include "preview/picture/tone_map.h"

namespace citykiln::preview {
namespace {

// The names of a picture's parts in its file. OpenImageIO calls PNG's and OpenEXR's own texts by these names.
constexpr const char* kCredit = "\u00a9 OpenStreetMap contributors, ODbL 1.0";

// OSM ids as whole numbers of 32 bits: an id may have more than 32, which float channels cannot hold exactly.
struct IdChannels {
  std::vector<std::uint32_t> low, high, type;
};

IdChannels id_channels(const std::vector<OsmId>& features) {
  IdChannels ids;
  for (const OsmId& feature : features) {
    const auto bits = static_cast<std::uint64_t>(feature.id);
    ids.low.push_back(static_cast<std::uint32_t>(bits));
    ids.high.push_back(static_cast<std::uint32_t>(bits >> 32));
    ids.type.push_back(static_cast<std::uint32_t>(feature.type));
  }
  return ids;
}

void add_three(std::vector<CitykilnChannel>& channels, const std::array<const char*, 3>& names, CitykilnSample type,
               const std::vector<float>& samples) {
  for (std::size_t c = 0; c < 3; ++c) channels.push_back({names[c], type, &samples[c], 3});
}

std::vector<CitykilnChannel> exr_channels(const Image& image, const IdChannels& ids) {
  std::vector<CitykilnChannel> channels;
  add_three(channels, {"R", "G", "B"}, kCitykilnHalf, image.rgb);
  const Guides& guides = image.guides;
  if (guides.albedo.empty()) return channels;
  channels.push_back({"Z", kCitykilnFloat, guides.depth_m.data(), 1});
  add_three(channels, {"albedo.R", "albedo.G", "albedo.B"}, kCitykilnHalf, guides.albedo);
  channels.push_back({"id.high", kCitykilnUint, ids.high.data(), 1});
  channels.push_back({"id.low", kCitykilnUint, ids.low.data(), 1});
  channels.push_back({"id.type", kCitykilnUint, ids.type.data(), 1});
  add_three(channels, {"normal.X", "normal.Y", "normal.Z"}, kCitykilnHalf, guides.normal);
  channels.push_back({"samples", kCitykilnUint, image.samples.data(), 1});
  channels.push_back({"variance", kCitykilnFloat, guides.variance.data(), 1});
  return channels;
}

std::vector<std::uint8_t> dithered_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.rgb.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + x) * 3;
      for (const std::uint8_t byte : tone_map(std::span<const float, 3>(&image.rgb[first], 3), dither_at(x, y)))
        bytes.push_back(byte);
    }
  return bytes;
}

Result<Done> write_part(const std::string& part, const Image& image, const std::vector<CitykilnChannel>& channels,
                        const std::vector<Metadata>& metadata) {
  const auto function = load_function("citykiln_image.so", "citykiln_write_picture");
  if (!function) return function.error();
  std::vector<const char*> texts = {"Copyright", kCredit, "Software", "citykiln"};
  for (const Metadata& fact : metadata) texts.push_back(fact.name.c_str()), texts.push_back(fact.value.c_str());
  const CitykilnPicture picture{.width = image.width,
                                .height = image.height,
                                .channel_count = static_cast<int>(channels.size()),
                                .channels = channels.data(),
                                .text_count = static_cast<int>(texts.size() / 2),
                                .texts = texts.data()};
  char error[512] = "";
  const auto write = reinterpret_cast<decltype(&citykiln_write_picture)>(*function);
  if (write(part.c_str(), &picture, error, sizeof error) == 0) return Done{};
  return Error{"", error};
}

}  // namespace

Result<Done> write_image(const Image& image, const std::string& path, const std::vector<Metadata>& metadata) {
  const bool is_exr = path.ends_with(".exr");
  if (!is_exr && !path.ends_with(".png")) return Error{path, "expected a name that ends in .png or .exr"};
  const IdChannels ids = id_channels(is_exr ? image.guides.feature : std::vector<OsmId>{});
  const std::vector<std::uint8_t> bytes = is_exr ? std::vector<std::uint8_t>{} : dithered_bytes(image);
  std::vector<CitykilnChannel> channels;
  if (is_exr)
    channels = exr_channels(image, ids);
  else
    channels = {
        {"R", kCitykilnByte, &bytes[0], 3}, {"G", kCitykilnByte, &bytes[1], 3}, {"B", kCitykilnByte, &bytes[2], 3}};
  // a temporary name with the same extension, renamed at the end
  const std::string part = path.substr(0, path.size() - 4) + ".part" + path.substr(path.size() - 4);
  if (const Result<Done> written = write_part(part, image, channels, metadata); !written) {
    std::remove(part.c_str());
    if (!written.error().where.empty()) return written;
    return Error{path, "cannot be written: " + written.error().message};
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());
    return Error{path, "cannot be written: the finished picture could not be renamed"};
  }
  return Done{};
}

}  // namespace citykiln::preview
