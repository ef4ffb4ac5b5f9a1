#include "compiler/commands/plan/task_lists.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

TEST(TaskLists, NamesAreQuotedForTheShell) {
  EXPECT_EQ(shell_quoted("/opt/my kiln/citykiln"), "'/opt/my kiln/citykiln'");
  EXPECT_EQ(shell_quoted("a'; rm -rf $HOME; '"), "'a'\\''; rm -rf $HOME; '\\'''");
}

TEST(TaskLists, CommandsAreEscapedForNinja) { EXPECT_EQ(ninja_command("'$x'\ny"), "'$$x' y"); }

TEST(TaskLists, ArraysHoldEveryRegionOnce) {
  Plan plan;
  plan.grid = {.extent = {{0, 0}, {16384, 16384 * 1200.0}}};
  for (int i = 0; i < 1200; ++i) plan.regions.push_back({.key = {0, i}, .tiles = 1, .file = {}, .expected = {}});
  const auto files = task_lists(plan, "/bin/citykiln");
  EXPECT_NE(files.at("submit.sh").find("regions_1GB.txt 1 1000 "), std::string::npos);
  EXPECT_NE(files.at("submit.sh").find("regions_1GB.txt 1001 200 "), std::string::npos);
  EXPECT_EQ(std::ranges::count(files.at("regions_1GB.txt"), '\n'), 1200);
}

}  // namespace
}  // namespace citykiln::commands
