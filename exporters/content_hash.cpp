#include "exporters/content_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace citykiln::exporters {
namespace {

static_assert(std::endian::native == std::endian::little, "words are read as they lie in memory");

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87u, kPrime2 = 0xC2B2AE3D27D4EB4Fu, kPrime3 = 0x165667B19E3779F9u,
                        kPrime4 = 0x85EBCA77C2B2AE63u, kPrime5 = 0x27D4EB2F165667C5u;
constexpr std::size_t kStripe = 32;

template <typename Word>
std::uint64_t word_at(const std::byte* at) {
  Word word;
  std::memcpy(&word, at, sizeof word);
  return word;
}

std::uint64_t mixed_lane(std::uint64_t lane, std::uint64_t word) {
  return std::rotl(lane + word * kPrime2, 31) * kPrime1;
}

using Lanes = std::array<std::uint64_t, 4>;

constexpr Lanes kFirstLanes = {kPrime1 + kPrime2, kPrime2, 0, 0 - kPrime1};

/// Mixes all whole stripes, and removes them from the span.
Lanes take_stripes(Lanes lanes, std::span<const std::byte>& bytes) {
  for (; bytes.size() >= kStripe; bytes = bytes.subspan(kStripe))
    for (std::size_t i = 0; i < 4; ++i) lanes[i] = mixed_lane(lanes[i], word_at<std::uint64_t>(bytes.data() + 8 * i));
  return lanes;
}

std::uint64_t joined_lanes(const Lanes& lanes) {
  std::uint64_t hash =
      std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
  for (const std::uint64_t lane : lanes) hash = (hash ^ mixed_lane(0, lane)) * kPrime1 + kPrime4;
  return hash;
}

/// Mixes the last bytes, fewer than a stripe.
std::uint64_t take_rest(std::uint64_t hash, std::span<const std::byte> bytes) {
  for (; bytes.size() >= 8; bytes = bytes.subspan(8))
    hash = std::rotl(hash ^ mixed_lane(0, word_at<std::uint64_t>(bytes.data())), 27) * kPrime1 + kPrime4;
  for (; bytes.size() >= 4; bytes = bytes.subspan(4))
    hash = std::rotl(hash ^ word_at<std::uint32_t>(bytes.data()) * kPrime1, 23) * kPrime2 + kPrime3;
  for (const std::byte byte : bytes) hash = std::rotl(hash ^ static_cast<std::uint64_t>(byte) * kPrime5, 11) * kPrime1;
  return hash;
}

/// @param rest  The bytes after the last whole stripe.
std::uint64_t finished_hash(const Lanes& lanes, std::uint64_t size, std::span<const std::byte> rest) {
  std::uint64_t hash = take_rest((size >= kStripe ? joined_lanes(lanes) : kPrime5) + size, rest);
  hash = (hash ^ hash >> 33) * kPrime2;
  hash = (hash ^ hash >> 29) * kPrime3;
  return hash ^ hash >> 32;
}

}  // namespace

std::uint64_t content_hash(std::span<const std::byte> bytes) {
  const std::uint64_t size = bytes.size();
  const Lanes lanes = take_stripes(kFirstLanes, bytes);
  return finished_hash(lanes, size, bytes);
}

std::uint64_t content_hash(std::string_view text) { return content_hash(std::as_bytes(std::span(text))); }

ContentHasher::ContentHasher() : lanes_(kFirstLanes) {}

void ContentHasher::add(std::span<const std::byte> bytes) {
  const std::size_t before = size_ % kStripe;
  size_ += bytes.size();
  if (before > 0) {
    const std::size_t filled = std::min(kStripe - before, bytes.size());
    std::ranges::copy(bytes.first(filled), rest_.begin() + static_cast<std::ptrdiff_t>(before));
    bytes = bytes.subspan(filled);
    if (before + filled < kStripe) return;
    std::span<const std::byte> stripe = rest_;
    lanes_ = take_stripes(lanes_, stripe);
  }
  lanes_ = take_stripes(lanes_, bytes);
  std::ranges::copy(bytes, rest_.begin());
}

std::uint64_t ContentHasher::value() const {
  return finished_hash(lanes_, size_, std::span(rest_).first(size_ % kStripe));
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace citykiln::exporters
