#include "compiler/commands/edits_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace citykiln::commands {
namespace {

struct MendRow {
  std::string_view kind, edit;
};

constexpr MendRow kMends[] = {
#define MEND(kind, edit) {kind, edit},
#include "compiler/commands/mends.inc"
#undef MEND
};

std::string_view mend_of(std::string_view kind) {
  const auto row = std::ranges::find(kMends, kind, &MendRow::kind);
  return row == std::end(kMends) ? std::string_view() : row->edit;
}

void replace_all(std::string& text, std::string_view wanted, std::string_view by) {
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + by.size()))
    text.replace(at, wanted.size(), by);
}

// A text of the map in a comment: without line breaks and control characters.
std::string comment_text(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return text;
}

std::string quoted_key(std::string_view key) {
  return key.find_first_of(" \t\"#=,*!/") == std::string_view::npos ? std::string(key) : fmt::format("\"{}\"", key);
}

std::string text_of_place(std::string_view kind, const verify::WorstPlace& place, const map::Plane& plane) {
  std::string text = "# ";
  for (const OsmId id : place.ids) text += to_string(id) + " ";
  if (place.at) {
    const LonLat at = plane.backward(*place.at);
    text += fmt::format("at {:.7f},{:.7f} ", at.lon_deg, at.lat_deg);
  }
  if (place.size != 0) text += fmt::format("size {:.2f} ", place.size);
  text += comment_text(place.text);
  text.erase(text.find_last_not_of(' ') + 1);
  const std::string mend = likely_mend(kind, place);
  return mend.empty() ? text + "\n" : fmt::format("{}\n#{}\n", text, mend);
}

void add_kind(const verify::PlacesOfKind& kind, const map::Plane& plane, std::string& text) {
  text += fmt::format("\n# ---- {}: {} ({})\n", kind.name, comment_text(kind.text), kind.count);
  for (const verify::WorstPlace& place : kind.worst)
    if (place.file.empty()) text += text_of_place(kind.name, place, plane);
}

verify::WorstPlace place_of_finding(const outputs::Finding& finding, const map::Plane& plane) {
  verify::WorstPlace place{.ids = {}, .size = finding.diagnosis.size, .text = finding.tags};
  if (finding.at) place.at = plane.forward(*finding.at);
  for (const OsmId id : {finding.diagnosis.object, finding.diagnosis.other})
    if (id.type != OsmType::kNone) place.ids.push_back(id);
  return place;
}

// The places of a diagnosis that is not among the worst places, the largest first.
verify::PlacesOfKind places_of_code(Code code, std::span<const outputs::Finding> findings, const map::Plane& plane) {
  verify::PlacesOfKind kind{std::string(name_of(code)), std::string(text_of(code)), 0, {}};
  for (const outputs::Finding& finding : findings)
    if (finding.diagnosis.code == code) kind.worst.push_back(place_of_finding(finding, plane));
  std::ranges::stable_sort(kind.worst, std::ranges::greater{}, &verify::WorstPlace::size);
  kind.count = kind.worst.size();
  return kind;
}

}  // namespace

std::string likely_mend(std::string_view kind, const verify::WorstPlace& place) {
  std::string edit(mend_of(kind));
  if (edit.empty() || place.ids.empty() || place.ids[0].type == OsmType::kLot) return "";
  const std::string key = place.text.substr(0, place.text.find('='));
  if (edit.find("{key}") != std::string::npos && key.empty()) return "";
  replace_all(edit, "{id}", to_string(place.ids[0]));
  replace_all(edit, "{other}", to_string(place.ids.back()));
  replace_all(edit, "{key}", quoted_key(comment_text(key)));
  return edit;
}

std::string edits_template(std::span<const verify::PlacesOfKind> kinds, std::span<const outputs::Finding> findings,
                           const map::Plane& plane, std::string_view run) {
  std::string text = fmt::format(
      "# Edits for {}: what was found, each with the edit that would be the likely mend. Take away the \"#\" before "
      "an\n"
      "# edit, correct its values, and compile again with --edits and the name of this file.\n",
      comment_text(std::string(run)));
  for (const verify::PlacesOfKind& kind : kinds) add_kind(kind, plane, text);
  std::vector<Code> more;
  for (const outputs::Finding& finding : findings) {
    const Code code = finding.diagnosis.code;
    if (mend_of(name_of(code)).empty() || std::ranges::find(more, code) != more.end()) continue;
    if (std::ranges::none_of(kinds, [&](const auto& kind) { return kind.name == name_of(code); })) more.push_back(code);
  }
  std::ranges::sort(more);
  for (const Code code : more) add_kind(places_of_code(code, findings, plane), plane, text);
  return text;
}

}  // namespace citykiln::commands
