// The book's figures in lsystems/book. Their modules are counted independently: by a simple rewriter of strings
// (figures 1.24 to 1.26), closed forms (2.6 to 2.8), recurrences (5.11, 5.12), and means over many plants for
// stochastic systems (1.27, 1.28). The book prints no counts.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lsystems/rewriting/turtle.h"
#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

using Words = std::vector<std::string>;
using Counts = std::map<std::string, std::uint64_t>;

LSystem book_figure(const std::string& name) {
  const std::string path = "lsystems/book/fig_" + name + ".lsys";
  const Result<LSystem> system = read_lsystem(text_of_tree(path), path);
  EXPECT_TRUE(system) << to_string(system.error());
  return *system;
}

// One word a letter, except for long names.
Words words_of(const std::string& text) {
  static const Words kNames = {"plant", "internode", "seg", "leaf", "flower", "pedicel", "wedge"};
  Words words;
  for (std::size_t at = 0; at < text.size();) {
    std::string word(1, text[at]);
    for (const std::string& name : kNames)
      if (text.compare(at, name.size(), name) == 0) word = name;
    at += word.size();
    if (word != " ") words.push_back(word);
  }
  return words;
}

Words rewritten(Words string, const std::map<std::string, std::string>& rules, int steps) {
  for (int i = 0; i < steps; ++i) {
    Words next;
    for (const std::string& word : string) {
      const auto rule = rules.find(word);
      const Words made = rule == rules.end() ? Words{word} : words_of(rule->second);
      next.insert(next.end(), made.begin(), made.end());
    }
    string = next;
  }
  return string;
}

void expect_same(const std::string& name, const std::string& axiom, const std::map<std::string, std::string>& rules) {
  const LSystem system = book_figure(name);
  Words found;
  for (const Kind kind : derive(system).string.kinds) found.push_back(system.kinds[kind].name);
  EXPECT_EQ(found, rewritten(words_of(axiom), rules, system.steps)) << name;
}

TEST(Book, Figure1_24IsAsASimpleRewriterSays) {
  expect_same("1_24a", "F", {{"F", "F[+F]F[-F]F"}});
  expect_same("1_24b", "F", {{"F", "F[+F]F[-F][F]"}});
  expect_same("1_24c", "F", {{"F", "FF-[-F+F+F]+[+F-F-F]"}});
  expect_same("1_24d", "X", {{"X", "F[+X]F[-X]+X"}, {"F", "FF"}});
  expect_same("1_24e", "X", {{"X", "F[+X][-X]FX"}, {"F", "FF"}});
  expect_same("1_24f", "X", {{"X", "F-[[X]+X]+F[+FX]-X"}, {"F", "FF"}});
}

TEST(Book, Figures1_25And1_26AreAsASimpleRewriterSays) {
  expect_same(
      "1_25", "A",
      {{"A", "[&FL!A]/////'[&FL!A]///////'[&FL!A]"}, {"F", "S/////F"}, {"S", "FL"}, {"L", "['''^^{-f+f+f-|-f+f+f}]"}});
  expect_same("1_26", "plant",
              {{"plant", "internode+[plant+flower]--//[--leaf]internode[++leaf]-[plant flower]++plant flower"},
               {"internode", "F seg[//&&leaf][//^^leaf]F seg"},
               {"seg", "seg F seg"},
               {"leaf", "['{+f-ff-f+|+f-ff-f}]"},
               {"flower", "[&&&pedicel'/wedge////wedge////wedge////wedge////wedge]"},
               {"pedicel", "FF"},
               {"wedge", "['^F][{&&&&-f+f|-f+f}]"}});
}

double mean_of(const std::string& name, const std::string& module, int steps, int plants) {
  const LSystem system = book_figure(name);
  double sum = 0;
  for (int i = 0; i < plants; ++i) {
    const Derivation derivation = derive(system, {.steps = steps, .plant = StableId{static_cast<std::uint64_t>(i)}});
    sum += static_cast<double>(counts_of(system, derivation.string)[module]);
  }
  return sum / plants;
}

