#include "preview/samples.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace citykiln::preview {
namespace {

// David Stafford's 13th variant of MurmurHash3's finaliser (2011).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Moves the bits of x to the even positions.
std::uint64_t spread_32_bits(std::uint32_t x) {
  std::uint64_t v = x;
  v = (v | (v << 16)) & 0x0000ffff0000ffffu;
  v = (v | (v << 8)) & 0x00ff00ff00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0f0f0f0f0fu;
  v = (v | (v << 2)) & 0x3333333333333333u;
  return (v | (v << 1)) & 0x5555555555555555u;
}

std::uint32_t reversed(std::uint32_t v) {
  v = __builtin_bswap32(v);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v >> 4) & 0x0f0f0f0fu);
  v = ((v & 0x33333333u) << 2) | ((v >> 2) & 0x33333333u);
  return ((v & 0x55555555u) << 1) | ((v >> 1) & 0x55555555u);
}

// Columns of Sobol's second matrix, Pascal's triangle modulo 2, to 64 columns: pictures times samples pass 2^32.
constexpr std::array<std::uint32_t, 64> kSecond = [] {
  std::array<std::uint32_t, 64> columns{};
  std::uint64_t column = std::uint64_t{1} << 63;
  for (std::uint32_t& c : columns) {
    c = static_cast<std::uint32_t>(column >> 32);
    column ^= column >> 1;
  }
  return columns;
}();

// For each byte of an index, the sum (exclusive or) of the columns that its bits select.
constexpr std::array<std::array<std::uint32_t, 256>, 6> kSecondByByte = [] {
  std::array<std::array<std::uint32_t, 256>, 6> tables{};
  for (std::size_t byte = 0; byte < tables.size(); ++byte)
    for (std::size_t value = 0; value < 256; ++value)
      for (std::size_t bit = 0; bit < 8; ++bit)
        if ((value >> bit & 1) != 0) tables[byte][value] ^= kSecond[8 * byte + bit];
  return tables;
}();

std::uint32_t second_sobol(std::uint64_t index) {
  assert(index >> 48 == 0);
  std::uint32_t v = 0;
  for (std::size_t byte = 0; index != 0; ++byte, index >>= 8) v ^= kSecondByByte[byte][index & 0xff];
  return v;
}

// Owen scrambling of binary digits, given in reverse, by a hash in which each bit depends only on those above it.
double scrambled(std::uint32_t v, std::uint32_t key) {
  v ^= v * 0x3d20adeau;
  v += key;
  v *= (key >> 16) | 1;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return reversed(v) * 0x1p-32;
}

// Permutes a digit 0 … 3 by one of the 24 permutations of four.
std::uint64_t shuffled(std::uint64_t digit, std::uint64_t hash) {
  constexpr std::array<std::uint8_t, 24> kOrders = {0xe4, 0xb4, 0xd8, 0x78, 0x9c, 0x6c, 0xe1, 0xb1,
                                                    0xc9, 0x39, 0x8d, 0x2d, 0xd2, 0x72, 0xc6, 0x36,
                                                    0x4e, 0x1e, 0x93, 0x63, 0x87, 0x27, 0x4b, 0x1b};
  return (kOrders[(hash >> 32) % 24] >> (2 * digit)) & 3;
}

int log2_up(int n) { return std::bit_width(static_cast<unsigned>(std::max(n, 1)) - 1); }

std::uint64_t key_of(std::uint64_t seed, std::uint32_t dimension) {
  return mix(seed + 0x9e3779b97f4a7c15u * (dimension + 1));
}

}  // namespace

SampleGrid grid_of(int width, int height, int samples) { return {log2_up(std::max(width, height)), log2_up(samples)}; }

PixelSamples::PixelSamples(std::uint64_t seed, std::uint32_t x, std::uint32_t y, SampleGrid grid)
    : seed_(seed), morton_(spread_32_bits(x) | (spread_32_bits(y) << 1)), grid_(grid) {}

std::uint64_t PixelSamples::place(std::uint32_t dimension) const {
  static_assert(kOrdered <= 32);
  std::uint64_t& place = places_[dimension];
  if ((found_ >> dimension & 1) != 0) return place;
  found_ |= 1u << dimension;
  place = 0;
  const std::uint64_t key = key_of(seed_, dimension);
  for (int digit = grid_.log2_side - 1; digit >= 0; --digit) {
    const std::uint64_t value = (morton_ >> (2 * digit)) & 3, above = morton_ >> (2 * digit + 2);
    place |= shuffled(value, mix(above ^ key)) << (2 * digit);
  }
  return place;
}

UnitPair PixelSamples::pair(std::uint32_t sample, std::uint32_t dimension) const {
  const std::uint64_t key = key_of(seed_, dimension);
  const std::uint64_t whole = (morton_ << grid_.log2_samples) | sample;
  if (dimension >= kOrdered) {
    const std::uint64_t h = mix(whole ^ key);
    return {static_cast<double>(h >> 32) * 0x1p-32, static_cast<double>(h & 0xffffffffu) * 0x1p-32};
  }
  std::uint64_t index = place(dimension) << grid_.log2_samples;
  int shift = grid_.log2_samples - 2;
  for (; shift >= 0; shift -= 2) index |= shuffled((sample >> shift) & 3, mix((whole >> (shift + 2)) ^ key)) << shift;
  // an odd power of two leaves one bit
  if (shift == -1) index |= (sample & 1) ^ (mix((whole >> 1) ^ key) & 1);
  return {scrambled(static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(key)),
          scrambled(reversed(second_sobol(index)), static_cast<std::uint32_t>(key >> 32))};
}

}  // namespace citykiln::preview
