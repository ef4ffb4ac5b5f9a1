#include "exporters/content_hash.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <span>

namespace citykiln::exporters {
namespace {

// printed by xxhsum -H1 0.8.1
TEST(ContentHash, IsXxh64) {
  std::string long_text;
  for (int i = 0; i < 9; ++i) long_text += "0123456789abcdef";
  EXPECT_EQ(hash_text(content_hash("")), "ef46db3751d8e999");
  EXPECT_EQ(hash_text(content_hash("a")), "d24ec4f1a98c6e5b");
  EXPECT_EQ(hash_text(content_hash("abc")), "44bc2cf5ad770999");
  EXPECT_EQ(hash_text(content_hash("Nobody inspects the spammish repetition")), "fbcea83c8a378bf1");
  EXPECT_EQ(hash_text(content_hash(long_text + "xyz")), "843d82a25e1d1865");
}

TEST(ContentHash, TellsEveryChangedBitApart) {
  const std::string text(100, 'k');
  std::set<std::uint64_t> hashes = {content_hash(text)};
  for (std::size_t bit = 0; bit < 800; ++bit) {
    std::string changed = text;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ 1 << bit % 8);
    hashes.insert(content_hash(changed));
  }
  EXPECT_EQ(hashes.size(), 801u);
}

TEST(ContentHash, IsTheSameInPieces) {
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    std::string text(random() % 300, ' ');
    for (char& letter : text) letter = static_cast<char>(random());
    ContentHasher hasher;
    for (std::size_t at = 0; at < text.size();) {
      const std::string piece = text.substr(at, random() % 80);
      hasher.add(std::as_bytes(std::span(piece)));
      at += piece.size();
    }
    EXPECT_EQ(hasher.value(), content_hash(text)) << text.size();
  }
}

}  // namespace
}  // namespace citykiln::exporters
