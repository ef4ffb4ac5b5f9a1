#include "compiler/invent/town/streets/street_sections.h"

#include <array>

#include "compiler/invent/tags.h"

namespace citykiln::invent {
namespace {

struct ClassRow {
  const char* highway;
  double lane_m;  ///< The width that compiling assumes for a lane of the class, or the whole way where lanes are not
                  ///< counted.
  const char* maxspeed;
  const char* surface;
};

constexpr std::array<ClassRow, 7> kClassRows = {{{"primary", 3.5, "50", "asphalt"},
                                                 {"secondary", 3.25, "50", "asphalt"},
                                                 {"tertiary", 3.0, "50", "asphalt"},
                                                 {"residential", 2.75, "30", "asphalt"},
                                                 {"living_street", 5.0, "7", "paving_stones"},
                                                 {"pedestrian", 4.5, "", "paving_stones"},
                                                 {"service", 3.5, "", "asphalt"}}};

const ClassRow& class_row(StreetClass c) { return kClassRows[static_cast<std::size_t>(c)]; }

double edge_density(const TownPlan& plan, const StreetEdge& edge) {
  return plan.density.at(edge.axis[edge.axis.size() / 2]);
}

bool is_wide_road(const TownPlan& plan, StreetClass c) {
  return plan.settings.kind == TownKind::kCity && c == StreetClass::kPrimary;
}

void tag_pavements(Tags& tags, const StreetSection& section) {
  set_tag(tags, "sidewalk", section.pavement_m > 0 ? "both" : "no");
  if (section.parking_m > 0) {
    set_tag(tags, "parking:both", "lane");
    set_tag(tags, "parking:both:orientation", "parallel");
  }
}

}  // namespace

StreetSection street_section(const TownPlan& plan, const StreetEdge& edge, StreetClass street_class) {
  const double density = edge_density(plan, edge);
  StreetSection section;
  const bool is_counted = street_class <= StreetClass::kResidential;
  section.lanes = !is_counted ? 0 : is_wide_road(plan, street_class) && density > 0.3 ? 4 : 2;
  section.carriageway_m = is_counted ? section.lanes * class_row(street_class).lane_m : class_row(street_class).lane_m;
  section.pavement_m = is_counted && density > kTownEdge ? 2 : 0;
  const bool has_parking = street_class == StreetClass::kResidential && density > 0.42 && !edge.is_bridge;
  section.parking_m = has_parking ? 2 : 0;
  return section;
}

Tags street_tags(const TownPlan& plan, const StreetEdge& edge, const Street& street) {
  const ClassRow& row = class_row(street.street_class);
  const StreetSection section = street_section(plan, edge, street.street_class);
  const double density = edge_density(plan, edge);
  Tags tags = tags_of({{"highway", row.highway}, {"name", street.name}, {"surface", row.surface}});
  const bool is_country = density <= kTownEdge;
  set_tag(tags, "maxspeed", is_country && is_main(street.street_class) ? "100" : row.maxspeed);
  if (section.lanes > 0) set_tag(tags, "lanes", std::to_string(street.is_roundabout ? 1 : section.lanes));
  if (street.street_class <= StreetClass::kResidential) tag_pavements(tags, section);
  set_tag(tags, "lit", is_country ? "no" : "yes");
  const bool is_setts = street.street_class == StreetClass::kResidential && density > 0.66;
  if (is_setts) set_tag(tags, "surface", "sett");
  if (edge.is_bridge) {
    set_tag(tags, "bridge", "yes");
    set_tag(tags, "layer", "1");
  }
  if (street.is_roundabout) {
    set_tag(tags, "junction", "roundabout");
    set_tag(tags, "oneway", "yes");
  }
  return tags;
}

}  // namespace citykiln::invent
