#include "lang/code/frame_slots.h"

#include <algorithm>

namespace rob::lang {

Register FrameSlots::Stack::take(int count) {
  const int first = used;
  used += count;
  most = std::max(most, used);
  return static_cast<Register>(std::min(first, kMostRegisters - 1));
}

void FrameSlots::release(const Mark& mark) {
  memory_ = mark.memory;
  registers_.numbers.used = mark.numbers;
  registers_.texts.used = mark.texts;
  while (live_names_.size() > mark.names) {
    names_[live_names_.back()].to = static_cast<std::uint32_t>(code_.size());
    live_names_.pop_back();
  }
}

void FrameSlots::name_register(const std::string& name, Register index, bool text) {
  const auto now = static_cast<std::uint32_t>(code_.size());
  live_names_.push_back(names_.size());
  names_.push_back({.name = name, .index = index, .text = text, .from = now, .to = now});
}

void FrameSlots::begin_behind(const Room& room) {
  auto& [numbers, texts] = registers_;
  numbers.used = std::max(numbers.used, room.numbers);
  texts.used = std::max(texts.used, room.texts);
  numbers.most = std::max(numbers.most, numbers.used);
  texts.most = std::max(texts.most, texts.used);
  take_memory({std::max(room.memory.numbers - memory_.numbers, 0),
               std::max(room.memory.texts - memory_.texts, 0)},
              {});
}

bool FrameSlots::has_room(Slots slots) const {
  return registers_.numbers.used + slots.numbers <= kVariableRegisters &&
         registers_.texts.used + slots.texts <= kVariableRegisters;
}

Slots FrameSlots::take_memory(Slots slots, Place place) {
  const Slots first = memory_;
  // Each part is within kMemory, so this many of them cannot overflow before the code is given up.
  memory_ = memory_ + slots;
  if (memory_.numbers > kMemory.numbers || memory_.texts > kMemory.texts) {
    limits_.exceed(Limit::Memory, place);
    memory_ = first;
  }
  most_memory_ = {std::max(most_memory_.numbers, memory_.numbers),
                  std::max(most_memory_.texts, memory_.texts)};
  return first;
}

void FrameSlots::put_aside() {
  aside_ = registers_;
  registers_ = {};
}

void FrameSlots::begin() {
  registers_ = {};
  memory_ = most_memory_ = {};
  memory_register_.reset();
}

}  // namespace rob::lang
