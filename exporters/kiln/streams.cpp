#include "exporters/kiln/streams.h"

namespace citykiln::exporters {
namespace {

// Differences wrap around, so that no file can cause signed overflow.
std::int64_t wrapping_sum(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
std::int64_t wrapping_difference(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

}  // namespace

void StreamWriter::put(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes_.push_back(static_cast<std::uint8_t>(value | 0x80));
  bytes_.push_back(static_cast<std::uint8_t>(value));
}

void StreamWriter::put_signed(std::int64_t value) {
  put(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
}

void StreamWriter::put_delta(std::int64_t value) {
  put_signed(wrapping_difference(value, last_));
  last_ = value;
}

void StreamWriter::put_bytes(std::string_view bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

std::uint8_t StreamReader::get_byte() {
  if (at_ >= bytes_.size()) {
    good_ = false;
    return 0;
  }
  return bytes_[at_++];
}

std::uint64_t StreamReader::get() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint8_t byte = get_byte();
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return value;
  }
  good_ = false;
  return 0;
}

std::int64_t StreamReader::get_signed() {
  const std::uint64_t value = get();
  return static_cast<std::int64_t>(value >> 1 ^ (~(value & 1) + 1));
}

std::string_view StreamReader::get_bytes(std::uint64_t count) {
  if (count > remaining()) return good_ = false, std::string_view();
  const auto* first = reinterpret_cast<const char*>(bytes_.data() + at_);
  at_ += static_cast<std::size_t>(count);
  return {first, static_cast<std::size_t>(count)};
}

std::int64_t StreamReader::get_delta() { return last_ = wrapping_sum(last_, get_signed()); }

}  // namespace citykiln::exporters
