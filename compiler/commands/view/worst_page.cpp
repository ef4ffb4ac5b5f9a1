#include "compiler/commands/view/worst_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "compiler/commands/view/place_pictures.h"
#include "compiler/map/element_text.h"
#include "compiler/map/plane/degrees.h"
#include "compiler/map/plane/plane.h"
#include "exporters/file.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>The worst places</title>
<style>
body { font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 1500px; color: #222; }
section { margin: 2.5em 0; }
.places { display: grid; grid-template-columns: repeat(auto-fill, minmax(440px, 1fr)); gap: 1.2em; }
figure { margin: 0; }
.shot { position: relative; }
.shot img { width: 100%; display: block; }
.shot::after { content: ""; position: absolute; left: 50%; top: 50%; width: 28px; height: 28px; margin: -16px; border: 2px solid #e22; border-radius: 50%; }
figcaption { font-size: 13px; overflow-wrap: anywhere; }
code { background: #f2f2f2; }
</style>
</head>
<body>
)";

// The text of an element in any tile.
const map::ElementText* element_text_of(const scene::Scene& scene, OsmId id) {
  for (const scene::Chunk& chunk : scene.chunks)
    if (const map::ElementText* text = find_text(chunk.texts, id)) return text;
  return nullptr;
}

std::string tags_html(const map::TagList& tags) {
  std::string html;
  for (const map::TagView& tag : tags.views())
    html += fmt::format(" <code>{}={}</code>", html_text(tag.key), html_text(tag.value));
  return html;
}

// A link to the element, its name, and its tags.
std::string element_html(const scene::Scene& scene, OsmId id) {
  std::string html = id.id > 0 ? fmt::format(R"(<a href="https://www.openstreetmap.org/{}/{}">{}</a>)",
                                             name_of(id.type), id.id, to_string(id))
                               : to_string(id);
  const map::ElementText* text = element_text_of(scene, id);
  if (!text) return html;
  if (!text->name.empty()) html += fmt::format(" <b>{}</b>", html_text(text->name));
  return html + tags_html(text->tags);
}

// The length that a picture must show: the size where it is in metres, else that of a house.
double extent_m_of(const verify::PlacesOfKind& kind, const verify::WorstPlace& place) {
  const bool is_length = kind.text.find("(size: metres") != std::string::npos;
  return is_length ? place.size : 15;
}

struct Page {
  const verify::LoadedRun& run;
  std::string folder;
  map::Plane plane;
  std::string html{};
  std::vector<PlaceToShow> shots{};

  void add(const verify::PlacesOfKind& kind);
  void add(const verify::PlacesOfKind& kind, const verify::WorstPlace& place);
  void add_contents(std::span<const verify::PlacesOfKind> kinds);
};

void Page::add(const verify::PlacesOfKind& kind, const verify::WorstPlace& place) {
  html += "<figure>";
  if (needs_picture(run.scene.header.extent, place)) {
    const std::string name = fmt::format("pictures/{:04}.png", shots.size());
    const std::string tile = place.file.empty() ? "" : run.folder + "/" + place.file;
    shots.push_back({*place.at, extent_m_of(kind, place), kind.on_roofs, tile, folder + "/" + name});
    html += fmt::format(R"(<div class="shot"><img loading="lazy" src="{}" alt=""></div>)", name);
  }
  html += fmt::format("<figcaption><b>{:.4g}</b>", place.size);
  if (!place.text.empty()) html += fmt::format(" {}", html_text(place.text));
  for (const OsmId id : place.ids)
    if (id.type != OsmType::kNone) html += "<br>" + element_html(run.scene, id);
  if (place.at) {
    const LonLat at = plane.backward(*place.at);
    html += fmt::format("<br>{}, {} (lat, lon) · {:.1f}, {:.1f} m in the plane", map::degrees_text(at.lat_deg),
                        map::degrees_text(at.lon_deg), place.at->x, place.at->y);
  }
  html += "</figcaption></figure>\n";
}

std::string anchor_of(std::string_view name) {
  std::string anchor;
  for (const char c : name) anchor += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return anchor;
}

void Page::add(const verify::PlacesOfKind& kind) {
  html += fmt::format("<section id=\"{}\"><h2>{}: {}</h2><p>{}</p>\n<div class=\"places\">\n", anchor_of(kind.name),
                      html_text(kind.name), kind.count, html_text(kind.text));
  for (const verify::WorstPlace& place : kind.worst) add(kind, place);
  html += "</div></section>\n";
}

void Page::add_contents(std::span<const verify::PlacesOfKind> kinds) {
  html += "<table><tr><th>kind</th><th>places</th><th>largest</th></tr>\n";
  for (const verify::PlacesOfKind& kind : kinds)
    html += fmt::format("<tr><td><a href=\"#{}\">{}</a></td><td>{}</td><td>{:.4g}</td></tr>\n", anchor_of(kind.name),
                        html_text(kind.name), kind.count, kind.worst.front().size);
  html += "</table>\n";
}

std::string joined_by_commas(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

}  // namespace

bool needs_picture(const Box2& extent, const verify::WorstPlace& place) {
  return place.at && !place.is_usual && extent.contains(*place.at);
}

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '"')
      html += "&quot;";
    else if (c == '\'')
      html += "&#39;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      html += c;
    else
      html += ' ';
  }
  return html;
}

Result<Done> write_worst_page(const verify::LoadedRun& run, std::span<const verify::PlacesOfKind> kinds,
                              const std::string& folder, int threads, const OnProgress& on_progress) {
  std::error_code failed;
  std::filesystem::create_directories(folder + "/pictures", failed);
  if (failed) return Error{folder, "cannot be made: " + failed.message()};
  Page page{run, folder, map::Plane(run.scene.header.origin), std::string(kHead)};
  page.html += fmt::format("<h1>The worst places of {}</h1>\n<p>Measured by citykiln check. Map: {}.</p>\n",
                           html_text(joined_by_commas(run.scene.header.sources)),
                           html_text(joined_by_commas(run.scene.header.attributions)));
  page.add_contents(kinds);
  for (const verify::PlacesOfKind& kind : kinds) page.add(kind);
  page.html += "</body>\n</html>\n";
  if (const Result<Done> done = write_place_pictures(run.scene, page.shots, threads, on_progress); !done) return done;
  return exporters::write_file(folder + "/index.html", exporters::bytes_of(page.html));
}

}  // namespace citykiln::commands
