#include "lang/check/symbols.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "lang/text/ascii.h"

namespace rob::lang {
namespace {

bool is_channel_of(const Symbol& channel, std::string_view word) {
  return channel_word(channel.output, channel.analog) == word;
}

}  // namespace

Scopes::Scopes(std::deque<Symbol>& symbols, const RobotSignature& robot)
    : symbols_(symbols), files_(kMostUsedFiles + 1) {
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
  provide(Reading::HitPose, Type::pose());
  provide(Reading::Force, Type::vec(kForce));
  provide(Reading::Torque, Type::vec(kTorque));
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
  for (std::size_t i = top_only_ ? 2 : scopes_.size(); i > 0; --i) {
    if (i == 1) {
      if (const Symbol* const found = find_used(key)) return found;
    }
    const Scope& scope = scopes_[i - 1];
    if (const auto found = scope.find(key); found != scope.end()) return found->second;
  }
  return nullptr;
}

/// Among the names of the files that the current one USEs; with a point, of the one before it.
const Symbol* Scopes::find_used(const std::string& key) const {
  const std::size_t point = key.find('.');
  for (const UsedFile& used : files_[file_].used) {
    if (point != std::string::npos && to_upper(used.name) != key.substr(0, point)) continue;
    const Scope& names = names_of(used.file);
    const auto found = names.find(point == std::string::npos ? key : key.substr(point + 1));
    if (found != names.end()) return found->second;
  }
  return nullptr;
}

std::uint32_t Scopes::enter_file(std::uint32_t file) {
  scopes_[1].swap(files_[file_].parked);
  scopes_[1].swap(files_[file].parked);
  return std::exchange(file_, file);
}

void Scopes::use(const std::string& name, std::uint32_t file) {
  if (!is_file(name)) files_[file_].used.push_back({name, file});
}

bool Scopes::is_file(std::string_view name) const {
  return std::ranges::any_of(files_[file_].used,
                             [&](const UsedFile& used) { return same_word(used.name, name); });
}

std::vector<std::string> Scopes::files_with(std::string_view name) const {
  std::vector<std::string> files;
  if (files_[file_].used.empty()) return files;
  const std::string key = to_upper(name);
  for (std::size_t i = 1; i < scopes_.size(); ++i) {
    if (scopes_[i].contains(key)) return files;
  }
  for (const UsedFile& used : files_[file_].used) {
    if (names_of(used.file).contains(key)) files.push_back(used.name);
  }
  return files;
}

std::vector<const Symbol*> Scopes::shared_with(std::uint32_t file) const {
  std::vector<const Symbol*> shared;
  for (const auto& [key, symbol] : scopes_[1]) {
    if (names_of(file).contains(key)) shared.push_back(symbol);
  }
  return shared;
}

std::vector<std::string_view> Scopes::names_in(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const UsedFile& used : files_[file_].used) {
    if (!same_word(used.name, name)) continue;
    for (const auto& [key, symbol] : names_of(used.file)) names.push_back(symbol->name);
  }
  return names;
}

const Symbol* Scopes::frame_of(const TypeDetail* detail) const {
  const auto found = frames_.find(detail);
  return found == frames_.end() ? nullptr : found->second;
}

const Symbol* Scopes::find_global(std::string_view name) const {
  if (scopes_.size() < 2) return nullptr;
  const std::string key = to_upper(name);
  const auto found = scopes_[1].find(key);
  return found == scopes_[1].end() ? find_used(key) : found->second;
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

const Symbol* Scopes::hide(const Type& type) {
  Symbol symbol;
  symbol.type = type;
  symbol.global = true;
  symbol.id = symbols_.size();
  symbols_.push_back(std::move(symbol));
  return &symbols_.back();
}

std::vector<std::string_view> Scopes::visible() const {
  std::vector<std::string_view> names;
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    for (const auto& [key, symbol] : *scope) names.push_back(symbol->name);
  }
  for (const UsedFile& used : files_[file_].used) {
    for (const auto& [key, symbol] : names_of(used.file)) names.push_back(symbol->name);
  }
  return names;
}

}  // namespace rob::lang
