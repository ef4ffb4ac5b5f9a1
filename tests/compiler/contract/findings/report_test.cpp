#include "compiler/contract/findings/report.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(Report, AccountsBalanceOnlyIfAllLossesAreCounted) {
  Report report;
  Account& account = report.account("map", "track");
  account.in = 3, account.split = 1, account.out = 2, account.merged = 1;
  EXPECT_FALSE(report.balances());
  report.drop(account, Code::kNoLength, {OsmType::kWay, 5});
  EXPECT_TRUE(report.balances());
}

TEST(Report, AppendingAddsUpAccounts) {
  Report a, b;
  a.account("map", "track").in = 1;
  b.account("map", "track").in = 2;
  b.add(Code::kNoHeight, {});
  a.append(b);
  EXPECT_EQ(a.account("map", "track").in, 3u);
  EXPECT_EQ(a.counts().at(Code::kNoHeight), 1u);
}

TEST(Report, AppendingAddsUpWhatIsAssumed) {
  Report a, b;
  a.count_assumed(Assumption::kLamps, {OsmType::kWay, 1});
  b.count_assumed(Assumption::kLamps, {OsmType::kWay, 2});
  a.append(b);
  EXPECT_EQ(a.assumed(Assumption::kLamps), 2u);
  EXPECT_EQ(a.assumed(Assumption::kHeights), 0u);
}

TEST(Report, LimitedToObjectsItCountsWhatIsAssumedOfThem) {
  Report report;
  report.limit_to({{OsmType::kWay, 2}});
  for (int i = 1; i < 4; ++i) report.count_assumed(Assumption::kLamps, {OsmType::kWay, i});
  EXPECT_EQ(report.assumed(Assumption::kLamps), 1u);
}

TEST(Report, CodesAreNamedWithoutTheirPrefix) { EXPECT_EQ(name_of(Code::kMissingNode), "MissingNode"); }

}  // namespace
}  // namespace citykiln
