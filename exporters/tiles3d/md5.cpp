#include "exporters/tiles3d/md5.h"

#include <bit>
#include <cstdint>
#include <string>

namespace citykiln::exporters {
namespace {

using Md5State = std::array<std::uint32_t, 4>;

constexpr std::size_t kBlock = 64, kLengthBytes = 8;
constexpr Md5State kFirstState = {0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
/// The first 32 bits of the fractions of |sin(1)|, |sin(2)| … (radians).
constexpr std::array<std::uint32_t, 64> kSines = {
    0xd76aa478, 0xe8c7b756, 0x242070db, 0xc1bdceee, 0xf57c0faf, 0x4787c62a, 0xa8304613, 0xfd469501,
    0x698098d8, 0x8b44f7af, 0xffff5bb1, 0x895cd7be, 0x6b901122, 0xfd987193, 0xa679438e, 0x49b40821,
    0xf61e2562, 0xc040b340, 0x265e5a51, 0xe9b6c7aa, 0xd62f105d, 0x02441453, 0xd8a1e681, 0xe7d3fbc8,
    0x21e1cde6, 0xc33707d6, 0xf4d50d87, 0x455a14ed, 0xa9e3e905, 0xfcefa3f8, 0x676f02d9, 0x8d2a4c8a,
    0xfffa3942, 0x8771f681, 0x6d9d6122, 0xfde5380c, 0xa4beea44, 0x4bdecfa9, 0xf6bb4b60, 0xbebfbc70,
    0x289b7ec6, 0xeaa127fa, 0xd4ef3085, 0x04881d05, 0xd9d4d039, 0xe6db99e5, 0x1fa27cf8, 0xc4ac5665,
    0xf4292244, 0x432aff97, 0xab9423a7, 0xfc93a039, 0x655b59c3, 0x8f0ccc92, 0xffeff47d, 0x85845dd1,
    0x6fa87e4f, 0xfe2ce6e0, 0xa3014314, 0x4e0811a1, 0xf7537e82, 0xbd3af235, 0x2ad7d2bb, 0xeb86d391};
/// Rotations, four in each of the four rounds, in bits.
constexpr int kTurns[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};

std::uint32_t md5_word(std::string_view bytes, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[4 * word + i])) << 8 * i;
  return value;
}

/// The function of a round.
std::uint32_t mixed_words(std::size_t round, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  if (round == 0) return (b & c) | (~b & d);
  if (round == 1) return (b & d) | (c & ~d);
  return round == 2 ? b ^ c ^ d : c ^ (b | ~d);
}

/// The word of a block that a step reads.
std::size_t word_of_step(std::size_t step) {
  constexpr std::size_t kFactors[4] = {1, 5, 3, 7}, kFirst[4] = {0, 1, 5, 0};
  return (kFactors[step / 16] * step + kFirst[step / 16]) % 16;
}

Md5State after_block(const Md5State& before, std::string_view block) {
  auto [a, b, c, d] = before;
  for (std::size_t step = 0; step < kBlock; ++step) {
    const std::uint32_t sum = a + mixed_words(step / 16, b, c, d) + md5_word(block, word_of_step(step)) + kSines[step];
    a = d, d = c, c = b;
    b += std::rotl(sum, kTurns[step / 16][step % 4]);
  }
  return {before[0] + a, before[1] + b, before[2] + c, before[3] + d};
}

/// The text with a bit, zeros and its length in bits, to whole blocks.
std::string padded_text(std::string_view text) {
  std::string padded = std::string(text) + '\x80';
  padded.resize((padded.size() + kLengthBytes + kBlock - 1) / kBlock * kBlock - kLengthBytes);
  for (std::size_t i = 0; i < kLengthBytes; ++i)
    padded += static_cast<char>(static_cast<std::uint64_t>(text.size()) * 8 >> 8 * i & 0xff);
  return padded;
}

}  // namespace

std::array<std::byte, 16> md5(std::string_view text) {
  const std::string padded = padded_text(text);
  Md5State state = kFirstState;
  for (std::size_t at = 0; at < padded.size(); at += kBlock)
    state = after_block(state, std::string_view(padded).substr(at, kBlock));
  std::array<std::byte, 16> digest{};
  for (std::size_t i = 0; i < digest.size(); ++i) digest[i] = static_cast<std::byte>(state[i / 4] >> 8 * (i % 4));
  return digest;
}

}  // namespace citykiln::exporters
