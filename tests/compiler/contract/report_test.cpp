#include "compiler/contract/report.h"

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

TEST(Report, CodesAreNamedWithoutTheirPrefix) { EXPECT_EQ(name_of(Code::kMissingNode), "MissingNode"); }

}  // namespace
}  // namespace citykiln
