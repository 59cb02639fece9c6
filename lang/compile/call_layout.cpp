#include "lang/compile/call_layout.h"

#include <algorithm>

#include "lang/check/meaning.h"

namespace rob::lang {

CallLayout layout_of(const Routine& routine) {
  CallLayout layout;
  const auto places = [&layout](Slots slots) {
    Location home{{SlotsAt::Base::Place}, {SlotsAt::Base::Place}};
    if (slots.numbers > 0) home.numbers.place = static_cast<Register>(layout.registers++);
    if (slots.texts > 0) home.texts.place = static_cast<Register>(layout.registers++);
    return home;
  };
  for (const Parameter& parameter : parameters_of(routine)) {
    const Slots slots = slots_of(parameter.group->type);
    Location home;
    if (parameter.group->by_reference || !parameter.group->type.in_registers()) {
      home = places(slots);
      if (parameter.group->type.is_open()) home.count = static_cast<Register>(layout.registers++);
    } else {
      home.numbers.offset = static_cast<std::uint32_t>(layout.registers);
      home.texts.offset = static_cast<std::uint32_t>(layout.text_registers);
      layout.registers += slots.numbers;
      layout.text_registers += slots.texts;
    }
    layout.homes.push_back(home);
  }
  const Slots result = slots_of(routine.result);
  if (!routine.result.in_registers()) {
    layout.result = places(result);
    return layout;
  }
  layout.registers = std::max(layout.registers, result.numbers);
  layout.text_registers = std::max(layout.text_registers, result.texts);
  return layout;
}

}  // namespace rob::lang
