#include "runtime/prompt/pendant_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rob::runtime {

namespace {

using lang::JogFrame;
using Keys = std::vector<std::string>;

void add_moving_keys(const Pendant& pendant, Keys& keys) {
  constexpr std::array kArrows = {"← →", "↓ ↑", "PgDn PgUp"};
  const std::vector<std::string> coordinates = pendant.coordinates();
  for (std::size_t i = 0; i < std::min(coordinates.size(), kArrows.size()); ++i)
    keys.push_back(fmt::format("{} {}", kArrows[i], coordinates[i]));
  const std::string& chosen = coordinates.at(pendant.chosen());
  keys.push_back(fmt::format("1-{}, - + {}", coordinates.size(), chosen));
}

void add_frame_keys(const Pendant& pendant, Keys& keys) {
  constexpr std::array kFrames = {std::pair{JogFrame::Joint, "j joint"},
                                  std::pair{JogFrame::World, "w world"},
                                  std::pair{JogFrame::Tool, "t tool"}};
  std::string others;
  for (const auto& [frame, key] : kFrames) {
    if (frame == pendant.frame() || !pendant.has(frame)) continue;
    others += (others.empty() ? "" : " ") + std::string(key);
  }
  if (!others.empty()) keys.push_back(others);
}

/// Two keys for less and more: those that still change something.
void add_pair(char less, bool least, char more, bool most, const char* what, Keys& keys) {
  keys.push_back(least  ? fmt::format("{} {}", more, what)
                 : most ? fmt::format("{} {}", less, what)
                        : fmt::format("{} {} {}", less, more, what));
}

const char* style_key(const Pendant& pendant) {
  if (pendant.style() != Pendant::Style::Step) return "m steps";
  return pendant.releases() ? "m hold" : "m pulses";
}

void add_output_keys(const Pendant& pendant, Keys& keys) {
  if (pendant.can_set("lift")) keys.emplace_back("l lift");
  if (pendant.can_set("gripper")) keys.emplace_back("g gripper");
  if (pendant.outputs() > 0) keys.emplace_back("o out");
}

}  // namespace

std::vector<std::string> acting_keys(const Pendant& pendant) {
  if (pendant.naming()) return {"Enter teaches", "Esc does not"};
  if (pendant.choosing_output())
    return {fmt::format("1-{} the output", pendant.outputs()), "Esc none"};
  Keys keys;
  if (pendant.can_move()) {
    add_moving_keys(pendant, keys);
    if (pendant.moving() && pendant.style() == Pendant::Style::Pulse) return keys;
    add_frame_keys(pendant, keys);
    add_pair('[', pendant.slowest(), ']', pendant.fastest(), "speed", keys);
    if (pendant.style() == Pendant::Style::Step)
      add_pair(',', pendant.smallest_step(), '.', pendant.largest_step(), "step", keys);
    keys.emplace_back(style_key(pendant));
    add_output_keys(pendant, keys);
  }
  if (pendant.can_teach()) keys.emplace_back("p teach");
  keys.emplace_back("Esc leave");
  return keys;
}

}  // namespace rob::runtime
