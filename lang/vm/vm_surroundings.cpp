#include <string>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/percent_text.h"
#include "lang/values/pose_slots.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that keep what WITH, PRESS and OVERRIDE say. When a block is left, by its
/// end, EXIT, RETURN (the compiler) or an error (Vm::rescue()), they restore what held before it.
namespace rob::lang {

Setting Vm::setting() const { return settings_.empty() ? Setting{} : settings_.back(); }

/// What is not named stays what it is around the block.
void Vm::enter_setting(Code pc) {
  Setting setting = this->setting();
  const Slot* next = &numbers_[pc->a()];
  if ((pc->b() & 1U) != 0) {
    setting.tool = load_tool(next);
    next += kToolSlots;
  }
  if ((pc->b() & 2U) != 0) setting.frame = load_pose(next);
  if ((pc->b() & 6U) != 0) setting.in_tool = (pc->b() & 4U) != 0;
  settings_.push_back(setting);
  machine_->work_in(line(pc), setting);
}

void Vm::leave_settings(int line, std::size_t kept) {
  if (settings_.size() == kept) return;
  settings_.resize(kept);
  machine_->work_in(line, setting());
}

PressCommand Vm::press_of(Code pc) const {
  const Slot* const slots = &numbers_[pc->a()];
  return {.axis = pc->b(), .force = slots[0].real, .limit = slots[1].real};
}

Reply Vm::end_presses(int line, std::size_t kept) {
  while (presses_ > kept) {
    const Reply reply = machine_->end_press(line);
    if (reply == Reply::Later) return reply;
    --presses_;
    if (reply == Reply::Refused) return reply;
  }
  return Reply::Done;
}

bool Vm::check_press(Code pc) {
  const double limit = press_of(pc).limit;
  if (limit >= 0) return true;
  error_ = {.code = std::string(code::kClauseOutOfRange),
            .place = place(pc),
            .message = fmt::format("LIMIT turned out to be {}; it has to be above zero",
                                   number_text(limit, kSpeed)),
            .help = ""};
  return false;
}

bool Vm::check_override(Code pc, double share) {
  if (share > 0 && share <= kMostOverride) return true;
  error_ = {.code = std::string(code::kOverrideBeyond),
            .place = place(pc),
            .message = fmt::format("OVERRIDE turned out to be {}; it is above 0% and at most 200%",
                                   percent_text(share)),
            .help = std::string(override_help(share))};
  return false;
}

/// Without COG it is where the tip of the tool is.
LoadCommand Vm::load_of(Code pc) const {
  const Slot* const slots = &numbers_[pc->a()];
  return {slots[0].real, pc->b() != 0 ? load_vector(slots + 1) : setting().tool.tip.position};
}

bool Vm::check_load(Code pc) {
  const double mass = load_of(pc).mass;
  if (mass >= 0 && mass <= kMostLoad) return true;
  error_ = {.code = std::string(code::kLoadBeyond),
            .place = place(pc),
            .message = fmt::format("LOAD turned out to be {}; it is 0kg or more and at most {}",
                                   number_text(mass, kMass), number_text(kMostLoad, kMass)),
            .help = "LOAD 0kg lets go"};
  return false;
}

}  // namespace rob::lang
