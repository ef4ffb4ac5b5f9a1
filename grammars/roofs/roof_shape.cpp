#include "grammars/roofs/roof_shape.h"

#include <array>

namespace citykiln::roofs {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Form::kCount)> kNames = {
#define ROOF_FORM(name, tag, pitch_deg) tag,
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
};

struct Alias {
  std::string_view name;
  Form form;
};
constexpr std::array kAliases = {
    Alias{"crosspitched", Form::kCrossGabled},
    Alias{"half_hipped", Form::kHalfHipped},
    Alias{"side-hipped", Form::kSideHipped},
    Alias{"gable", Form::kGabled},
    Alias{"hip", Form::kHipped},
    Alias{"pitched", Form::kGabled},
    Alias{"lean_to", Form::kSkillion},
    Alias{"conical", Form::kCone},
};

}  // namespace

std::string_view name_of(Form form) { return kNames[static_cast<std::size_t>(form)]; }

std::optional<Form> form_named(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Form>(i);
  for (const Alias& alias : kAliases)
    if (alias.name == name) return alias.form;
  return std::nullopt;
}

}  // namespace citykiln::roofs