TEST(Book, Figure1_27GrowsByItsMeanAndKeepsItsBranches) {
  // a step makes 0.33 · 5 + 0.67 · 3 = 3.66 F of one
  EXPECT_NEAR(mean_of("1_27", "F", 3, 4'000) / std::pow(3.66, 3), 1, 0.02);
  const LSystem system = book_figure("1_27");
  for (std::uint64_t i = 0; i < 20; ++i) {
    Counts counts = counts_of(system, derive(system, {.plant = StableId{i}}).string);
    // each branch adds two F
    EXPECT_EQ(counts["F"], 1 + 2 * counts["["]);
    EXPECT_EQ(counts["+"] + counts["-"], counts["["]);
  }
}

TEST(Book, Figure1_28GrowsByItsMean) {
  // one internode at step 2 has two segments, which then grow by 0.66 · 2 + 0.34
  const double grown = mean_of("1_28", "seg", 4, 4'000);
  // internodes appear at steps 1, 2, 3 (2, 6 and 18), so segments begin at steps 2, 3, 4
  EXPECT_NEAR(grown / (4 * 1.66 * 1.66 + 12 * 1.66 + 36), 1, 0.01);
}

TEST(Book, Figure2_6HasTheClosedForm) {
  // each of 2^n apices adds seven modules, one of them a segment
  for (const char* name : {"2_6a", "2_6b", "2_6c", "2_6d"}) {
    const LSystem system = book_figure(name);
    for (int n = 0; n <= 15; ++n) {
      const ModuleString string = derive(system, {.steps = n}).string;
      const std::uint64_t apices = std::uint64_t{1} << n;
      ASSERT_EQ(string.kinds.size(), 1 + 7 * (apices - 1));
      EXPECT_EQ(counts_of(system, string)["F"], apices - 1);
    }
  }
}

TEST(Book, Figure2_6HasHondasLengths) {
  // the trunk's segments shrink by r1, the first branch by r2, and widths by wr
  const Skeleton skeleton = grow(book_figure("2_6a")).skeleton;
  const auto& s = skeleton.segments;
  EXPECT_EQ(s[0].length, 1);
  EXPECT_EQ(s[1].length, 0.6);
  EXPECT_EQ(s[1].parent, 0);
  EXPECT_EQ(s[1].end_radius, 0.1 * 0.707);
  double trunk = 0;
  for (const Segment& segment : s)
    if (segment.order == 0) trunk += segment.length;
  EXPECT_NEAR(trunk, (1 - std::pow(0.9, 10)) / 0.1, 1e-12);
}

TEST(Book, Figure2_7HasTheClosedForm) {
  for (const char* name : {"2_7a", "2_7b", "2_7c", "2_7d"}) {
    const LSystem system = book_figure(name);
    const ModuleString string = derive(system).string;
    // A adds 10 modules, then each of 2^k B adds 11
    EXPECT_EQ(string.kinds.size(), 1 + 10 + 11 * (1024 - 2));
    EXPECT_EQ(counts_of(system, string)["F"], 1023u);
  }
}

TEST(Book, Figure2_8HasTheClosedForm) {
  for (const char* name : {"2_8a", "2_8b", "2_8c", "2_8d"}) {
    const LSystem system = book_figure(name);
    const ModuleString string = derive(system).string;
    // each of 3^k apices adds 18 modules, among them 4 F
    const auto written = static_cast<std::uint64_t>((std::pow(3, system.steps) - 1) / 2);
    EXPECT_EQ(string.kinds.size(), 4 + 18 * written);
    EXPECT_EQ(counts_of(system, string)["F"], 1 + 4 * written);
  }
}

TEST(Book, Figure2_8BendsToItsTropism) {
  const auto mean_end = [](const std::string& name) {
    Vec3 sum;
    const Skeleton skeleton = grow(book_figure(name)).skeleton;
    for (const Segment& segment : skeleton.segments) sum = sum + segment.end().heading;
    return sum * (1.0 / static_cast<double>(skeleton.segments.size()));
  };
  // gravity lowers the headings of figure a
  const LSystem straight = [] {
    LSystem system = book_figure("2_8a");
    system.elasticity = 0;
    return system;
  }();
  Vec3 sum;
  const Skeleton skeleton = grow(straight).skeleton;
  for (const Segment& segment : skeleton.segments) sum = sum + segment.end().heading;
  EXPECT_LT(mean_end("2_8a").z, sum.z / static_cast<double>(skeleton.segments.size()) - 0.3);
  // the tropism of figure d points west
  EXPECT_LT(mean_end("2_8d").x, -0.4);
}

struct Leaf {
  const char* name;
  int delay;
};

// Segments after the system's steps. An apex branches into itself and `others` apices that first wait for the delay.
std::uint64_t segments_by_recurrence(const LSystem& system, int delay, std::uint64_t others) {
  std::vector<std::uint64_t> apices(static_cast<std::size_t>(delay) + 1);  // by steps until they branch
  apices[0] = 1;
  std::uint64_t segments = 0;
  for (int step = 0; step < system.steps; ++step) {
    const std::uint64_t branching = apices[0];
    std::vector<std::uint64_t> next(apices.begin() + 1, apices.end());
    next.push_back(others * branching);
    next[0] += branching;
    apices = next;
    segments += 2 * branching;
  }
  return segments;
}

TEST(Book, Figure5_11IsAsItsRecurrenceSays) {
  for (const Leaf leaf : {Leaf{"5_11a", 0}, {"5_11b", 1}, {"5_11c", 2}, {"5_11d", 4}, {"5_11e", 7}}) {
    const LSystem system = book_figure(leaf.name);
    const std::uint64_t segments = segments_by_recurrence(system, leaf.delay, 2);
    Counts counts = counts_of(system, derive(system).string);
    EXPECT_EQ(counts["F"], segments) << leaf.name;
    EXPECT_EQ(counts["["], segments) << leaf.name;
    EXPECT_EQ(counts["A"], 1 + segments) << leaf.name;
  }
}

TEST(Book, Figure5_12IsAsItsRecurrenceSays) {
  for (const Leaf leaf : {Leaf{"5_12a", 1}, {"5_12b", 4}, {"5_12c", 7}}) {
    const LSystem system = book_figure(leaf.name);
    // A and B differ only in the side to which they branch
    const std::uint64_t segments = segments_by_recurrence(system, leaf.delay, 1);
    Counts counts = counts_of(system, derive(system).string);
    EXPECT_EQ(counts["F"], segments) << leaf.name;
    EXPECT_EQ(counts["A"] + counts["B"], 1 + segments / 2) << leaf.name;
  }
}

TEST(Book, DerivesWithoutWarnings) {
  for (const char* name : {"1_24a", "1_25", "1_26", "1_27", "1_28", "2_6a", "2_7d", "2_8c", "5_11b", "5_12a"}) {
    const LSystem system = book_figure(name);
    const Plant plant = grow(system);
    EXPECT_FALSE(plant.derivation.limit_exceeded) << name;
    EXPECT_TRUE(plant.derivation.warnings.empty() && plant.skeleton.warnings.empty()) << name;
    EXPECT_FALSE(plant.skeleton.segments.empty()) << name;
  }
}

}  // namespace
}  // namespace citykiln::lsystems
