#include "compiler/bake/bake_things.h"

#include <fmt/format.h>

#include <map>
#include <string>

#include "compiler/bake/bake_instances.h"

namespace citykiln::bake {
namespace {

// "bench", or "bench_2" for the second form of benches in the tile.
std::string name_of_form(const PlacedThing& thing) {
  return thing.number == 1 ? thing.form.kind : fmt::format("{}_{}", thing.form.kind, thing.number);
}

void count_things(const std::vector<const PlacedThing*>& things, const BakedThing& baked, Account& account,
                  Report& report) {
  for (const PlacedThing* thing : things) {
    ++account.in;
    if (baked.primitives.empty())
      report.drop(account, Code::kBelowTolerance, thing->placement.feature, baked.error_m);
    else
      ++account.out;
  }
}

}  // namespace

void bake_things(Baking& baking, const std::vector<PlacedThing>& things, const PrototypeCache& prototypes,
                 Report& report) {
  std::map<things::Form, std::vector<const PlacedThing*>> by_form;
  for (const PlacedThing& thing : things) by_form[thing.form].push_back(&thing);
  Account account;
  for (const auto& [form, all] : by_form) {
    const BakedThing& baked = prototypes.thing(form, baking.tolerance_m);
    count_things(all, baked, account, report);
    for (const grammars::RuleFault& fault : baked.rule_faults)
      report.add({.code = Code::kThingRuleErrors,
                  .object = all.front()->placement.feature,
                  .size = static_cast<double>(fault.times),
                  .tag = fault.text});
    for (const PlacedThing* thing : all) baking.certify(baked.error_m, bounds_of(*thing));
    if (baked.primitives.empty()) continue;
    std::vector<Placement> placements;
    for (const PlacedThing* thing : all) placements.push_back(thing->placement);
    InstancedMesh instanced = instances_of(baking, name_of_form(*all.front()), placements, 1);
    instanced.primitives = baked.primitives;
    baking.tile.instanced.push_back(std::move(instanced));
  }
  report.account("bake", "thing") = account;
}

}  // namespace citykiln::bake
