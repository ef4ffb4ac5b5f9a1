#include "compiler/contract/target.h"

#include <cassert>
#include <vector>

namespace citykiln {
namespace {

constexpr TargetValues kTargets[] = {
#define TARGET(name, option, instancing, nodes, layout, quantised, draco, meshopt, transform, webp, lights, culls, \
               flat, tested)                                                                                       \
  {option,    Instancing::instancing,                                                                              \
   nodes,     Layout::layout,                                                                                      \
   quantised, draco,                                                                                               \
   meshopt,   transform,                                                                                           \
   webp,      lights,                                                                                              \
   culls,     flat,                                                                                                \
   tested},
#include "compiler/contract/targets.inc"
#undef TARGET
};

}  // namespace

const TargetValues& values_of(Target target) {
  assert(target < Target::kCount);
  return kTargets[static_cast<std::size_t>(target)];
}

std::optional<Target> target_named(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kTargets); ++i)
    if (kTargets[i].name == name) return static_cast<Target>(i);
  return std::nullopt;
}

std::string targets_with(bool (*wanted)(const TargetValues&)) {
  std::vector<std::string_view> names;
  for (const TargetValues& target : kTargets)
    if (wanted(target)) names.push_back(target.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += std::string(i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
  return text;
}

}  // namespace citykiln
