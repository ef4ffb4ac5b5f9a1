#include "compiler/invent/write/encode_heights.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace citykiln::invent {
namespace {

enum class FieldType : std::uint16_t { kText = 2, kShort = 3, kLong = 4, kDouble = 12 };

/// A TIFF file of one picture, little-endian: header, directory, long values, samples.
class Tiff {
 public:
  void add_short(std::uint16_t tag, std::uint16_t value) { add(tag, FieldType::kShort, 1, bytes_of_value(value)); }
  void add_long(std::uint16_t tag, std::uint32_t value) { add(tag, FieldType::kLong, 1, bytes_of_value(value)); }
  void add_shorts(std::uint16_t tag, const std::vector<std::uint16_t>& values) {
    add(tag, FieldType::kShort, values.size(), bytes_of_values(values));
  }
  void add_doubles(std::uint16_t tag, const std::vector<double>& values) {
    add(tag, FieldType::kDouble, values.size(), bytes_of_values(values));
  }
  void add_text(std::uint16_t tag, std::string_view text) {
    std::vector<std::byte> bytes(text.size() + 1);
    std::memcpy(bytes.data(), text.data(), text.size());
    add(tag, FieldType::kText, bytes.size(), bytes);
  }

  /// The file, with samples at its end. Fields must have been added by rising tags, and one of them is `offset_tag`, a
  /// long that will say where the samples begin.
  std::vector<std::byte> with_samples(std::uint16_t offset_tag, const std::vector<float>& samples) {
    const std::size_t directory_end = 8 + 2 + fields_.size() * 12 + 4;
    std::size_t long_bytes = 0;
    for (const Field& field : fields_)
      if (field.bytes.size() > 4) long_bytes += padded(field.bytes.size());
    std::vector<std::byte> file = begin_file();
    std::vector<std::byte> values;
    for (Field& field : fields_) {
      if (field.tag == offset_tag) field.bytes = bytes_of_value(static_cast<std::uint32_t>(directory_end + long_bytes));
      append_field(file, values, field, directory_end);
    }
    append(file, bytes_of_value(std::uint32_t{0}));
    append(file, values);
    append(file, bytes_of_values(samples));
    return file;
  }

 private:
  struct Field {
    std::uint16_t tag;
    FieldType type;
    std::uint32_t count;
    std::vector<std::byte> bytes;
  };

  static std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }
  static void append(std::vector<std::byte>& to, const std::vector<std::byte>& bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
  }
  template <typename T>
  static std::vector<std::byte> bytes_of_values(const std::vector<T>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
  }
  template <typename T>
  static std::vector<std::byte> bytes_of_value(T value) {
    return bytes_of_values(std::vector<T>{value});
  }

  void add(std::uint16_t tag, FieldType type, std::size_t count, std::vector<std::byte> bytes) {
    fields_.push_back({tag, type, static_cast<std::uint32_t>(count), std::move(bytes)});
  }

  std::vector<std::byte> begin_file() const {
    std::vector<std::byte> file = {std::byte{'I'}, std::byte{'I'}, std::byte{42}, std::byte{0}};
    append(file, bytes_of_value(std::uint32_t{8}));
    append(file, bytes_of_value(static_cast<std::uint16_t>(fields_.size())));
    return file;
  }

  static void append_field(std::vector<std::byte>& file, std::vector<std::byte>& values, const Field& field,
                           std::size_t directory_end) {
    append(file, bytes_of_value(field.tag));
    append(file, bytes_of_value(static_cast<std::uint16_t>(field.type)));
    append(file, bytes_of_value(field.count));
    std::vector<std::byte> in_place = field.bytes;
    if (field.bytes.size() > 4) {
      in_place = bytes_of_value(static_cast<std::uint32_t>(directory_end + values.size()));
      append(values, field.bytes);
      values.resize(padded(values.size()));
    }
    in_place.resize(4);
    append(file, in_place);
  }

  std::vector<Field> fields_;
};

/// Keys of a transverse Mercator projection of WGS84 in metres: key, place of the value (0: here, else the tag of
/// doubles), count, value or index.
std::vector<std::uint16_t> projection_keys() {
  constexpr std::uint16_t kDoubles = 34736, kUserDefined = 32767;
  return {1,    1,        0, 14,
          1024, 0,        1, 1,              // a projected system
          1025, 0,        1, 2,              // samples are points
          2048, 0,        1, 4326,           // WGS84
          2054, 0,        1, 9102,           // degrees
          3072, 0,        1, kUserDefined,   // a system of our own
          3074, 0,        1, kUserDefined,   // a projection of our own
          3075, 0,        1, 1,              // transverse Mercator
          3076, 0,        1, 9001,           // metres
          3080, kDoubles, 1, 0,              // the middle's longitude
          3081, kDoubles, 1, 1,              // the middle's latitude
          3082, kDoubles, 1, 2,              // false easting
          3083, kDoubles, 1, 3,              // false northing
          3092, kDoubles, 1, 4,              // scale
          4096, 0,        1, kUserDefined};  // the world's own heights
}

std::vector<float> rows_from_north(const Terrain& terrain) {
  std::vector<float> samples;
  samples.reserve(terrain.heights_m.size());
  const std::size_t count = static_cast<std::size_t>(terrain.cells) + 1;
  for (std::size_t row = count; row-- > 0;)
    samples.insert(samples.end(), terrain.heights_m.begin() + static_cast<std::ptrdiff_t>(row * count),
                   terrain.heights_m.begin() + static_cast<std::ptrdiff_t>((row + 1) * count));
  return samples;
}

}  // namespace

std::vector<std::byte> encode_heights(const Terrain& terrain, const WorldPlace& place) {
  const std::uint32_t count = static_cast<std::uint32_t>(terrain.cells) + 1;
  const double step_m = terrain.step_m(), half_m = terrain.side_m / 2;
  const std::vector<double> projection = {place.middle().lon_deg, place.middle().lat_deg, 0, 0, 1};
  Tiff tiff;
  tiff.add_long(256, count);  // width
  tiff.add_long(257, count);  // height
  tiff.add_short(258, 32);    // bits of a sample
  tiff.add_short(259, 1);     // no compression
  tiff.add_short(262, 1);     // black is zero
  tiff.add_long(273, 0);      // where samples begin, known when all fields are
  tiff.add_short(277, 1);     // samples of a pixel
  tiff.add_long(278, count);  // rows of a strip
  tiff.add_long(279, count * count * 4);
  tiff.add_short(339, 3);  // floats
  tiff.add_doubles(33550, {step_m, step_m, 0});
  tiff.add_doubles(33922, {0, 0, 0, -half_m, half_m, 0});
  tiff.add_shorts(34735, projection_keys());
  tiff.add_doubles(34736, projection);
  return tiff.with_samples(273, rows_from_north(terrain));
}

}  // namespace citykiln::invent
