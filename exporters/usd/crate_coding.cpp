#include "exporters/usd/crate_coding.h"

#include <lz4.h>

#include <algorithm>
#include <cassert>
#include <cstring>

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;

// A difference has 0, 1, 2 or 4 bytes.
constexpr std::size_t kCodeBytes[] = {0, 1, 2, 4};

std::vector<std::int32_t> differences(std::span<const std::int32_t> numbers) {
  std::vector<std::int32_t> out;
  out.reserve(numbers.size());
  std::uint32_t last = 0;
  for (const std::int32_t number : numbers) {
    out.push_back(static_cast<std::int32_t>(static_cast<std::uint32_t>(number) - last));
    last = static_cast<std::uint32_t>(number);
  }
  return out;
}

// Among equally common values it is the largest.
std::int32_t commonest(std::vector<std::int32_t> values) {
  std::ranges::sort(values);
  std::int32_t best = 0;
  std::size_t most = 0;
  for (auto at = values.begin(); at != values.end();) {
    const auto end = std::find_if(at, values.end(), [&](std::int32_t v) { return v != *at; });
    if (static_cast<std::size_t>(end - at) >= most) most = static_cast<std::size_t>(end - at), best = *at;
    at = end;
  }
  return best;
}

unsigned code_of(std::int32_t difference, std::int32_t common) {
  if (difference == common) return 0;
  if (difference >= -128 && difference <= 127) return 1;
  return difference >= -32768 && difference <= 32767 ? 2 : 3;
}

// Little-endian.
void put_code(Bytes& out, std::int32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    out.push_back(static_cast<std::byte>(static_cast<std::uint32_t>(value) >> 8 * i));
}

std::size_t code_bytes(std::size_t count) { return (2 * count + 7) / 8; }

Bytes encode(std::span<const std::int32_t> numbers) {
  const std::vector<std::int32_t> steps = differences(numbers);
  const std::int32_t common = commonest(steps);
  Bytes out(4 + code_bytes(steps.size()));
  std::memcpy(out.data(), &common, sizeof common);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const unsigned code = code_of(steps[i], common);
    out[4 + i / 4] |= static_cast<std::byte>(code << 2 * (i % 4));
    put_code(out, steps[i], kCodeBytes[code]);
  }
  return out;
}

std::int32_t number_at(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  const unsigned unused = 32 - 8 * static_cast<unsigned>(bytes.size());
  return static_cast<std::int32_t>(value << unused) >> unused;  // extends the sign
}

// The message says what was expected.
Error damaged() { return {"", "packed values that give as many as it says"}; }

}  // namespace

Bytes compress_bytes(std::span<const std::byte> bytes) {
  assert(bytes.size() < std::size_t{1} << 30);
  const int size = static_cast<int>(bytes.size());
  Bytes out(1 + static_cast<std::size_t>(LZ4_compressBound(size)));
  const int packed =
      LZ4_compress_default(reinterpret_cast<const char*>(bytes.data()), reinterpret_cast<char*>(out.data() + 1), size,
                           static_cast<int>(out.size() - 1));
  assert(packed > 0);
  out.resize(1 + static_cast<std::size_t>(packed));
  return out;
}

Bytes compress_integers(std::span<const std::int32_t> numbers) { return compress_bytes(encode(numbers)); }

Result<Bytes> decompress_bytes(std::span<const std::byte> packed, std::size_t size) {
  // a block of LZ4 grows by at most 255 times, and a little
  if (packed.empty() || packed[0] != std::byte{0} || size > 255 * packed.size() + 64 || size >= std::size_t{1} << 30)
    return damaged();
  Bytes out(size);
  const int read =
      LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data() + 1), reinterpret_cast<char*>(out.data()),
                          static_cast<int>(packed.size() - 1), static_cast<int>(size));
  if (read < 0 || static_cast<std::size_t>(read) > size) return damaged();
  out.resize(static_cast<std::size_t>(read));
  return out;
}

Result<std::vector<std::int32_t>> decompress_integers(std::span<const std::byte> packed, std::size_t count) {
  // a number takes two bits at least, before LZ4
  if (count / 4 > 256 * packed.size() || count >= std::size_t{1} << 28) return damaged();
  const std::size_t first = 4 + code_bytes(count);
  const Result<Bytes> coded = decompress_bytes(packed, std::min(first + 4 * count, 255 * packed.size() + 64));
  if (!coded) return coded.error();
  if (coded->size() < first) return damaged();
  const std::span<const std::byte> bytes = *coded;
  const std::int32_t common = number_at(bytes.first(4));
  std::vector<std::int32_t> numbers;
  std::size_t at = first;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = kCodeBytes[std::to_integer<unsigned>(bytes[4 + i / 4]) >> 2 * (i % 4) & 3];
    if (size > bytes.size() - at) return damaged();
    last += static_cast<std::uint32_t>(size == 0 ? common : number_at(bytes.subspan(at, size)));
    numbers.push_back(static_cast<std::int32_t>(last));
    at += size;
  }
  if (at != bytes.size()) return damaged();
  return numbers;
}

}  // namespace citykiln::exporters
