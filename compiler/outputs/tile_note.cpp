#include "compiler/outputs/tile_note.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "compiler/contract/code_names.h"
#include "compiler/outputs/ledger_json.h"
#include "compiler/outputs/written_tile_json.h"

namespace citykiln::outputs {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Diagnosis& d) {
  OrderedJson json = {name_of(d.code), static_cast<int>(d.object.type), d.object.id, d.size};
  if (d.at_m) json.push_back(*d.at_m);
  return json;
}

OrderedJson json_of(const Account& account) {
  OrderedJson dropped = OrderedJson::object();
  for (const auto& [code, count] : account.dropped) dropped[std::string(name_of(code))] = count;
  return {account.in, account.split, account.out, account.merged, dropped};
}

Account account_of(const OrderedJson& json) {
  Account account{.in = json.at(0), .split = json.at(1), .out = json.at(2), .merged = json.at(3), .dropped = {}};
  for (const auto& [code, count] : json.at(4).items()) account.dropped[known_code(code)] = count;
  return account;
}

Diagnosis diagnosis_of(const OrderedJson& d) {
  Diagnosis diagnosis{known_code(d.at(0)), {static_cast<OsmType>(d.at(1).get<int>()), d.at(2)}, d.at(3)};
  if (d.size() > 4) diagnosis.at_m = d.at(4).get<std::array<double, 2>>();
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
