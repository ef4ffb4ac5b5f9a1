#include "compiler/things/yard_kinds.h"

#include <optional>

namespace citykiln::things {
namespace {

struct YardShareRow {
  std::string_view name;
  std::optional<map::CountryGroup> country;
  YardShare share;
};

constexpr YardShareRow kYardShares[] = {
#define YARD_SHARE(name, country, detached, row) {name, map::CountryGroup::country, {detached, row}},
#define YARD_SHARE_ANYWHERE(name, detached, row) {name, std::nullopt, {detached, row}},
#include "compiler/things/yard_kinds.inc"
#undef YARD_SHARE
#undef YARD_SHARE_ANYWHERE
};

struct YardNumberRow {
  std::string_view name;
  YardUse use;
  YardNumber number;
};

constexpr YardNumberRow kYardNumbers[] = {
#define YARD_THING(name, use, percent, most) {name, YardUse::use, {percent, most}},
#include "compiler/things/yard_kinds.inc"
#undef YARD_THING
};
static_assert(std::ranges::all_of(kYardNumbers, [](const YardNumberRow& row) {
  return row.number.most <= kMostOfKind && is_yard_kind(row.name);
}));

}  // namespace

YardNumber yard_number(std::string_view name, YardUse use) {
  for (const YardNumberRow& row : kYardNumbers)
    if (row.name == name && row.use == use) return row.number;
  return {};
}

bool is_kind_of(std::string_view name, std::span<const YardUse> uses) {
  const auto has_use = [&](YardUse use) { return std::ranges::find(uses, use) != uses.end(); };
  if (name == kYardGate || std::ranges::find(kYardShares, name, &YardShareRow::name) != std::end(kYardShares))
    return true;
  if (name == kSiteCrane) return has_use(YardUse::kSite);
  if (name == kSiteFence) return has_use(YardUse::kSite) || has_use(YardUse::kSchool);
  return std::ranges::any_of(kYardNumbers,
                             [&](const YardNumberRow& row) { return row.name == name && has_use(row.use); });
}

YardShare yard_share(std::string_view name, map::CountryGroup country) {
  YardShare share;
  for (const YardShareRow& row : kYardShares) {
    if (row.name != name) continue;
    if (row.country == country) return row.share;
    if (!row.country) share = row.share;
  }
  return share;
}

}  // namespace citykiln::things
