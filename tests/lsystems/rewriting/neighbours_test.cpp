#include "lsystems/rewriting/neighbours.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

// ---- the same by walking along the string, letter by letter ----

bool is_ignored(char c) { return c == '+'; }

int left_of(const std::string& string, int at) {
  for (int depth = 0; --at >= 0;) {
    if (string[at] == ']') ++depth;
    if (string[at] == '[')
      depth = std::max(0, depth - 1);
    else if (string[at] != ']' && depth == 0 && !is_ignored(string[at]))
      return at;
  }
  return -1;
}

int right_of(const std::string& string, int at) {
  const int size = static_cast<int>(string.size());
  for (int depth = 0; ++at < size;) {
    if (string[at] == '[')
      ++depth;
    else if (string[at] == ']' && depth-- == 0)
      return -1;
    else if (string[at] != ']' && depth == 0 && !is_ignored(string[at]))
      return at;
  }
  return -1;
}

bool fits(const std::string& string, int at, const std::string& left, const std::string& right) {
  int i = at;
  for (auto c = left.rbegin(); c != left.rend(); ++c)
    if ((i = left_of(string, i)) < 0 || string[i] != *c) return false;
  i = at;
  for (const char c : right)
    if ((i = right_of(string, i)) < 0 || string[i] != c) return false;
  return true;
}

struct Chance {
  std::mt19937 engine{7};
  unsigned below(unsigned count) { return engine() % count; }
};

std::string made_string(Chance& chance) {
  std::string string;
  int depth = 0;
  for (unsigned i = 0; i < 60; ++i) {
    const unsigned what = chance.below(8);
    if (what == 0)
      string += '[', ++depth;
    else if (what == 1 && depth > 0)
      string += ']', --depth;
    else
      string += "ABC+"[chance.below(4)];
  }
  return string + std::string(static_cast<std::size_t>(depth), ']');
}

std::string made_context(Chance& chance) {
  std::string context;
  for (unsigned i = chance.below(4); i > 0; --i) context += "ABC"[chance.below(3)];
  return context;
}

TEST(Neighbours, AreThoseOfAnObviousWalk) {
  Chance chance;
  int fitted = 0;
  for (int round = 0; round < 2'000; ++round) {
    const std::string string = made_string(chance), left = made_context(chance), right = made_context(chance);
    std::string rule = (left.empty() ? "" : left + " < ") + "A" + (right.empty() ? "" : " > " + right) + " -> x";
    std::string expected = string;
    for (int i = 0; i < static_cast<int>(string.size()); ++i)
      if (string[i] == 'A' && fits(string, i, left, right)) expected[i] = 'x', ++fitted;
    ASSERT_EQ(grown("#ignore: +\naxiom: " + string + "\n" + rule, 1), expected) << rule;
  }
  EXPECT_GT(fitted, 3'000);
}

TEST(Neighbours, CostInProportionToTheString) {
  // a quarter of a million modules, all ignored, that all look both ways: seconds if each walked past the others
  const std::string text = "#ignore: AB\naxiom: A\nA -> AA\nC < A > C -> B";
  const Derivation derivation = derive(system_of(text), {.steps = 18});
  EXPECT_EQ(derivation.string.kinds.size(), 1u << 18);
  const std::string branches = "#ignore: A\naxiom: A\nC < A > C -> B\nA -> A[A]";
  EXPECT_EQ(derive(system_of(branches), {.steps = 16}).string.kinds.size(), 3u * (1 << 16) - 2);
}

}  // namespace
}  // namespace citykiln::lsystems
