// Streams of variable-length integers. A manifest has one stream for each property, which keeps it small and safe to
// read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace citykiln::exporters {

/// Writes integers as LEB128: seven bits per byte, least significant first; signed ones in zigzag order.
class StreamWriter {
 public:
  void put(std::uint64_t value);
  void put_signed(std::int64_t value);
  /// Writes the difference to the value of the last put_delta(), at first to 0.
  void put_delta(std::int64_t value);
  /// Writes bytes as they are.
  void put_bytes(std::string_view bytes);
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::int64_t last_ = 0;
};

/// Reads the streams that StreamWriter writes. Past the end, and for numbers beyond 64 bits, functions return 0 and
/// good() is false.
class StreamReader {
 public:
  StreamReader() = default;
  explicit StreamReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t get();
  std::int64_t get_signed();
  std::int64_t get_delta();
  /// Returns the next bytes; empty if fewer remain.
  std::string_view get_bytes(std::uint64_t count);
  std::size_t remaining() const { return bytes_.size() - at_; }
  bool good() const { return good_; }
  bool is_finished() const { return good_ && remaining() == 0; }

 private:
  std::uint8_t get_byte();

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::int64_t last_ = 0;
  bool good_ = true;
};

}  // namespace citykiln::exporters
