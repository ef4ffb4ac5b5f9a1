#include "grammars/roofs/roof_shape.h"

#include <array>
#include <cassert>

namespace citykiln::roofs {
namespace {

constexpr std::array<FormRow, static_cast<std::size_t>(Form::kCount)> kForms = {{
#define ROOF_FORM(enumerator, tag, pitch_deg, method, end, has_eaves) {tag, pitch_deg, method, end, has_eaves},
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
}};

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

const FormRow& form_row(Form form) {
  assert(form < Form::kCount);
  return kForms[static_cast<std::size_t>(form)];
}

std::string_view name_of(Form form) { return form_row(form).name; }

std::optional<Form> form_named(std::string_view name) {
  for (std::size_t i = 0; i < kForms.size(); ++i)
    if (kForms[i].name == name) return static_cast<Form>(i);
  for (const Alias& alias : kAliases)
    if (alias.name == name) return alias.form;
  return std::nullopt;
}

}  // namespace citykiln::roofs
