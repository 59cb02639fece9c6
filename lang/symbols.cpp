#include "lang/symbols.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "lang/ascii.h"

namespace rob::lang {
namespace {

bool is_channel_of(const Symbol& channel, std::string_view word) {
  return channel_word(channel.output, channel.analog) == word;
}

}  // namespace

Scopes::Scopes(std::deque<Symbol>& symbols, const RobotSignature& robot) : symbols_(symbols) {
  enter();
  Symbol pi;
  pi.kind = Symbol::Kind::BuiltIn;
  pi.name = "PI";
  pi.type = Type::real();
  pi.value = std::numbers::pi;
  declare(std::move(pi));
  Symbol hit;
  hit.kind = Symbol::Kind::BuiltIn;
  hit.name = "HIT";
  hit.type = Type::boolean();
  declare(std::move(hit));
  Symbol world;
  world.kind = Symbol::Kind::BuiltIn;
  world.name = "world";
  world.type = {Type::Kind::Frame};
  world.value = std::vector<double>{0, 0, 0, 1, 0, 0, 0};
  declare(std::move(world));
  provide(Reading::Clock, Type::real(kTime));
  provide(Reading::Here, Type::pose());
  provide(Reading::Target, Type::pose());
  for (std::size_t i = 0; i < robot.signals.size(); ++i) {
    Symbol signal;
    signal.kind = Symbol::Kind::Signal;
    signal.name = shown_name(robot.signals[i]);
    signal.analog = robot.signals[i].analog;
    signal.type = signal.analog ? Type::real(kVoltage) : Type::boolean();
    signal.high = kMostVolts;
    signal.signal = static_cast<int>(i);
    signal.output = robot.signals[i].output;
    signal.channel = robot.signals[i].channel;
    if (!robot.signals[i].name.empty()) {
      channels_.push_back(declare(std::move(signal)));
    } else {
      signal.id = symbols_.size();
      symbols_.push_back(std::move(signal));
      channels_.push_back(&symbols_.back());
    }
  }
}

void Scopes::provide(Reading reading, const Type& type) {
  Symbol symbol;
  symbol.kind = Symbol::Kind::Reading;
  symbol.name = name_of(reading);
  symbol.type = type;
  symbol.reading = reading;
  declare(std::move(symbol));
}

const Symbol* Scopes::channel(std::string_view word, std::int64_t number) const {
  for (const Symbol* const channel : channels_) {
    if (is_channel_of(*channel, word) && channel->channel == number) return channel;
  }
  return nullptr;
}

std::int64_t Scopes::channels(std::string_view word) const {
  return std::ranges::count_if(
      channels_, [&](const Symbol* channel) { return is_channel_of(*channel, word); });
}

const Symbol* Scopes::find(std::string_view name) const {
  const std::string key = to_upper(name);
  const auto innermost = top_only_ ? scopes_.rend() - 2 : scopes_.rbegin();
  for (auto scope = innermost; scope != scopes_.rend(); ++scope) {
    if (const auto found = scope->find(key); found != scope->end()) return found->second;
  }
  return nullptr;
}

const Symbol* Scopes::find_global(std::string_view name) const {
  if (scopes_.size() < 2) return nullptr;
  const auto found = scopes_[1].find(to_upper(name));
  return found == scopes_[1].end() ? nullptr : found->second;
}

const Symbol* Scopes::find_innermost(std::string_view name) const {
  const auto found = scopes_.back().find(to_upper(name));
  return found == scopes_.back().end() ? nullptr : found->second;
}

bool Scopes::provided(std::string_view name) const {
  return scopes_.front().contains(to_upper(name));
}

const Symbol* Scopes::declare(Symbol symbol) {
  symbol.id = symbols_.size();
  symbols_.push_back(std::move(symbol));
  const Symbol* const declared = &symbols_.back();
  scopes_.back()[to_upper(declared->name)] = declared;
  return declared;
}

std::vector<std::string_view> Scopes::visible() const {
  std::vector<std::string_view> names;
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    for (const auto& [key, symbol] : *scope) names.push_back(symbol->name);
  }
  return names;
}

}  // namespace rob::lang
