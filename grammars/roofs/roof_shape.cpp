#include "grammars/roofs/roof_shape.h"

#include <array>
#include <cassert>

namespace citykiln::roofs {
namespace {

constexpr std::array<FormRow, static_cast<std::size_t>(RoofForm::kCount)> kForms = {{
#define ROOF_FORM(enumerator, tag, pitch_deg, method, end, has_eaves) {tag, pitch_deg, method, end, has_eaves},
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
}};

struct Alias {
  std::string_view name;
  RoofForm form;
};
constexpr std::array kAliases = {
    Alias{"crosspitched", RoofForm::kCrossGabled},
    Alias{"half_hipped", RoofForm::kHalfHipped},
    Alias{"side-hipped", RoofForm::kSideHipped},
    Alias{"gable", RoofForm::kGabled},
    Alias{"hip", RoofForm::kHipped},
    Alias{"pitched", RoofForm::kGabled},
    Alias{"lean_to", RoofForm::kSkillion},
    Alias{"conical", RoofForm::kCone},
};

}  // namespace

const FormRow& form_row(RoofForm form) {
  assert(form < RoofForm::kCount);
  return kForms[static_cast<std::size_t>(form)];
}

std::string_view name_of(RoofForm form) { return form_row(form).name; }

std::optional<RoofForm> form_named(std::string_view name) {
  for (std::size_t i = 0; i < kForms.size(); ++i)
    if (kForms[i].name == name) return static_cast<RoofForm>(i);
  for (const Alias& alias : kAliases)
    if (alias.name == name) return alias.form;
  return std::nullopt;
}

}  // namespace citykiln::roofs
