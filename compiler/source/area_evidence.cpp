#include "compiler/source/area_evidence.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <iterator>

#include "compiler/source/bodies.h"

namespace citykiln::source {
namespace {

struct EvidenceRow {
  const char* key;
  const char* value;
  std::array<int, 5> votes;  // by CutAreaKind
};

constexpr EvidenceRow kEvidence[] = {
#define EVIDENCE(key, value, river, standing, built_up, cover, park) \
  {key, value, {river, standing, built_up, cover, park}},
#include "compiler/source/area_evidence.inc"
#undef EVIDENCE
};

bool has_value(const osmium::TagList& tags, const char* key, std::initializer_list<const char*> values) {
  const char* value = tags.get_value_by_key(key);
  return value && std::ranges::any_of(values, [&](const char* v) { return std::strcmp(v, value) == 0; });
}

bool says_yes(const osmium::TagList& tags, const char* key) {
  const char* value = tags.get_value_by_key(key);
  return value && std::strcmp(value, "no") != 0;
}

bool is_body(const osmium::TagList& tags, const char* key) {
  const char* value = tags.get_value_by_key(key);
  return value && has_body(key, value);
}

bool is_row_of(const osmium::TagList& tags, const EvidenceRow& row) {
  const char* value = tags.get_value_by_key(row.key);
  return value && (row.value[0] == '*' || std::strcmp(value, row.value) == 0);
}

}  // namespace

std::optional<CutAreaKind> cut_area_kind(const osmium::TagList& tags) {
  if (!tags.has_tag("type", "multipolygon") || says_yes(tags, "building") || says_yes(tags, "building:part"))
    return std::nullopt;
  if (has_value(tags, "water", {"river", "canal", "stream", "oxbow"}) ||
      has_value(tags, "waterway", {"riverbank", "river", "canal", "stream"}))
    return CutAreaKind::kRiver;
  if (tags.has_tag("natural", "water") || tags.has_key("water") || tags.has_tag("waterway", "dock") ||
      has_value(tags, "landuse", {"reservoir", "basin", "salt_pond", "aquaculture"}))
    return CutAreaKind::kStanding;
  if (has_value(tags, "landuse", {"residential", "industrial", "commercial", "retail"})) return CutAreaKind::kBuiltUp;
  if (is_body(tags, "landuse") || is_body(tags, "natural")) return CutAreaKind::kCover;
  if (is_body(tags, "leisure")) return CutAreaKind::kPark;
  return std::nullopt;
}

int votes_of(const osmium::TagList& tags, CutAreaKind kind) {
  if (says_yes(tags, "bridge") || says_yes(tags, "tunnel") || tags.has_tag("location", "underground")) return 0;
  const auto row = std::ranges::find_if(kEvidence, [&](const EvidenceRow& each) { return is_row_of(tags, each); });
  return row == std::end(kEvidence) ? 0 : row->votes[static_cast<std::size_t>(kind)];
}

}  // namespace citykiln::source
