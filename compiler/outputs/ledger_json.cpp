#include "compiler/outputs/ledger_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "compiler/contract/findings/code_names.h"

namespace citykiln::outputs {
namespace {

using OrderedJson = nlohmann::ordered_json;

}  // namespace

Code known_code(const std::string& name) {
  const std::optional<Code> code = code_named(name);
  if (!code) throw OrderedJson::other_error::create(501, "unknown code " + name, nullptr);
  return *code;
}

OrderedJson ledger_json(const Report& report) {
  OrderedJson ledger = OrderedJson::object();
  for (const auto& [name, account] : report.ledger()) {
    OrderedJson dropped = OrderedJson::object();
    for (const auto& [code, count] : account.dropped) dropped[std::string(name_of(code))] = count;
    ledger[name] = {{"in", account.in},
                    {"split", account.split},
                    {"out", account.out},
                    {"merged", account.merged},
                    {"without_body", account.without_body},
                    {"dropped", dropped}};
  }
  return ledger;
}

void add_ledger(const OrderedJson& json, Report& report) {
  for (const auto& [name, theirs] : json.items()) {
    const std::size_t slash = name.find('/');
    Account& ours = report.account(name.substr(0, slash), slash == std::string::npos ? "" : name.substr(slash + 1));
    const auto number = [&theirs = theirs](const char* key) { return theirs.at(key).get<std::uint64_t>(); };
    ours.in += number("in"), ours.split += number("split"), ours.out += number("out"), ours.merged += number("merged");
    // reports of older versions have no such key
    ours.without_body += theirs.value("without_body", std::uint64_t{0});
    for (const auto& [code, count] : theirs.at("dropped").items())
      ours.dropped[known_code(code)] += count.get<std::uint64_t>();
  }
}

}  // namespace citykiln::outputs
