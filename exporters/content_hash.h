// A fast 64-bit hash of bytes, XXH64. It detects damage and distinguishes contents; it does not prevent forgery.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace citykiln::exporters {

/// Returns XXH64 with seed 0. Two different contents have the same hash with probability 2^-64. Cost: several GB/s.
/// Source: Yann Collet, "xxHash fast digest algorithm", specification 0.2.0; other programs (`xxhsum -H1`) give the
/// same value.
std::uint64_t content_hash(std::span<const std::byte> bytes);
std::uint64_t content_hash(std::string_view text);

/// Hashes bytes that come in pieces: value() is content_hash() of all pieces in a row, however they are cut.
class ContentHasher {
 public:
  ContentHasher();
  void add(std::span<const std::byte> bytes);
  std::uint64_t value() const;

 private:
  static constexpr std::size_t kStripe = 32;

  std::array<std::uint64_t, 4> lanes_;
  std::array<std::byte, kStripe> rest_{};  ///< The bytes after the last whole stripe.
  std::uint64_t size_ = 0;                 ///< The number of all bytes.
};

/// Returns a hash as 16 hexadecimal digits, as `xxhsum -H1` prints it.
std::string hash_text(std::uint64_t hash);

}  // namespace citykiln::exporters
