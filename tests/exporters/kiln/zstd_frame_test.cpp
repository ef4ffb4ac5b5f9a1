#include "exporters/kiln/zstd_frame.h"

#include <gtest/gtest.h>

#include <random>

namespace citykiln::exporters {
namespace {

using RawBytes = std::vector<std::uint8_t>;

// Samples that share much of their content, as chunks do.
std::vector<RawBytes> samples(std::size_t count, std::size_t words) {
  std::mt19937_64 dice(7);
  std::vector<RawBytes> all(count);
  for (RawBytes& sample : all)
    for (std::size_t i = 0; i < words; ++i) {
      const std::uint64_t word = dice() % 300;
      for (std::uint64_t b = 0; b < 9; ++b) sample.push_back(static_cast<std::uint8_t>((word + 1) * (b * b + 3)));
      sample.push_back(static_cast<std::uint8_t>(dice()));
    }
  return all;
}

std::size_t total(const std::vector<RawBytes>& all) {
  std::size_t size = 0;
  for (const RawBytes& one : all) size += one.size();
  return size;
}

std::size_t packed_size(const std::vector<RawBytes>& all, const RawBytes& dictionary) {
  std::size_t size = packed(dictionary, nullptr).size();
  const auto ready = packing_dictionary(dictionary);
  for (const RawBytes& one : all) size += packed(one, ready).size();
  return size;
}

TEST(ZstdFrame, UnpacksToWhatWasPacked) {
  const auto all = samples(80, 40);
  const RawBytes dictionary = train_dictionary(all);
  ASSERT_FALSE(dictionary.empty());
  for (const RawBytes& with : {RawBytes(), dictionary}) {
    const auto packing = packing_dictionary(with);
    const auto unpacking = unpacking_dictionary(with);
    for (const RawBytes& raw : {RawBytes(), RawBytes{1}, all[0], all[79]}) {
      const auto back = unpacked(packed(raw, packing), unpacking, "here");
      ASSERT_TRUE(back);
      EXPECT_EQ(*back, raw);
    }
  }
}

// A frame of no bytes, by hand: its header states how many there are.
TEST(ZstdFrame, SizesBeyondBeliefAreRefused) {
  std::vector<std::byte> frame;
  for (const int b : {0x28, 0xb5, 0x2f, 0xfd, 0xe0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0})
    frame.push_back(static_cast<std::byte>(b));
  const auto refused = unpacked(frame, nullptr, "here");
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()), "here: expected at most 268435456 bytes unpacked, found 1099511627776");
}

TEST(ZstdFrame, SizesThatAreNotStatedAreRefused) {
  std::vector<std::byte> frame;
  for (const int b : {0x28, 0xb5, 0x2f, 0xfd, 0x00, 0x00, 1, 0, 0}) frame.push_back(static_cast<std::byte>(b));
  const auto refused = unpacked(frame, nullptr, "here");
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()), "here: expected a zstd frame that states its size");
}

TEST(ZstdFrame, EveryTruncationIsRefused) {
  const auto frame = packed(samples(1, 40)[0], nullptr);
  ASSERT_FALSE(frame.empty());
  for (std::size_t size = 0; size < frame.size(); ++size)
    EXPECT_FALSE(unpacked(std::span(frame).first(size), nullptr, "here")) << size;
}

TEST(ZstdDictionary, ItGainsMoreThanItTakes) {
  for (const std::size_t words : {5u, 40u, 400u}) {
    const auto all = samples(64, words);
    EXPECT_LE(packed_size(all, train_dictionary(all)), packed_size(all, {})) << words;
  }
}

TEST(ZstdDictionary, IsASixtyFourthAndAtMostThirtyTwoKilobytes) {
  for (const std::size_t words : {40u, 400u, 8000u}) {
    const auto all = samples(64, words);
    const std::size_t size = train_dictionary(all).size();
    EXPECT_GT(size, 0u);
    EXPECT_LE(size, std::min<std::size_t>(total(all) / 64, 32768));
  }
}

TEST(ZstdDictionary, FewSamplesOrEmptyOnesMakeNone) {
  EXPECT_TRUE(train_dictionary(samples(63, 40)).empty());
  EXPECT_TRUE(train_dictionary(samples(64, 0)).empty());
  EXPECT_TRUE(train_dictionary({}).empty());
}

TEST(ZstdDictionary, SameSamplesSameBytes) {
  EXPECT_EQ(train_dictionary(samples(80, 40)), train_dictionary(samples(80, 40)));
}

TEST(ZstdDictionary, BytesThatAreNoneAreRefused) {
  EXPECT_EQ(unpacking_dictionary({}), nullptr);
  EXPECT_EQ(unpacking_dictionary(RawBytes(1000, 1)), nullptr);
}

}  // namespace
}  // namespace citykiln::exporters
