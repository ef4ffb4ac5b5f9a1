#include "compiler/outputs/tile_note.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "compiler/contract/findings/code_names.h"
#include "compiler/outputs/ledger_json.h"
#include "compiler/outputs/written_tile_json.h"

namespace citykiln::outputs {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Diagnosis& d) {
  const OrderedJson at = d.at_m ? OrderedJson(*d.at_m) : OrderedJson();
  return {name_of(d.code),
          static_cast<int>(d.object.type),
          d.object.id,
          d.size,
          at,
          static_cast<int>(d.other.type),
          d.other.id,
          d.tag};
}

OrderedJson json_of(const Account& account) {
  OrderedJson dropped = OrderedJson::object();
  for (const auto& [code, count] : account.dropped) dropped[std::string(name_of(code))] = count;
  return {account.in, account.split, account.out, account.merged, account.without_body, dropped};
}

Account account_of(const OrderedJson& json) {
  Account account{.in = json.at(0),
                  .split = json.at(1),
                  .out = json.at(2),
                  .merged = json.at(3),
                  .without_body = json.at(4),
                  .dropped = {}};
  for (const auto& [code, count] : json.at(5).items()) account.dropped[known_code(code)] = count;
  return account;
}

// The id of the element whose type is at an index and its number at the next.
OsmId element_at(const OrderedJson& d, std::size_t index) {
  return {static_cast<OsmType>(d.at(index).get<int>()), d.at(index + 1)};
}

Diagnosis diagnosis_of(const OrderedJson& d) {
  Diagnosis diagnosis{.code = known_code(d.at(0)), .object = element_at(d, 1), .size = d.at(3)};
  if (!d.at(4).is_null()) diagnosis.at_m = d.at(4).get<std::array<double, 2>>();
  diagnosis.other = element_at(d, 5), diagnosis.tag = d.at(7);
  return diagnosis;
}

Report report_of(const OrderedJson& json) {
  Report report;
  for (const OrderedJson& d : json.at("diagnoses")) report.add(diagnosis_of(d));
  for (const auto& [name, account] : json.at("ledger").items()) {
    const std::size_t slash = name.find('/');
    report.account(name.substr(0, slash), name.substr(slash + 1)) = account_of(account);
  }
  return report;
}

}  // namespace

std::string text_of(const TileNote& note) {
  OrderedJson json = {
      {"tile", json_of(note.tile)}, {"diagnoses", OrderedJson::array()}, {"ledger", OrderedJson::object()}};
  for (const Diagnosis& diagnosis : note.diagnosed.diagnoses()) json["diagnoses"].push_back(json_of(diagnosis));
  for (const auto& [name, account] : note.diagnosed.ledger()) json["ledger"][name] = json_of(account);
  return json.dump();
}

std::optional<TileNote> tile_note(const std::string& text) {
  try {
    const OrderedJson json = OrderedJson::parse(text);
    return TileNote{parse_written_tile(json.at("tile")), report_of(json)};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace citykiln::outputs
