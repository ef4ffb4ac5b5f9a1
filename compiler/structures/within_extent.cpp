#include "compiler/structures/within_extent.h"

#include "compiler/ground/grading/road_influence.h"

namespace citykiln::structures {
namespace {

bool reaches(const Span& span, const Box2& extent) {
  const Box2 near = extent.widened(roads::max_offset_m(span) + ground::kGrading_m);
  for (std::size_t i = 0; i + 1 < span.axis.size(); ++i)
    if (box_of_segment(span.axis[i], span.axis[i + 1]).touches(near)) return true;
  return false;
}

void keep_within(std::vector<Span>& spans, const Box2& extent, Account& account, Report& report) {
  for (const Span& span : spans) account.in += report.counts(span.id.osm);
  std::erase_if(spans, [&](const Span& span) {
    if (reaches(span, extent)) return false;
    report.drop(account, Code::kOutsideBounds, span.id.osm);
    return true;
  });
  for (const Span& span : spans) account.out += report.counts(span.id.osm);
}

}  // namespace

Structures within_extent(Structures structures, const Box2& extent, Report& report) {
  Account bridges, tunnels;
  keep_within(structures.bridges, extent, bridges, report);
  keep_within(structures.tunnels, extent, tunnels, report);
  report.account("extent", "bridge") = bridges;
  report.account("extent", "tunnel") = tunnels;
  return structures;
}

}  // namespace citykiln::structures
