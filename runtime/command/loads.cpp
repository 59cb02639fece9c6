#include "runtime/command/loads.h"

#include "runtime/words/pose_values.h"

namespace rob::runtime {

using lang::Reply;

void Loads::mount(const lang::ToolValue& tool) {
  book_.mount(motion::ArmLoad::point(tool.mass, eigen_of(tool.cog)));
}

void Loads::grasp(const lang::LoadCommand& load) {
  book_.grasp(motion::ArmLoad::point(load.mass, eigen_of(load.cog)));
}

bool Loads::known() {
  if (!book_.doubted()) return true;
  if (!progress_.has_acted()) return false;
  book_.take_up(links_.channels.carried.load(std::memory_order_acquire));
  plan_with_last();
  return true;
}

Reply Loads::tell(int line) {
  if (!known()) return Reply::Later;
  if (!book_.news()) return Reply::Done;
  if (effects_.full()) return Reply::Later;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Load;
  effect.carried = book_.tell();
  links_.planner.carry(effect.carried->all());
  return effects_.queue(effect);
}

}  // namespace rob::runtime
