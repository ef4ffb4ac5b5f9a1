// Numbers as runs of variable-length integers, one run a property: what makes a manifest small, and safe to read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace citykiln::exporters {

/// Writes integers, seven bits a byte, least first (LEB128); signed ones zigzag.
class StreamWriter {
 public:
  void put(std::uint64_t value);
  void put_signed(std::int64_t value);
  /// The difference to the number put last by put_delta.
  void put_delta(std::int64_t value);
  void put_double(double value);  ///< Eight bytes, little end first.
  void put_byte(std::uint8_t value) { bytes_.push_back(value); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::int64_t last_ = 0;
};

/// Reads what StreamWriter wrote. Beyond the end, or in nonsense, it gives zeros and is no longer good().
class StreamReader {
 public:
  StreamReader() = default;
  explicit StreamReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t get();
  std::int64_t get_signed();
  std::int64_t get_delta();
  double get_double();
  std::uint8_t get_byte();
  /// A count of things that take at least one byte each of this stream or of `of`: never more than there is.
  std::size_t get_count(const StreamReader& of);
  std::size_t get_count() { return get_count(*this); }
  std::size_t remaining() const { return bytes_.size() - at_; }
  bool good() const { return good_; }
  bool is_finished() const { return good_ && remaining() == 0; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::int64_t last_ = 0;
  bool good_ = true;
};

}  // namespace citykiln::exporters
